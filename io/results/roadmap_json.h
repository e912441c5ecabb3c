// A roadmap as JSON.
#pragma once

#include <optional>
#include <string>

#include <taut/io/results/json.h>
#include <taut/roadmaps/roadmap.h>
#include <taut/search/prm_planner.h>

namespace taut {

/// One JSON object; keys are stable:
///  kind      as given, for example "reduced visibility graph"
///  prm       prm_json, of a PRM that was grown for a query
///  vertices  [[x, y], ...]; numbers read back as the same double. Several may lie at one point
///  edges     [[u, v], ...], u < v, ascending; indices into vertices, from 0
/// About 20 bytes an edge.
Json roadmap_json(const Roadmap& roadmap, const std::string& kind,
                  const std::optional<PrmConnectivity>& prm = std::nullopt);

}  // namespace taut
