// How far all bends of a visibility graph are from one place.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
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

/// Dijkstra's algorithm on a reduced visibility graph, from one place after the other in the same memory.
///
///  1. Lengths are sums of two doubles and compared as such where doubles do not tell; a vertex that turns out to be
///     nearer is taken up again, so order decides nothing.
///  2. Only legs that turn around the obstacle at a vertex, or go straight on there, are followed: those beside the
///     straight continuation in the order of angles, found once for each leg that arrives. What this leaves out is
///     never a shortest path: where one of several equally short ways to a vertex does not turn so, it can be cut
///     short, and so the others with the same leg behind them are not the shortest either.
class BendDistances {
 public:
  explicit BendDistances(const VisibilityGraph& graph);

  /// The way from the place to a vertex that it is joined to.
  struct Leg {
    std::uint32_t to;
    twofold::Pair length;
  };

  void from(std::span<const Leg> legs);

  std::size_t size() const { return at_.size(); }
  /// Infinite where there is no way.
  twofold::Pair operator[](std::size_t v) const { return at_[v]; }

 private:
  static constexpr twofold::Pair kFar{std::numeric_limits<double>::infinity(), 0};

  struct Edge {
    double length;
    std::uint32_t to;
  };
  /// Which legs go on where a leg arrives: of the vertex' legs the first ones up to `right`, those from `left` on.
  struct Turns {
    std::uint32_t right;
    std::uint32_t left;
  };
  struct Open {
    double bound;
    std::uint32_t vertex;
  };

  void add_legs(const VisibilityGraph& graph, Roadmap::Vertex v);
  Turns turns_of(const VisibilityGraph& graph, Roadmap::Vertex from, Roadmap::Vertex at) const;
  void follow(twofold::Pair here, std::size_t first, std::size_t last);
  void reach(std::uint32_t v, twofold::Pair length, std::size_t edge);
  void aim(std::span<const Leg> legs);
  void push(const Open& open);
  bool take(Open& next);

  static constexpr std::size_t kPlace = static_cast<std::size_t>(-1);  // a vertex reached from the place itself

  std::vector<std::size_t> first_;  // by vertex, into edges_
  std::vector<Edge> edges_;         // of each vertex counter-clockwise, from the obstacle's one side to its other
  std::vector<double> low_;         // by edge, of its length
  std::vector<Turns> turns_;        // by edge
  std::vector<twofold::Pair> at_;
  std::vector<std::size_t> via_;  // by vertex: the edge that it was reached by

  // The queue: what is nearer than `width_` to each other is taken in any order. No leg spans all of it.
  static constexpr std::size_t kBuckets = 4096;
  std::vector<std::vector<Open>> open_;  // by bound / width_, modulo kBuckets
  std::size_t now_ = 0;                  // bound / width_ of the bucket that is being emptied
  std::size_t size_ = 0;
  double longest_ = 0, mean_ = 0;  // of the edges
  double width_ = 1;
};

}  // namespace taut::detail
