// Where the bends of a mesh begin and end. Private.
#pragma once

#include <taut/roadmaps/navmesh.h>

namespace taut::detail {

/// Finds each bend's corners along its constraints, once all sides know what lies across. O(corners).
inline void bound_bends(Navmesh& mesh) {
  for (std::uint32_t p = 0; p < mesh.polygon_count(); ++p)
    for (std::uint32_t c = mesh.first[p], before = mesh.first[p + 1] - 1; c < mesh.first[p + 1]; before = c++) {
      if (mesh.corners[c].bend == kNone) continue;
      Navmesh::Bend& bend = mesh.bends[mesh.corners[c].bend];
      if (mesh.corners[c].across == kNone) bend.right_corner = c;
      if (mesh.corners[before].across == kNone) bend.left_corner = c;
    }
}

}  // namespace taut::detail
