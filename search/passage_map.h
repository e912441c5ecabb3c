// How large a disc may be that gets from one place to anywhere.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <taut/search/passage_index.h>

namespace taut {

/// A face between walls and gates, and what gets into it.
struct PassageFace {
  Ring outline;                ///< counter-clockwise, walls that stand in it left out; rounded
  double radius = 0;           ///< of the largest disc that gets from the start across a gate into the face
  std::uint32_t gate = kNone;  ///< the bottleneck; kNone: there is none narrower than the start's own clearance
};

/// All faces that can be reached from the start, the widest first. Where there are no walls, or the start is on a wall
/// or outside, there are none. O(n).
std::vector<PassageFace> passage_map(const PassageIndex& index, Point start);

/// The largest disc that gets from the start to each cell's centre, and stands there: row by row from the top, 0 where
/// none does, outside too.
struct PassageRaster {
  std::size_t columns = 0, rows = 0;
  double side = 0;  ///< of a cell
  Point min;        ///< lower left corner
  std::vector<double> radii;
};
/// `cells` along the longer side of the world's box. Precondition: cells > 0.
PassageRaster passage_raster(const PassageIndex& index, Point start, std::size_t cells);

/// radii[i * n + j]: of the largest disc that gets from points[i] to points[j]; 0 where none does. On the diagonal:
/// that can be at points[i]. Symmetric.
std::vector<double> passage_matrix(const PassageIndex& index, std::span<const Point> points);

}  // namespace taut
