// A world prepared for queries of microseconds.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include <taut/geometry/free_space.h>
#include <taut/geometry/progress.h>
#include <taut/search/graph_search.h>

namespace taut {

namespace detail {
struct IndexParts;
}  // namespace detail

/// A free space and, for any two bends of it that a shortest path passes one after the other, their distance by way of
/// few hubs (docs/queries.md). Immutable, cheap to copy, for any number of threads.
///
/// Where all vertices lie on a lattice (integers below 2^29) each triangle knows the bends that are seen from it along
/// a tangent: then a query between places of the lattice, or of a decimal part of its unit, looks at a few hundred
/// numbers in a row. Elsewhere, and from vertices, what an end sees is found by triangular expansion first.
class Index {
 public:
  static constexpr std::size_t kMemory = std::size_t{64} << 20;

  /// Takes `memory` bytes at most: bytes().size() is below. Where the labels of all bends do not fit, only a core of
  /// them has labels, the others are contracted below it, and queries climb to the core first. Throws InputError where
  /// that does not fit either. Building takes the reduced visibility graph and a pruned search from each bend; told are
  /// the corners of the one, then the bends of the other, these more than once where a part of the labels does not fit.
  explicit Index(FreeSpace space, std::size_t memory = kMemory, const TellProgress& tell = {});

  /// From the bytes() of an index of the same world, mapped from a file say; `keeper` holds them as long as the index
  /// needs them. Every number in them is checked to lead nowhere else; that they are right is taken on trust. Throws
  /// std::runtime_error with half a sentence: they are cut off, damaged, or of another space.
  Index(FreeSpace space, std::span<const std::byte> bytes, std::shared_ptr<const void> keeper);

  const FreeSpace& space() const;
  std::size_t bend_count() const;
  /// All that cannot be had from the space at once, for the second constructor. The same on every machine of one byte
  /// order.
  std::span<const std::byte> bytes() const;

 private:
  friend class IndexSearch;

  std::shared_ptr<const detail::IndexParts> parts_;
};

/// One query after the other in the same memory. One thread at a time.
///
///  1. Shortest among all paths, as PolyanyaSearch finds them, and exactly as long; its points are without any in a
///     straight line. Where several sums over hubs are nearly the least, the paths are compared as sums of roots; of
///     equal ones that over the first hub is chosen, always the same.
///  2. Ends may lie anywhere a robot can be.
///  3. `none` where start and goal have no hub in common: they lie in different components.
/// Throws InputError when an end is no place for the robot.
class IndexSearch {
 public:
  explicit IndexSearch(Index index);
  IndexSearch(IndexSearch&&) noexcept;
  IndexSearch& operator=(IndexSearch&&) noexcept;
  ~IndexSearch();

  SearchStatus find(Point from, Point to);

  /// Of the path found; empty when there is none.
  const std::vector<Point>& points() const;
  /// Its length, to within a few roundings; Length(points()) is exact. Infinite when there is none.
  double length() const;
  /// How many labels were looked at.
  std::size_t scanned() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace taut
