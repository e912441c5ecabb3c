// The searches of the exact planner, over reduced costs.
//
// A way of k moves that is at a meeting after t >= k seconds waits at its cheapest cell, of cost m: it costs sum(w) +
// (t - k) m. For every number u <= m that is at least
//
//     t u + sum over its moves of (w - u),      with equality for u = m,           (*)
//
// and the sum has no negative term. So each u gives a bound by one search with Dijkstra's algorithm in the plane,
// without any clock: the seconds enter by t u and by k <= t. u need not be whole: it is counted in parts,
// Workspace::parts to a unit. A `CostRange` lo..hi of m is searched with u = lo, over cells of cost >= lo, along ways
// that visit a cell of cost <= hi.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <taut/robots/pursuit/detail/high_array.h>
#include <taut/robots/pursuit/detail/hops.h>
#include <taut/robots/pursuit/detail/radix_heap.h>
#include <taut/robots/pursuit/detail/walk.h>

namespace taut::pursuit::detail {

/// Of costs of the cheapest cell on a way.
struct CostRange {
  std::uint32_t lo = 0;
  std::uint32_t hi = 0;
};

inline constexpr std::uint64_t kFar = ~std::uint64_t{0};
using Keys = HighArray<std::uint64_t>;  // of cells, kFar where no search came

/// Thrown when a search is told to stop.
struct SearchStopped {
  const char* reason;
};

/// What all searches of one planning share.
struct Workspace {
  const Chase* chase = nullptr;
  std::function<bool()> stopped{};  ///< asked from two threads
  unsigned jobs = 1;
  std::vector<std::ptrdiff_t> steps{};
  std::vector<int> hops{};    ///< hops_from the robot
  std::vector<int> latest{};  ///< latest_departures for all meetings, -1 where the robot comes later than that
  std::vector<std::uint8_t> is_target{};  ///< some meeting's cell
  int bits = 0;                           ///< of a key, for the number of moves
  std::uint32_t dearest = 0;              ///< cost of a cell
  Cost parts = 1;                         ///< of a unit, for u

  const ChaseMap& map() const { return *chase->map; }
  int seconds(const Meeting& m) const { return m.second - chase->now; }
  CellIndex neighbour(CellIndex c, std::ptrdiff_t step) const {
    return static_cast<CellIndex>(static_cast<std::ptrdiff_t>(c) + step);
  }
  /// The latest departures for some of the meetings over cells of cost >= lo, -1 where the robot comes later.
  std::vector<int> latest_for(const std::vector<Meeting>& meetings, std::uint32_t lo) const;
  /// Sets `dearest` and `parts`.
  void choose_parts(std::uint32_t dearest);
  /// The least u in parts with which keys fit: a reduced cost below upper - u * (last second) and the moves in 63 bits.
  Cost least_u(Cost upper) const;
};

/// A way in time, and when it is at its end.
struct Incumbent {
  Cost cost = kNoCost;
  std::vector<CellIndex> way{};
  int seconds = 0;
};

/// One thread's part of a planning. The searches need a best way: upper() times Workspace::parts must fit.
struct Worker {
  const Workspace& work;
  Incumbent best{};
  PlanEffort effort{};

  Cost upper() const { return best.cost; }
  void offer(const std::vector<CellIndex>& way, int seconds);  ///< takes it when it costs less than the best
  void offer_earliest(const std::vector<Meeting>& meetings);   ///< the way that Workspace::latest leads along
  void count(std::size_t& since);                              ///< one more cell expanded; throws SearchStopped
};

/// How a search for one u came to a meeting.
struct Reach {
  /// (*): no way of the range to this meeting costs less; kNoCost: it cannot be better than the best plan
  Cost bound = kNoCost;
  Cost moves_cost = 0;  ///< of the way of that bound, without waiting
  int moves = 0;        ///< of that way; more than the meeting's seconds: it is late
};

/// Dijkstra's algorithm from the robot, by (reduced cost, moves).
class ForwardSearch {
 public:
  explicit ForwardSearch(Worker& worker) : worker_(worker), work_(worker.work) {}

  /// `meetings` ascending, `latest` of Workspace::latest_for them; u in parts, not above range.lo. Offers the ways in
  /// time that it finds. The answers, one a meeting, hold until the next run.
  const std::vector<Reach>& run(const CostRange& range, Cost u, const std::vector<Meeting>& meetings,
                                const std::vector<int>& latest);
  /// The way of the last run to a meeting's cell. Precondition: its bound is not kNoCost.
  std::vector<CellIndex> way_to(CellIndex cell) const;
  void release();  ///< the memory

 private:
  struct Query;
  void begin(Query& query);
  bool is_over(Query& query, std::uint64_t key) const;
  void expand(Query& query, std::uint64_t key, std::uint64_t state);
  void relax(CellIndex cell, bool touched, std::uint64_t key);
  void arrive(Query& query, std::uint64_t key, CellIndex cell);
  void offer_the_best(const Query& query);
  std::uint64_t step_key(CellIndex left) const {
    return static_cast<std::uint64_t>(work_.parts * work_.map().cost(left) - u_) << work_.bits;
  }

  Worker& worker_;
  const Workspace& work_;
  CostRange range_;
  Cost u_ = 0;
  const std::vector<int>* latest_ = nullptr;
  std::vector<Reach> reached_;
  Keys far_;   // keys of ways that have not yet visited a cell of cost <= hi
  Keys near_;  // and of those that have
  RadixHeap<std::uint64_t> queue_;
};

/// Least t u + sum (w - u) from each cell to a meeting, over cells of cost >= lo; u may be below lo, and below 0 (not
/// below least_u). All in parts.
class CostToMeet {
 public:
  CostToMeet(Worker& worker, Cost u, std::uint32_t lo, const std::vector<Meeting>& meetings,
             const std::vector<int>& latest);

  Cost u() const { return u_; }
  /// kNoCost where it is not below Worker::upper().
  Cost at(CellIndex c) const { return cost_[c] == kFar ? kNoCost : static_cast<Cost>(cost_[c]) + base_; }

 private:
  Cost u_;
  Cost base_ = 0;
  Keys cost_;  // above the base
};

/// What a search with two criteria says about a range.
struct RangeBound {
  Cost least = kNoCost;        ///< bound (*) with u = lo of the best meeting reached in time
  std::uint32_t cheapest = 0;  ///< of the cells of that way
};

/// Where the seconds bind: a search by (reduced cost, moves) that keeps all ways of which neither is better in both,
/// pruned by costs to meet for u = lo and for the `u` given, in parts, best one where the bound of the best meeting is
/// highest. Gives bound (*) with u = lo, for every meeting among ways that are in time. Nothing when it would take more
/// than so many labels.
std::optional<RangeBound> search_labels(Worker& worker, const CostRange& range, const std::vector<Meeting>& meetings,
                                        Cost u, std::size_t most_labels);

}  // namespace taut::pursuit::detail
