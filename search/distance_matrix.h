// The lengths of the shortest paths between all pairs of many points.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include <taut/geometry/free_space.h>
#include <taut/roadmaps/visibility_graph.h>

namespace taut {

/// Fills lengths[i * n + j] with the length of the shortest path from points[i] to points[j], for n points.
///
///  1. Each is the double nearest to the length that shortest_path finds: candidates are kept as sums of two doubles,
///     off by less than 2^-90 of the length, and compared as such, so only a length that near to the middle of two
///     doubles may become the other one.
///  2. Infinite where there is no path; 0 from a point to itself. The matrix is symmetric, bit by bit.
///  3. Points may repeat and lie wherever a robot can be: on walls and corners as well, with all sides of them.
///
/// `finished` is told how many rows, from the first on, are final: after every few, and at the end. It may throw. With
/// `jobs` threads any of them tells it, one at a time; the lengths are the same, bit by bit, for any number of them.
///
/// For each point: one search over the bends of the reduced visibility graph, O(E + V log V), and one expansion over
/// what it sees, which settles the pairs that see each other; then for each pair the least over the bends seen from the
/// other point, ten to twenty mostly. Memory: 24 bytes an edge and for each bend that a point sees, beside `lengths`;
/// with several threads those bytes an edge for each.
///
/// Throws InputError when a point is no place for the robot. Preconditions: the graph is a reduced one; lengths has
/// room for n * n.
void distance_matrix(const VisibilityGraph& graph, std::span<const Point> points, std::span<double> lengths,
                     const std::function<void(std::size_t rows)>& finished = {}, unsigned jobs = 1);

/// Rows alone, for work that is shared among machines: group g is rows kRows * g and those after it, as many as there
/// are.
class DistanceRows {
 public:
  static constexpr std::size_t kRows = 8;

  /// As distance_matrix. Both outlive it.
  DistanceRows(const VisibilityGraph& graph, std::span<const Point> points, unsigned jobs = 1);

  std::size_t groups() const;
  /// What one thread measures groups with. Of row i the lengths from i on, one row after the other: those of
  /// distance_matrix, bit by bit.
  std::function<std::vector<double>(std::size_t group)> worker() const;

 private:
  struct Impl;
  std::shared_ptr<const Impl> impl_;
};

/// Puts a group's rows where they belong in the whole matrix of n points, and the columns that are their mirror.
/// Precondition: the group has as many lengths as worker() gives.
void put_rows(std::size_t group, std::span<const double> rows, std::span<double> lengths, std::size_t n);

/// All pairs with a graph of its own and in memory of its own: 8 * n * n bytes.
std::vector<double> distance_matrix(const FreeSpace& space, std::span<const Point> points, unsigned jobs = 1);

}  // namespace taut
