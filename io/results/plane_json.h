// Values of the plane as JSON, for everything that writes results. Points and segments: Json itself.
#pragma once

#include <taut/geometry/footprint.h>
#include <taut/geometry/world.h>
#include <taut/io/results/json.h>
#include <taut/search/barrier.h>
#include <taut/search/prm_planner.h>

namespace taut {

/// {"point": [x, y]}, {"room": [[xmin, ymin, xmax, ymax], ...]} or null.
Json goal_json(const Goal& goal);

/// {"kind": "point" | "disc" | "polygon", "radius": r (disc and square only)}
Json robot_json(const Footprint& robot);

/// {"samples", "vertices", "edges", "edges_tested", "components", "start_part", "goal_part"}; the parts are the
/// vertices that hang together with an end.
Json prm_json(const PrmConnectivity& prm);

/// {"walls": [[[x, y], [x, y]], ...], "gates": [{"posts", "width", "width_text"}, ...]}
Json barrier_json(const Barrier& barrier);

}  // namespace taut
