// What was joined in a world, and what nearly touches, as JSON.
#pragma once

#include <vector>

#include <taut/geometry/snap.h>
#include <taut/io/results/json.h>

namespace taut {

/// {"tolerance", "joined", "displacement", "remaining": as near_json}
Json snap_json(const SnapReport& report);

/// [{"end": [x, y], "wall": [[x1, y1], [x2, y2]], "distance", "line", "wall_line"}, ...]; lines of the input, null when
/// unknown.
Json near_json(const std::vector<NearContact>& contacts);

}  // namespace taut
