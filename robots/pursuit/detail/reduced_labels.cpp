#include <algorithm>

#include <taut/robots/pursuit/detail/reduced.h>

namespace taut::pursuit::detail {

namespace {

constexpr std::uint32_t kNoLabel = ~std::uint32_t{0};

/// What the label search needs to know about the way ahead.
struct Ahead {
  const std::vector<Meeting>& meetings;  // that can still be better
  const std::vector<int>& latest;        // over cells of cost >= lo
  const CostToMeet& lower;               // u = lo
  const CostToMeet& tangent;             // u < lo, where the bound at the start is highest
};

class LabelSearch {
 public:
  LabelSearch(Worker& worker, const CostRange& range, const Ahead& ahead, std::size_t most_labels)
      : worker_(worker), work_(worker.work), range_(range), ahead_(ahead), most_labels_(most_labels) {}

  std::optional<RangeBound> run() {
    const CellIndex from = work_.chase->from;
    const bool touched = work_.map().cost(from) <= range_.hi;
    moves_ = HighArray<std::uint32_t>(2 * work_.map().index_count());
    base_ = lower(from);
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

  Cost lower(CellIndex cell) const {
    const Cost cost = ahead_.lower.at(cell);
    return cost >= kNoCost ? kNoCost : cost / work_.parts;  // u is whole, and so is this
  }

  // By (bound, moves): at one cell the reduced costs ascend, so a label is as good as none when one with no more moves
  // has been there.
  bool is_dominated(CellIndex cell, bool touched, int moves) const {
    const auto at_most = [&](std::size_t known) { return moves_[known] <= static_cast<std::uint32_t>(moves); };
    return at_most(2 * std::size_t{cell} + 1) || (!touched && at_most(2 * std::size_t{cell}));
  }

  void enter(CellIndex cell, bool touched, Cost reduced, int moves, std::uint32_t parent) {
    if (moves > ahead_.latest[cell] || is_dominated(cell, touched, moves)) return;
    const Cost upper = std::min(worker_.upper(), result_.least), bound = reduced + lower(cell);
    if (bound >= upper) return;
    const Cost above = work_.parts * (reduced + moves * Cost{range_.lo}) - moves * ahead_.tangent.u();
    if (above + ahead_.tangent.at(cell) >= work_.parts * upper) return;
    queue_.push((static_cast<std::uint64_t>(bound - base_) << work_.bits) | static_cast<std::uint64_t>(moves),
                static_cast<std::uint32_t>(labels_.size()));
    labels_.push_back({cell, parent & 0x7fffffffU, touched});
  }

  void settle(std::uint32_t index, Cost bound, int moves) {
    const Label label = labels_[index];
    const CellIndex cell = label.cell;
    if (is_dominated(cell, label.touched, moves)) return;
    moves_.set(2 * std::size_t{cell} + label.touched, static_cast<std::uint32_t>(moves));
    const Cost reduced = bound - lower(cell);
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
  const CostRange& range_;
  Ahead ahead_;
  std::size_t most_labels_;
  Cost base_ = 0;
  HighArray<std::uint32_t> moves_;  // least so far, per cell not touched and touched
  std::vector<Label> labels_;
  RadixHeap<std::uint32_t> queue_;
  RangeBound result_;
  std::uint32_t end_ = kNoLabel;
  int end_seconds_ = 0;
};

}  // namespace

std::optional<RangeBound> search_labels(Worker& worker, const CostRange& range, const std::vector<Meeting>& meetings,
                                        Cost u, std::size_t most_labels) {
  const Workspace& work = worker.work;
  const std::vector<int> latest = work.latest_for(meetings, range.lo);
  const CellIndex from = work.chase->from;
  const CostToMeet tangent(worker, u, range.lo, meetings, latest);
  if (tangent.at(from) >= work.parts * worker.upper()) return RangeBound{};
  const CostToMeet lower(worker, work.parts * range.lo, range.lo, meetings, latest);
  if (lower.at(from) >= work.parts * worker.upper()) return RangeBound{};
  return LabelSearch(worker, range, {meetings, latest, lower, tangent}, most_labels).run();
}

}  // namespace taut::pursuit::detail
