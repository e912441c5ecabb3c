#include <algorithm>
#include <optional>

#include <taut/robots/pursuit/detail/reduced.h>

namespace taut::pursuit::detail {

namespace {

constexpr int kMostTangents = 8;
constexpr std::uint32_t kNoLabel = ~std::uint32_t{0};

/// What the label search needs to know about the way ahead.
struct Ahead {
  std::vector<Meeting> meetings;      // that can still be better
  std::vector<int> latest;            // over cells of cost >= lo
  std::optional<CostToMeet> lower;    // u = lo
  std::optional<CostToMeet> tangent;  // u < lo, where the bound at the start is highest
};

/// A way as a function of u: its bound (*) is moves_cost + slack * u.
struct Line {
  Cost moves_cost = 0;
  Cost slack = 0;  // seconds - moves; negative: not in time
};

Line line_of(const Workspace& work, const CostToMeet::Way& way) {
  return {cost_of(work.map(), way.cells).moves, way.seconds - static_cast<Cost>(way.cells.size()) + 1};
}

Cost floor_divided(Cost a, Cost b) { return a / b - ((a % b != 0) && ((a < 0) != (b < 0))); }

// The bound at the start is a concave function of u: raised by tangents (Handler and Zang, "A dual algorithm for the constrained shortest path
// problem", 1980). Ways in time that are met on the way are offered.
void find_tangent(Worker& worker, const Range& range, Ahead& ahead) {
  const Workspace& work = worker.work;
  const CellIndex from = work.chase->from;
  const CostToMeet::Way way = ahead.lower->way(from, ahead.meetings);
  if (way.seconds < 0) return;
  Line late = line_of(work, way);
  if (late.slack >= 0) return worker.offer(way.cells, way.seconds);
  if (worker.upper() >= kNoCost) return;
  Line early = line_of(work, {worker.best.way, worker.best.seconds});
  Cost best_bound = ahead.lower->at(from), last_u = range.lo;
  for (int i = 0; i < kMostTangents; ++i) {
    const Cost crossing = floor_divided(early.moves_cost - late.moves_cost, late.slack - early.slack);
    const Cost u = std::clamp<Cost>(crossing, work.least_u(worker.upper()), Cost{range.lo});
    if (u == last_u) return;
    last_u = u;
    CostToMeet next(worker, u, range.lo, ahead.meetings, ahead.latest);
    if (next.at(from) >= kNoCost) {  // nothing is left below the best plan
      ahead.tangent.emplace(std::move(next));
      return;
    }
    const CostToMeet::Way here = next.way(from, ahead.meetings);
    const Line line = line_of(work, here);
    const Cost bound = next.at(from);
    if (bound >= best_bound) {
      best_bound = bound;
      ahead.tangent.emplace(std::move(next));
    }
    if (here.seconds < 0) return;
    if (line.slack >= 0) worker.offer(here.cells, here.seconds);
    (line.slack >= 0 ? early : late) = line;
  }
}

class LabelSearch {
 public:
  LabelSearch(Worker& worker, const Range& range, const Ahead& ahead, std::size_t most_labels)
      : worker_(worker), work_(worker.work), range_(range), ahead_(ahead), most_labels_(most_labels) {}

  std::optional<RangeBound> run() {
    const CellIndex from = work_.chase->from;
    const bool touched = work_.map().cost(from) <= range_.hi;
    moves_.assign(2 * work_.map().index_count(), std::numeric_limits<int>::max());
    base_ = ahead_.lower->at(from);
    enter(from, touched, 0, 0, kNoLabel);
    std::size_t since = 0;
    while (!queue_.empty() && labels_.size() < most_labels_) {
      const auto [key, label] = queue_.pop();
      const Cost bound = base_ + static_cast<Cost>(key >> work_.bits);
      if (bound >= std::min(worker_.upper(), result_.least)) break;
      worker_.count(since);
      settle(label, bound, static_cast<int>(key & ((std::uint64_t{1} << work_.bits) - 1)));
    }
    worker_.effort.labels += labels_.size();
    if (labels_.size() >= most_labels_) return std::nullopt;
    if (end_ != kNoLabel && result_.least < worker_.upper()) {
      const std::vector<CellIndex> way = trace(end_);
      result_.cheapest = cost_of(work_.map(), way).least;
      worker_.offer(way, end_seconds_);
    }
    return result_;
  }

