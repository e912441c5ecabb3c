// The searches of the exact planner, over reduced costs.
//
// A way of k moves that is at a meeting after t >= k seconds waits at its cheapest cell, of cost m: it costs sum(w) + (t - k) m. For every number
// u <= m that is at least
//
//     t u + sum over its moves of (w - u),      with equality for u = m,                                                      (*)
//
// and the sum has no negative term. So each u gives a bound by one search with Dijkstra's algorithm in the plane, without any clock: the seconds enter
// by t u and by k <= t. A `Range` lo..hi of m is searched with u = lo, over cells of cost >= lo, along ways that visit a cell of cost <= hi.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <taut/robots/pursuit/detail/hops.h>
#include <taut/robots/pursuit/detail/radix_heap.h>
#include <taut/robots/pursuit/detail/walk.h>

namespace taut::pursuit::detail {

/// Of costs of the cheapest cell on a way.
struct Range {
  std::uint32_t lo = 0;
  std::uint32_t hi = 0;
};

inline constexpr std::uint64_t kFar = ~std::uint64_t{0};

/// Thrown when a search is told to stop.
struct SearchStopped {
  const char* reason;
};

/// What all searches of one planning share.
struct Workspace {
  const Chase* chase = nullptr;
  Stopped stopped{};
  std::vector<std::ptrdiff_t> steps{};
  std::vector<int> latest{};              ///< latest_departures for all meetings
  std::vector<std::uint8_t> is_target{};  ///< some meeting's cell
  int bits = 0;                           ///< of a key, for the number of moves
  PlanEffort effort{};
  Plan best{};  ///< so far; cost kNoCost without one
  std::function<void(const Plan&)> better{};

  const ChaseMap& map() const { return *chase->map; }
  Cost upper() const { return best.cost; }
  int seconds(const Meeting& m) const { return m.second - chase->now; }

  /// Takes the plan along `way` when it costs less than the best.
  void offer(const std::vector<CellIndex>& way, int seconds);
  void count(std::size_t& since);  ///< one more cell expanded; throws SearchStopped

  CellIndex neighbour(CellIndex c, std::ptrdiff_t step) const {
    return static_cast<CellIndex>(static_cast<std::ptrdiff_t>(c) + step);
  }
};

/// What a search of a range says about the meetings it was asked for.
struct RangeBound {
  Cost least = kNoCost;        ///< bound (*) with u = lo of the best meeting reached in time
  std::uint32_t cheapest = 0;  ///< of the cells of that way
  std::vector<Meeting> open;   ///< meetings that were not reached in time, but might be by dearer and shorter ways
};

/// Dijkstra's algorithm from the robot, by (reduced cost, moves). Arrays are kept from call to call.
class ForwardSearch {
 public:
  explicit ForwardSearch(Workspace& work) : work_(work) {}

  /// `meetings` ascending. Offers what it finds to the workspace.
  RangeBound run(const Range& range, const std::vector<Meeting>& meetings);
  void release();  ///< the memory

 private:
  struct Query;
  void begin(Query& query);
  void expand(Query& query, std::uint64_t key, std::uint64_t state);
  void relax(Query& query, CellIndex cell, bool touched, std::uint64_t key);
  void arrive(Query& query, std::uint64_t key, CellIndex cell);
  std::vector<CellIndex> trace(const Query& query, CellIndex cell) const;

  Workspace& work_;
  std::vector<std::uint64_t> far_;   // keys of ways that have not yet visited a cell of cost <= hi
  std::vector<std::uint64_t> near_;  // and of those that have
  RadixHeap<std::uint64_t> queue_;
};

/// Least t u + sum (w - u) from each cell to a meeting, over cells of cost >= lo; u may be below lo, and below 0 (not below minus the dearest cost).
class CostToMeet {
 public:
  CostToMeet(Workspace& work, std::int64_t u, std::uint32_t lo, const std::vector<Meeting>& meetings,
             const std::vector<int>& latest);

  std::int64_t u() const { return u_; }
  /// kNoCost where it is not below Workspace::upper().
  Cost at(CellIndex c) const { return key_[c] == kFar ? kNoCost : static_cast<Cost>(key_[c] >> work_.bits) + base_; }

  struct Way {
    std::vector<CellIndex> cells;
    int seconds = 0;  ///< of the meeting; less than the moves when there is none in time. -1: unknown
  };
  /// The way of that cost, of several one of fewest moves. Precondition: at(from) < kNoCost.
  Way way(CellIndex from, const std::vector<Meeting>& meetings) const;

 private:
  Workspace& work_;
  std::int64_t u_;
  Cost base_ = 0;
  std::vector<std::uint64_t> key_;  // cost above the base, and the moves of the shortest such way
};

/// Where the seconds bind: a search by (reduced cost, moves) that keeps all ways of which neither is better in both, pruned by costs to meet at two
/// values of u. Gives the same bound, now with every meeting reached in time, and leaves none open.
RangeBound search_labels(Workspace& work, const Range& range, const std::vector<Meeting>& meetings,
                         std::size_t most_labels);

}  // namespace taut::pursuit::detail
