// Which taut legs a string can go on from without end.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <taut/search/detail/taut_legs.h>

namespace taut::detail {

/// Of most legs of a reduced graph no taut string goes on far: behind them are pockets, and the backs of obstacles.
/// Those that go on to a leg that goes on, and so for ever, last; the others are of use for the last part of a way
/// alone, and what may be that is found from the goal. (On maps of games one leg in ten lasts.) Once a way has left the
/// lasting legs it does not come back. Immutable. O(E log V) and the pairs of legs that follow each other; 24 bytes a
/// leg.
///
/// Source: the edge levels of Oh, Leong, "Edge N-Level Sparse Visibility Graphs" (2017), taken to the end.
class LastingLegs {
 public:
  explicit LastingLegs(const TautLegs& legs);

  /// One that lasts, and its number among all.
  struct Leg {
    double length;
    std::uint32_t to;
    std::uint32_t leg;
  };
  bool lasts(std::size_t leg) const { return rank_[leg] != rank_[leg + 1]; }
  /// Those of a range that last.
  std::span<const Leg> of(TautLegs::Range range) const {
    return std::span(lasting_).subspan(rank_[range.first], rank_[range.last] - rank_[range.first]);
  }

  /// One that does not last, from where.
  struct Arrival {
    std::uint32_t from;
    std::uint32_t leg;
  };
  /// Those that lead to a vertex, in the order in which the way back would leave it, counter-clockwise: around the free
  /// end of a wall one may be there twice.
  std::span<const Arrival> arriving_at(std::uint32_t vertex) const {
    return std::span(arriving_).subspan(arriving_first_[vertex], arriving_first_[vertex + 1] - arriving_first_[vertex]);
  }
  /// Those that a string may go on from to this one, which does not last either.
  std::span<const Arrival> before(std::size_t leg) const {
    return std::span(before_).subspan(before_first_[leg], before_first_[leg + 1] - before_first_[leg]);
  }

 private:
  void rank(const TautLegs& legs, const std::vector<bool>& ends);
  void list_before(const TautLegs& legs, const std::vector<std::uint32_t>& origin);
  void list_arriving(const TautLegs& legs, const std::vector<std::uint32_t>& origin);

  std::vector<std::uint32_t> rank_;  // by leg: how many before it last
  std::vector<Leg> lasting_;
  std::vector<std::uint32_t> arriving_first_, before_first_;
  std::vector<Arrival> arriving_, before_;
};

}  // namespace taut::detail