 private:
  struct Label {
    std::uint32_t cell;
    std::uint32_t parent : 31;
    std::uint32_t touched : 1;
  };

  // By (bound, moves): at one cell the reduced costs ascend, so a label is as good as none when one with no more moves has been there.
  bool is_dominated(CellIndex cell, bool touched, int moves) const {
    return moves_[2 * std::size_t{cell} + 1] <= moves || (!touched && moves_[2 * std::size_t{cell}] <= moves);
  }

  void enter(CellIndex cell, bool touched, Cost reduced, int moves, std::uint32_t parent) {
    if (moves > ahead_.latest[cell] || is_dominated(cell, touched, moves)) return;
    const Cost upper = std::min(worker_.upper(), result_.least), bound = reduced + ahead_.lower->at(cell);
    if (bound >= upper) return;
    if (ahead_.tangent && reduced + moves * (Cost{range_.lo} - ahead_.tangent->u()) + ahead_.tangent->at(cell) >= upper)
      return;
    queue_.push((static_cast<std::uint64_t>(bound - base_) << work_.bits) | static_cast<std::uint64_t>(moves),
                static_cast<std::uint32_t>(labels_.size()));
    labels_.push_back({cell, parent & 0x7fffffffU, touched});
  }

  void settle(std::uint32_t index, Cost bound, int moves) {
    const Label label = labels_[index];
    const CellIndex cell = label.cell;
    if (is_dominated(cell, label.touched, moves)) return;
    moves_[2 * std::size_t{cell} + label.touched] = moves;
    const Cost reduced = bound - ahead_.lower->at(cell);
    if (label.touched && work_.is_target[cell]) arrive(index, cell, reduced, moves);
    const Cost next = reduced + work_.map().cost(cell) - range_.lo;
    for (const std::ptrdiff_t step : work_.steps) {
      const CellIndex to = work_.neighbour(cell, step);
      const std::uint32_t cost = work_.map().cost(to);
      if (cost != ChaseMap::kObstacle && cost >= range_.lo)
        enter(to, label.touched || cost <= range_.hi, next, moves + 1, index);
    }
  }

  void arrive(std::uint32_t index, CellIndex cell, Cost reduced, int moves) {
    for (const Meeting& m : ahead_.meetings) {
      const int seconds = work_.seconds(m);
      if (m.cell != cell || seconds < moves) continue;
      const Cost value = reduced + Cost{range_.lo} * seconds;
      if (value >= result_.least) return;
      result_.least = value;
      end_ = index;
      end_seconds_ = seconds;
      return;
    }
  }

  std::vector<CellIndex> trace(std::uint32_t label) const {
    std::vector<CellIndex> way;
    for (; label != (kNoLabel & 0x7fffffffU); label = labels_[label].parent) way.push_back(labels_[label].cell);
    std::reverse(way.begin(), way.end());
    return way;
  }

  Worker& worker_;
  const Workspace& work_;
  const Range& range_;
  const Ahead& ahead_;
  std::size_t most_labels_;
  Cost base_ = 0;
  std::vector<int> moves_;  // least so far, per cell not touched and touched
  std::vector<Label> labels_;
  RadixHeap<std::uint32_t> queue_;
  RangeBound result_;
  std::uint32_t end_ = kNoLabel;
  int end_seconds_ = 0;
};

}  // namespace

std::optional<RangeBound> search_labels(Worker& worker, const Range& range, const std::vector<Meeting>& meetings,
                                        std::size_t most_labels) {
  const Workspace& work = worker.work;
  Ahead ahead{meetings, latest_departures(work.map(), meetings, work.chase->now, range.lo), {}, {}};
  const CellIndex from = work.chase->from;
  if (ahead.latest[from] < 0) return RangeBound{};
  ahead.lower.emplace(worker, range.lo, range.lo, meetings, ahead.latest);
  if (ahead.lower->at(from) >= worker.upper()) return RangeBound{};
  find_tangent(worker, range, ahead);
  if (ahead.lower->at(from) >= worker.upper()) return RangeBound{};
  if (ahead.tangent && ahead.tangent->at(from) >= worker.upper()) return RangeBound{};
  return LabelSearch(worker, range, ahead, most_labels).run();
}

}  // namespace taut::pursuit::detail
