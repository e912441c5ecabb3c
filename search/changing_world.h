// Shortest paths while walls come and go.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include <taut/geometry/free_space.h>
#include <taut/search/graph_search.h>
#include <taut/search/index.h>

namespace taut {

/// A prepared world in which walls are added and taken away; each query is about the world as it is then. One thread at
/// a time.
///
///  1. Paths are those of a FreeSpace of the changed world, and as long: exactly, where rounding moved no crossing
///     (FreeSpaceReport::displacement), else to within that. Its outline stays what it was at the beginning.
///  2. Where the world is one of cells (FreeSpace::cells()) and the walls that come and go are thin and axis-parallel,
///     each change makes anew only what lies around the wall: what it meets, not the size of the world, says how long
///     it takes. The next query looks through the polygons once, to see which hang together. Nothing is triangulated.
///  3. Elsewhere: a wall that was added can only make paths longer. So what was prepared at first is asked as long as
///     nothing of it was taken away, and its path is the answer when no added wall touches it: O(legs * added walls)
///     then. Otherwise the changed world is prepared anew, once for all queries until the next change, and its parts
///     are what is asked from then on; an index is kept for the queries that it can still answer.
///  4. An index is stale once something that it knows was taken away; from then on it is not asked any more.
class ChangingWorld {
 public:
  explicit ChangingWorld(FreeSpace space);
  /// The index is asked while it holds.
  explicit ChangingWorld(Index index);
  ChangingWorld(ChangingWorld&&) noexcept;
  ChangingWorld& operator=(ChangingWorld&&) noexcept;
  ~ChangingWorld();

  /// Throws InputError when an end lies outside the box of the world's areas, or the thickness is negative.
  void add(const Wall& wall);

  /// Takes the stretch out of each wall that it lies on, whichever way round and however long the wall is; what is left
  /// of that stays. False when there is none. O(walls on its line).
  bool remove(const Segment& stretch);

  /// Throws InputError when an end is no place for the robot.
  SearchStatus find(Point from, Point to);

  /// Of the path found; empty when there is none.
  const std::vector<Point>& points() const;
  /// To within a few roundings; Length(points()) is exact. Infinite when there is none.
  double length() const;

  bool has_index() const;  ///< one that is not stale
  /// Is it one of cells as it is now? Then nothing is rounded: that no path was found proves that there is none.
  bool is_among_cells();
  /// How often a space of the changed world was made.
  std::size_t rebuilds() const;
  /// Of the world as it is now; prepared anew if need be. Valid until the next change.
  const FreeSpace& space();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace taut
