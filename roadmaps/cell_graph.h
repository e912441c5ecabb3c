// The cells of a grid maze as a roadmap: what a search on a grid sees of the plane. For comparison with the exact
// answer.
#pragma once
#include <optional>
#include <vector>

#include <taut/geometry/free_space.h>
#include <taut/roadmaps/roadmap.h>

namespace taut {

/// Square cells in columns and rows: cell (x, y) is the box from corner + side * (x, y) to corner + side * (x + 1, y +
/// 1).
struct CellLattice {
  Point corner;
  double side = 1;
  int width = 0;
  int height = 0;

  Point centre(Cell c) const { return {corner.x + (c.x + 0.5) * side, corner.y + (c.y + 0.5) * side}; }
  bool contains(Cell c) const { return c.x >= 0 && c.y >= 0 && c.x < width && c.y < height; }
  /// The cells whose closed box contains p: up to four when p lies on sides; none beyond the lattice.
  std::vector<Cell> cells_at(Point p) const;

  friend bool operator==(const CellLattice&, const CellLattice&) = default;
};

/// The cells that the world's walls stand between.
///
///  1. A world from a grid has the grid's cells. Any other has cells of side 1, placed by its walls: posts at whole or
///     at half numbers, or anywhere else, as long as all agree. Without walls the box' corner is a post.
///  2. The walls (their centre lines) are axis-parallel and end at posts, exactly; the world is one box whose sides run
///     along the lattice, but for half a wall's thickness; there are no solids.
///  3. At most 10^8 cells.
/// Throws InputError, with the wall and its line, for a world that is not so. O(walls).
CellLattice cell_lattice(const World& world);

/// Which cells are neighbours.
enum class CellNeighbours {
  four,   ///< east, north, west, south
  eight,  ///< the diagonal ones as well
};

/// The graph of cells, and how a point joins it.
///
///  1. Vertices: the centres at which the robot can stand, column by column, from the south.
///  2. Edges: neighbouring centres that see each other (FreeSpace::sees), exactly. A diagonal may touch the end of a
///     wall at a post, as any path may; it does not pass a post that has walls on both sides of the line.
///  3. Paths on it are free, and hardly ever shortest. Where walls are thin and the robot is a point, the graph is
///     connected where the free space is.
/// Throws InputError when the world has no cells (cell_lattice). O(cells) questions to the free space.
class CellGraph {
 public:
  explicit CellGraph(FreeSpace space, CellNeighbours neighbours = CellNeighbours::four);
  /// From the roadmap of another CellGraph of the same world and footprint, as a file keeps it; asks the free space
  /// nothing about edges. Throws InputError when its vertices are not the cells' centres.
  CellGraph(FreeSpace space, CellNeighbours neighbours, Roadmap roadmap);

  const FreeSpace& space() const { return space_; }
  const CellLattice& lattice() const { return lattice_; }
  CellNeighbours neighbours() const { return neighbours_; }
  const Roadmap& roadmap() const { return roadmap_; }

  /// kNone outside the lattice and where the robot cannot stand in the cell's middle.
  Roadmap::Vertex vertex_of(Cell c) const;

  /// The vertices that p joins by a straight free leg, ascending: the cells that contain p, as far as p sees their
  /// centres; if it sees none of them, the nearest centre that it sees, the first among equals. Empty when it sees none
  /// at all. Precondition: p is not outside. O(1) questions to the free space as a rule, at worst O(cells).
  std::vector<Roadmap::Vertex> joined_to(Point p) const;

 private:
  std::vector<Point> number_cells();  // the vertices, in order
  std::optional<Roadmap::Vertex> nearest_seen(Point p) const;

  FreeSpace space_;
  CellNeighbours neighbours_;
  CellLattice lattice_;
  std::vector<Roadmap::Vertex> vertex_of_cell_;  // by column, then row
  Roadmap roadmap_;
};

}  // namespace taut
