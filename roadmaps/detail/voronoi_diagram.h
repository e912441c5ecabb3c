// The segment Voronoi diagram of pieces that meet only at end points, by CGAL's segment Delaunay graph. Private.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <taut/geometry/free_space.h>
#include <taut/geometry/progress.h>
#include <taut/roadmaps/detail/voronoi_geometry.h>

namespace taut::detail {

/// The finite part of the diagram, without the edges between a piece and its own end, edges of length 0 contracted.
struct VoronoiDiagram {
  struct Edge {
    std::uint32_t from = 0;
    std::uint32_t to = 0;
    std::array<std::uint32_t, 2> sites{};
  };

  std::vector<Segment> sites;                      ///< the pieces, in their order, then their end points, sorted
  std::vector<std::array<std::uint32_t, 2>> ends;  ///< of each piece, a and b, numbered from the first end point
  std::vector<VoronoiPoint> vertices;
  std::vector<Edge> edges;
};

/// Which edges have length 0 is decided exactly. Deterministic. Precondition: pieces meet only at end points. O(n log
/// n) expected.
VoronoiDiagram voronoi_diagram(std::span<const Constraint> pieces, const TellProgress& tell = {});

}  // namespace taut::detail
