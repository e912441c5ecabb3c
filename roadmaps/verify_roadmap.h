// Is a roadmap that came from elsewhere, say from a file, one of this free space?
#pragma once

#include <optional>
#include <string>

#include <taut/geometry/free_space.h>
#include <taut/roadmaps/roadmap.h>

namespace taut {

/// The first thing wrong with a roadmap.
struct RoadmapFault {
  Roadmap::Vertex vertex = 0;
  bool is_row = false;  ///< the vertex' neighbours are wrong, not its place
  std::string text;     ///< one line: `vertex 3, (1, 2), lies in an obstacle or touches one`
};

/// Every vertex lies clear of all obstacles, and along every edge a path can go straight (FreeSpace::sees); so any
/// chain of edges is a path. Exact. What a PRM promises, whatever its samples were. O(V + E) questions to the free
/// space.
std::optional<RoadmapFault> verify_roadmap(const Roadmap& roadmap, const FreeSpace& space);

/// Where it differs from the roadmap that it should be: a vertex elsewhere, an edge too many, an edge missing. The
/// edges of the lowest vertex come first. O(V + E).
std::optional<RoadmapFault> difference(const Roadmap& roadmap, const Roadmap& wanted);

}  // namespace taut
