#include <taut/robots/pursuit/detail/range_search.h>

#include <algorithm>

namespace taut::pursuit::detail {

namespace {

constexpr std::size_t kMostPasses = 7;

Cost floor_divided(Cost a, Cost b) { return a / b - ((a % b != 0) && ((a < 0) != (b < 0))); }

}  // namespace

void RangeSearch::begin(const CostRange& range, std::vector<Cost> bounds) {
  range_ = range;
  subjects_.assign(meetings_.size(), {});
  for (std::size_t i = 0; i < meetings_.size(); ++i)
    subjects_[i].bound = std::max(bounds[i], Cost{range.lo} * worker.work.seconds(meetings_[i]));
  latest_.clear();
  tried_.clear();
  answer_ = {};
}

std::vector<Meeting> RangeSearch::live() const {
  std::vector<Meeting> live;
  for (std::size_t i = 0; i < meetings_.size(); ++i)
    if (is_live(subjects_[i])) live.push_back(meetings_[i]);
  return live;
}

void RangeSearch::pass(Cost u) {
  std::vector<std::size_t> index;
  for (std::size_t i = 0; i < meetings_.size(); ++i)
    if (is_live(subjects_[i])) index.push_back(i);
  const std::vector<Meeting> live = this->live();
  tried_.push_back(u);
  const std::vector<Reach>& reached = forward_.run(range_, u, live, latest_.empty() ? worker.work.latest : latest_);
  Cost least = kNoCost;
  CellIndex where = 0;
  for (std::size_t i = 0; i < live.size(); ++i) {
    note(index[i], u, reached[i]);
    const Subject& s = subjects_[index[i]];
    if (!s.is_done || s.bound >= least) continue;
    least = s.bound;
    where = live[i].cell;
  }
  if (least >= worker.upper() || least >= answer_.bound) return;
  answer_.bound = least;
  answer_.cheapest = cost_of(worker.work.map(), forward_.way_to(where)).least;
}

void RangeSearch::note(std::size_t i, Cost u, const Reach& reach) {
  Subject& s = subjects_[i];
  if (reach.bound > s.bound) {
    s.bound = reach.bound;
    s.best_u = u;
  }
  if (reach.bound >= kNoCost) return;
  const Line line{reach.moves_cost, Cost{worker.work.seconds(meetings_[i])} - reach.moves};
  (line.slack < 0 ? s.late : s.early) = line;
  s.is_done = u == lo() && line.slack >= 0;
}

void RangeSearch::absorb(const RangeSearch& beside) {
  if (beside.worker.upper() < worker.upper()) worker.best = beside.worker.best;
  tried_.insert(tried_.end(), beside.tried_.begin(), beside.tried_.end());
  for (std::size_t i = 0; i < subjects_.size(); ++i) {
    const Subject& other = beside.subjects_[i];
    if (other.bound > subjects_[i].bound) {
      subjects_[i].bound = other.bound;
      subjects_[i].best_u = other.best_u;
    }
    if (other.late.slack < 0) subjects_[i].late = other.late;
    if (other.early.slack >= 0) subjects_[i].early = other.early;
  }
}

// In parts.
Cost RangeSearch::mean_cost() const {
  return worker.upper() < kNoCost ? worker.work.parts * (worker.upper() / std::max(1, worker.best.seconds) + 1) : 1;
}

Cost RangeSearch::guess() const {
  return range_.lo > 0 ? 0 : std::max(-mean_cost(), worker.work.least_u(worker.upper()));
}

// Where the least bound's lines cross; false when that was tried.
bool RangeSearch::descend() {
  const Subject* least = nullptr;
  for (const Subject& s : subjects_)
    if (is_live(s) && (!least || s.bound < least->bound)) least = &s;
  if (!least || tried_.size() >= kMostPasses) return false;
  const Cost lowest = *std::min_element(tried_.begin(), tried_.end());
  Cost u = lowest > 0 ? 0 : std::min(4 * lowest, -mean_cost());
  if (least->early.slack >= 0)
    u = floor_divided(worker.work.parts * (least->early.moves_cost - least->late.moves_cost),
                      least->late.slack - least->early.slack);
  u = std::clamp(u, worker.work.least_u(worker.upper()), lo());
  if (std::find(tried_.begin(), tried_.end(), u) != tried_.end()) return false;
  if (latest_.empty()) latest_ = worker.work.latest_for(live(), range_.lo);
  pass(u);
  return true;
}

Cost RangeSearch::bound_so_far() const {
  Cost least = kNoCost;
  for (const Subject& s : subjects_) least = std::min(least, s.bound);
  return least;
}

RangeSearch::Answer RangeSearch::finish(std::size_t most_labels) {
  while (descend()) {
  }
  const Subject* least = nullptr;
  for (const Subject& s : subjects_)
    if (is_live(s) && (!least || s.bound < least->bound)) least = &s;
  if (least && least->bound < answer_.bound) {
    const Cost least_late = least->bound;
    forward_.release();
    std::optional<RangeBound> labels;
    if (most_labels > 0) labels = search_labels(worker, range_, live(), std::min(least->best_u, lo()), most_labels);
    answer_.is_open = !labels;
    if (!labels) answer_.bound = least_late;
    if (labels && labels->least < answer_.bound) {
      answer_.bound = labels->least;
      answer_.cheapest = labels->cheapest;
    }
  }
  if (answer_.bound >= worker.upper()) answer_.bound = kNoCost;
  answer_.bounds.clear();
  for (const Subject& s : subjects_) answer_.bounds.push_back(s.bound);
  return std::move(answer_);
}

}  // namespace taut::pursuit::detail
