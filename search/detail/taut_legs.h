// The legs of a reduced visibility graph, and which of them go on where one arrives.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <taut/geometry/exact/twofold.h>
#include <taut/roadmaps/visibility_graph.h>

namespace taut::detail {

/// The length of the leg between two points, as a sum of two doubles: off by less than 2^-90 of it.
inline twofold::Pair leg_of(Point p, Point q) {
  const twofold::Root root = twofold::root_of(
      twofold::square_of(twofold::absolute_difference(p.x, q.x), twofold::absolute_difference(p.y, q.y)));
  return {root.high, root.low};
}

/// A sum of such sums, with high the nearest double again.
inline twofold::Pair plus(twofold::Pair a, twofold::Pair b) {
  const twofold::Pair s = twofold::two_sum(a.high, b.high);
  return twofold::two_sum(s.high, s.low + (a.low + b.low));
}

inline bool is_less(twofold::Pair a, twofold::Pair b) { return a.high < b.high || (a.high == b.high && a.low < b.low); }

/// The high parts of two sums, added in one rounding, are off by less than this part of the sum; twice it tells apart.
inline constexpr double kDoubt = 0x1p-49;

/// The legs of each vertex counter-clockwise, from the obstacle's one side to its other (around the free end of a wall
/// those along the wall are first and last). Where a leg arrives, a taut string turns around the obstacle or goes
/// straight on: the legs beside the straight continuation, found in advance. Immutable. O(E log V) but for long
/// stretches; 32 bytes a leg and direction.
///
/// Following those alone is no loss: where one of several equally short ways to a vertex does not turn so into a leg,
/// it can be cut short, and so the others with the same leg behind them are not the shortest either.
class TautLegs {
 public:
  /// Of a reduced graph, which is not kept.
  explicit TautLegs(const VisibilityGraph& graph);

  struct Leg {
    double length;  ///< its high part
    std::uint32_t to;
  };
  struct Range {
    std::size_t first, last;
  };

  std::size_t vertex_count() const { return first_.size() - 1; }
  const Leg& operator[](std::size_t leg) const { return legs_[leg]; }
  twofold::Pair length(std::size_t leg) const { return {legs_[leg].length, low_[leg]}; }
  std::size_t size() const { return legs_.size(); }

  Range of(std::uint32_t vertex) const { return {first_[vertex], first_[vertex + 1]}; }
  /// Of the vertex that `arriving` leads to: those that turn right or go on, and those that turn left or go on.
  Range right_of(std::size_t arriving) const {
    const std::size_t first = first_[legs_[arriving].to];
    return {first, first + turns_[arriving].right};
  }
  Range left_of(std::size_t arriving) const {
    const std::uint32_t at = legs_[arriving].to;
    return {first_[at] + turns_[arriving].left, first_[at + 1]};
  }

 private:
  struct Turns {
    std::uint32_t right;
    std::uint32_t left;
  };

  void add_legs(const VisibilityGraph& graph, Roadmap::Vertex v);
  Turns turns_of(const VisibilityGraph& graph, Roadmap::Vertex from, Roadmap::Vertex at) const;

  std::vector<std::size_t> first_;  // by vertex, into legs_
  std::vector<Leg> legs_;
  std::vector<double> low_;   // by leg, of its length
  std::vector<Turns> turns_;  // by leg
};

}  // namespace taut::detail
