// A roadmap as JSON.
#pragma once

#include <optional>
#include <string>

#include <taut/roadmaps/roadmap.h>
#include <taut/search/prm_planner.h>

namespace taut {

/// One JSON object with a final newline; keys are stable:
///  program   "taut"
///  kind      as given, for example "reduced visibility graph"
///  source    the input file's name
///  seconds   how long it took to build
///  prm       as in result_json, of a PRM that was grown for a query
///  vertices  [[x, y], ...]; numbers read back as the same double. Several may lie at one point
///  edges     [[u, v], ...], u < v, ascending; indices into vertices, from 0
/// Bytes of names that are no UTF-8 become U+FFFD. About 20 bytes an edge.
std::string roadmap_json(const Roadmap& roadmap, const std::string& kind, const std::string& source, double seconds,
                         const std::optional<PrmConnectivity>& prm = std::nullopt);

}  // namespace taut
