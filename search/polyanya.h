// Euclidean shortest paths on a navigation mesh, without a graph.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <taut/geometry/free_space.h>
#include <taut/roadmaps/navmesh.h>
#include <taut/search/graph_search.h>
#include <taut/search/path.h>

namespace taut {

struct CellNavmesh;
class CellPolygons;

namespace detail {
struct BendGraph;
class Landmarks;
class Sleeves;
}  // namespace detail

/// A free space with its navigation mesh, ready for any number of queries. Immutable, cheap to copy, for any number of
/// threads.
///
/// What it finds is what the visibility graph finds, of exactly the same length, without building one: a first query
/// costs the mesh (a small part of what the FreeSpace took) and the search.
class Polyanya {
 public:
  explicit Polyanya(FreeSpace space);
  /// On a mesh of the same space. With one of navmesh_between only the ends that it was made for may be asked.
  Polyanya(FreeSpace space, Navmesh mesh);

  /// For these ends only: on the cells of the space, which then needs no triangles (cell_navmesh_between), or else on
  /// navmesh_between. The quickest way to a single path.
  static Polyanya between(const FreeSpace& space, Point from, const Goal& to);

  const FreeSpace& space() const { return space_; }
  const Navmesh& mesh() const { return *mesh_; }

  /// The same with a table of distances from `count` far places, for thousands of queries on a world in which paths
  /// wind: searches for a single goal then look at a fraction of the nodes. Lengths stay the same, exactly. Takes count
  /// + 1 searches over the whole mesh; 4 * count bytes a bend.
  Polyanya with_landmarks(std::size_t count = 8) const;
  bool has_landmarks() const { return landmarks_ != nullptr; }

  /// The same with the reduced visibility graph of the space, for thousands of queries: searches from point to point
  /// then go from bend to bend, along legs that turn around obstacles. With landmarks as well each looks at little more
  /// than its path. Lengths stay the same, exactly. Takes what VisibilityGraph takes; 64 bytes an edge. Precondition:
  /// not made by between().
  Polyanya with_graph() const;
  bool has_graph() const { return bends_ != nullptr; }

 private:
  friend class PolyanyaSearch;

  Polyanya(FreeSpace space, CellNavmesh mesh);

  FreeSpace space_;
  std::shared_ptr<const Navmesh> mesh_;
  std::shared_ptr<const CellPolygons> cells_;       // where the mesh is made of cells
  std::shared_ptr<const detail::Sleeves> sleeves_;  // of a mesh that is made for many queries
  std::shared_ptr<const detail::Landmarks> landmarks_;
  std::shared_ptr<const detail::BendGraph> bends_;
};

/// One query after the other in the same memory: once that has grown nothing is allocated. One thread at a time.
///
///  1. Shortest among all paths (docs/definitions.md, 2): a path may touch walls, run along them and turn around
///     their free ends, and passes no point where two obstacles touch. Lengths are compared exactly; of paths equally
///     long one is chosen, always the same.
///  2. Ends may lie anywhere a robot can be: on walls, corners, portals. A start on a thin wall may leave to both
///     sides.
///  3. `none` is proven, at once where start and goal lie in different components.
///  4. A room is entered where graph search enters it (search/shortest_path.h).
/// Throws InputError when an end is no place for the robot.
///
/// Cost: a node of the search is a cone of sight through a portal. Only the part of the mesh that lies between start
/// and goal is entered: what hangs on it by a single polygon (dead ends, side rooms) is not looked at. In a maze
/// without loops that is the corridor alone, and a string pulled taut along it instead of a search.
/// Source: Cui, Harabor, Grastien, "Compromise-free Pathfinding on a Navigation Mesh" (IJCAI 2017). Different here:
/// ends of intervals are rays through corners and are never rounded; roots are sectors of vertices; turns are queued of
/// their own.
class PolyanyaSearch {
 public:
  explicit PolyanyaSearch(Polyanya polyanya);
  PolyanyaSearch(PolyanyaSearch&&) noexcept;
  PolyanyaSearch& operator=(PolyanyaSearch&&) noexcept;
  ~PolyanyaSearch();

  /// The shortest path; afterwards the questions below are about it.
  SearchStatus find(Point from, Point to, const SearchLimits& limits = {});
  SearchStatus find(Point from, const Goal& to, const SearchLimits& limits = {});
  /// To the nearest of several goals; those that are no place for the robot are left out.
  SearchStatus find_nearest(Point from, std::span<const Point> goals, const SearchLimits& limits = {});

  /// Of the path found; empty when there is none. The points from start to goal.
  const std::vector<Point>& points() const;
  /// Its length, to within a few roundings; Length(points()) is exact. Infinite when there is none.
  double length() const;
  /// Which goal it ends in: of find_nearest.
  std::size_t goal() const;
  std::size_t expanded() const;   ///< nodes taken from the queue, the start included
  std::size_t generated() const;  ///< nodes ever made

  /// Status, path with its exact length and counts.
  GraphSearchResult result() const;

  /// The shortest paths to each of the goals, in their order, in one search; nothing where there is none. Goals that
  /// are no place for the robot have none.
  std::vector<std::optional<Path>> find_each(Point from, std::span<const Point> goals);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// One query, in memory of its own.
GraphSearchResult shortest_path(const Polyanya& polyanya, Point from, const Goal& to, const SearchLimits& limits = {});

}  // namespace taut
