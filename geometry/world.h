// What stands where, before any robot is chosen.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <taut/geometry/errors.h>
#include <taut/geometry/grid_maze.h>
#include <taut/geometry/point.h>

namespace taut {

struct OccupancyGrid;
namespace detail {
class Raster;
}

/// A straight wall. With thickness t > 0 it is the rectangle around the segment, t wide, reaching t/2 past both ends
/// (so walls that share an end point leave no gap); a zero-length wall with t > 0 is an axis-parallel t x t post.
/// With t = 0 it is the segment itself: a path may touch it, run along it and turn around its free end.
struct Wall {
  Point a;
  Point b;
  double thickness = 0;
  int line = 0;  ///< where the input file says so, from 1; 0: unknown
};

/// A polygon and where it came from. Any orientation; World takes it as mend_rings (mend_rings.h) says.
struct Area {
  Polygon polygon;
  int line = 0;
};

/// Where a path ends: a point, or a room. A room is a set of closed boxes; the path ends where it first enters one.
struct Goal {
  std::optional<Point> point;
  std::vector<Box> room;
};

/// How the boundary came about.
enum class Boundary {
  walled,  ///< the areas are floor plans: what lies outside them is solid
  limit,   ///< a limit only: where no wall stands on it, it is an opening: one may stand on it, not leave through it
  open,    ///< the input knows no boundary: a box wide enough to go around everything
};

/// The parts of a World, unchecked. Readers fill this in.
struct WorldParts {
  std::string source;       ///< file name for messages; may be empty
  std::vector<Area> areas;  ///< the union of these is where the world is; empty: a box, see guarantee 3 of World
  Boundary boundary = Boundary::limit;  ///< of `areas`; World decides between `limit` and `open` when areas is empty
  std::vector<Wall> walls;
  std::vector<Area> solids;  ///< may touch and overlap each other and the boundary; holes are free
  std::optional<Point> start;
  Goal goal;
  std::shared_ptr<const GridMaze> grid;  ///< the grid it came from, when there was one
  bool y_down = false;     ///< the format's own y grows downwards, so pictures show it that way; nothing else asks
  double uncertainty = 0;  ///< how far from where it was meant a place may lie: computed numbers, joined walls (snap.h)
};

/// An immutable, checked world.
///
/// Guarantees after construction:
///  1. every coordinate and thickness is 0 or of magnitude kSmallest to kLargest, thicknesses are >= 0;
///  2. every ring has at least 3 distinct vertices, non-zero area, no two sides cross or overlap, no vertex lies on
///     another side; repeated consecutive vertices are dropped; outer rings are counter-clockwise, holes clockwise;
///  3. `areas` is not empty. Where the input gave none, no end lies beyond the outer face of the walls, and the walls
///     cover enough of it, that face (Boundary::limit): their bounding box or a turned rectangle around them, one side
///     along its hull, if at least half is covered; their convex hull, if three quarters are. Wall ends no farther
///     from a turned side than `uncertainty` lie on it. Else a box around everything, start and goal included, widened
///     on all sides (Boundary::open), so that a shortest path is never hindered by it;
///  4. zero-length walls of zero thickness are dropped (a path may touch a point, so they hinder nobody); count in
///     `dropped_walls`;
///  5. no start and no goal, Boundary::limit, and exactly two openings: start and goal are their midpoints, the
///     lexicographically smaller one is the start, and a sloped opening bends to where doubles have its midpoint;
///  6. no box of the goal room reaches beyond box(): what does is cut off, and a room of which nothing is left refused.
/// Throws InputError naming source, line and culprit. Time O(n log n).
class World {
 public:
  /// Coordinates up to this magnitude are read; beyond it products would leave the range of double.
  static constexpr double kLargest = 1e75;
  /// Nearer to 0 only 0 itself is: products of four coordinates, and the squares of what such coordinates differ by,
  /// keep all their digits. A world that is smaller altogether is written in a smaller unit.
  static constexpr double kSmallest = 1e-75;

  explicit World(WorldParts parts);
  /// What world_of(grid) makes (occupancy_world.h).
  World(OccupancyGrid grid, std::string source);

  const std::string& source() const { return parts_.source; }
  const std::vector<Area>& areas() const { return parts_.areas; }
  Boundary boundary() const { return parts_.boundary; }
  const std::vector<Wall>& walls() const { return parts_.walls; }
  /// Of a raster they are traced when they are first asked for.
  const std::vector<Area>& solids() const;
  const std::optional<Point>& start() const { return parts_.start; }
  const Goal& goal() const { return parts_.goal; }
  const std::shared_ptr<const GridMaze>& grid() const { return parts_.grid; }

  /// The grid map that this is, cell (column, row) the box [column, column + 1] x [row, row + 1], with nothing else in
  /// it; nullptr: it came from elsewhere.
  const OccupancyGrid* raster() const;

  bool y_down() const { return parts_.y_down; }
  double uncertainty() const { return parts_.uncertainty; }

  /// As they were given, checked; without areas that are implied: World(parts()) is this world.
  WorldParts parts() const;

  /// The box around `areas`.
  Box box() const { return box_; }

  /// The maximal pieces of the outline of `areas` on which no wall stands, in order along each ring, for
  /// Boundary::limit; empty for the other kinds. Exact when walls and outline are axis-parallel or share end points.
  const std::vector<Segment>& openings() const { return openings_; }

  std::size_t dropped_walls() const { return dropped_walls_; }

  /// A copy with another start, goal (point) or wall thickness. An absent end stays as it is.
  World with_ends(std::optional<Point> start, std::optional<Point> goal) const;
  World with_wall_thickness(double thickness) const;

 private:
  void fit_area();  // an implied one, after a change
  void find_openings();

  WorldParts parts_;
  std::shared_ptr<const detail::Raster> raster_;  // instead of parts_.solids
  Box box_;
  std::vector<Segment> openings_;
  std::size_t dropped_walls_ = 0;
  bool implied_area_ = false;
};

/// The world of a grid maze: cell (x, y) is the box [x, x+1] x [y, y+1], scaled by `cell_size`; walls of one line are
/// merged into maximal runs; start is the middle of the start cell; goal is the room. A maze without goal and with
/// exactly two openings goes from the one to the other (guarantee 5).
World world_of(std::shared_ptr<const GridMaze> grid, double cell_size = 1, std::string source = {});

}  // namespace taut
