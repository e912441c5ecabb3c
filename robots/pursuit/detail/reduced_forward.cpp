#include <algorithm>

#include <taut/robots/pursuit/detail/reduced.h>

namespace taut::pursuit::detail {

namespace {

constexpr int kMostTraces = 32;
constexpr int kWorthATrace = 64;  // parts of the best cost that a way must seem better by, while the search goes on

Cost rounded_up(Cost a, Cost b) { return a / b + (a % b > 0); }  // b > 0

bool by_cell(const Meeting& a, const Meeting& b) { return a.cell != b.cell ? a.cell < b.cell : a.second < b.second; }

}  // namespace

struct ForwardSearch::Query {
  const std::vector<Meeting>& meetings;
  std::vector<std::pair<Meeting, std::size_t>> by_cell;  // sorted by cell, then second
  std::vector<std::uint8_t> settled;                     // per meeting
  std::size_t first, end;                                // of the meetings not settled, from either side
  Cost most_reduced = 0;  // a way whose reduced cost is more cannot be better than the best plan
};

void ForwardSearch::release() {
  far_ = {};
  near_ = {};
}

void ForwardSearch::begin(Query& query) {
  const CellIndex from = work_.chase->from;
  const bool touched = work_.map().cost(from) <= range_.hi;
  release();
  near_ = Keys(work_.map().index_count());
  if (!touched) far_ = Keys(work_.map().index_count());
  queue_.clear();
  for (std::size_t i = 0; i < query.meetings.size(); ++i) query.by_cell.emplace_back(query.meetings[i], i);
  std::sort(query.by_cell.begin(), query.by_cell.end(),
            [](const auto& a, const auto& b) { return detail::by_cell(a.first, b.first); });
  ++worker_.effort.searches;
  (touched ? near_ : far_).set(from, 0);
  queue_.push(0, (std::uint64_t{from} << 1) | touched);
}

const std::vector<Reach>& ForwardSearch::run(const CostRange& range, Cost u, const std::vector<Meeting>& meetings,
                                             const std::vector<int>& latest) {
  range_ = range;
  u_ = u;
  latest_ = &latest;
  reached_.assign(meetings.size(), {});
  if (work_.map().cost(work_.chase->from) < range.lo || meetings.empty()) return reached_;
  Query query{meetings, {}, std::vector<std::uint8_t>(meetings.size(), 0), 0, meetings.size(), 0};
  begin(query);
  for (std::size_t since = 0; !queue_.empty();) {
    const auto [key, state] = queue_.pop();
    const auto cell = static_cast<CellIndex>(state >> 1);
    const bool touched = state & 1;
    if (key != (touched ? near_ : far_)[cell] || (!touched && near_[cell] < key)) continue;
    if (is_over(query, key)) break;
    worker_.count(since);
    expand(query, key, state);
  }
  offer_the_best(query);
  return reached_;
}

bool ForwardSearch::is_over(Query& query, std::uint64_t key) const {
  while (query.first < query.end && query.settled[query.first]) ++query.first;
  while (query.first < query.end && query.settled[query.end - 1]) --query.end;
  if (query.first == query.end) return true;
  const Meeting& nearest = query.meetings[u_ >= 0 ? query.first : query.end - 1];
  query.most_reduced = work_.parts * worker_.upper() - u_ * work_.seconds(nearest) - 1;
  return static_cast<Cost>(key >> work_.bits) > query.most_reduced;
}

void ForwardSearch::expand(Query& query, std::uint64_t key, std::uint64_t state) {
  const auto cell = static_cast<CellIndex>(state >> 1);
  const bool touched = state & 1;
  if (touched && work_.is_target[cell]) arrive(query, key, cell);
  // Ways that are too slow are followed nevertheless: dropping one would let a dearer way pass for the least. Their
  // moves stop counting.
  const std::uint64_t most_moves = (std::uint64_t{1} << work_.bits) - 1;
  const std::uint64_t next = key + step_key(cell) + ((key & most_moves) < most_moves);
  if (static_cast<Cost>(next >> work_.bits) > query.most_reduced) return;
  for (const std::ptrdiff_t step : work_.steps) relax(work_.neighbour(cell, step), touched, next);
}

void ForwardSearch::relax(CellIndex cell, bool touched, std::uint64_t key) {
  if (key >= near_[cell]) return;
  const std::uint32_t cost = work_.map().cost(cell);
  if (cost == ChaseMap::kObstacle || cost < range_.lo) return;
  touched = touched || cost <= range_.hi;
  Keys& known = touched ? near_ : far_;
  if (key >= known[cell] || (*latest_)[cell] < 0) return;
  known.set(cell, key);
  queue_.push(key, (std::uint64_t{cell} << 1) | touched);
}

// All meetings there are settled, in time or late. Of those in time the earliest costs least.
void ForwardSearch::arrive(Query& query, std::uint64_t key, CellIndex cell) {
  const auto moves = static_cast<int>(key & ((std::uint64_t{1} << work_.bits) - 1));
  const auto reduced = static_cast<Cost>(key >> work_.bits);
  auto at = std::lower_bound(query.by_cell.begin(), query.by_cell.end(), cell,
                             [](const auto& m, CellIndex c) { return m.first.cell < c; });
  bool is_first_in_time = true;
  for (; at != query.by_cell.end() && at->first.cell == cell; ++at) {
    const int seconds = work_.seconds(at->first);
    query.settled[at->second] = 1;
    reached_[at->second] = {rounded_up(reduced + u_ * seconds, work_.parts), (reduced + u_ * moves) / work_.parts,
                            moves};
    if (moves > seconds || !is_first_in_time) continue;
    is_first_in_time = false;
    const Cost estimate = reached_[at->second].moves_cost + (seconds - moves) * Cost{range_.lo};
    if (estimate < worker_.upper() - worker_.upper() / kWorthATrace) worker_.offer(way_to(cell), seconds);
  }
}

// With waiting at cost lo, if it were so cheap, the most promising first.
void ForwardSearch::offer_the_best(const Query& query) {
  std::vector<std::pair<Cost, std::size_t>> promising;
  for (std::size_t i = 0; i < query.meetings.size(); ++i) {
    const Reach& reach = reached_[i];
    const int seconds = work_.seconds(query.meetings[i]);
    if (!query.settled[i] || reach.moves > seconds) continue;
    const Cost estimate = reach.moves_cost + (seconds - reach.moves) * Cost{range_.lo};
    if (estimate < worker_.upper()) promising.emplace_back(estimate, i);
  }
  std::sort(promising.begin(), promising.end());
  int traces = 0;
  for (const auto& [estimate, i] : promising) {
    if (estimate >= worker_.upper() || ++traces > kMostTraces) return;
    worker_.offer(way_to(query.meetings[i].cell), work_.seconds(query.meetings[i]));
  }
}

std::vector<CellIndex> ForwardSearch::way_to(CellIndex cell) const {
  const ChaseMap& map = work_.map();
  std::vector<CellIndex> way{cell};
  bool touched = true;
  const auto leads = [&](CellIndex before, bool before_touched, std::uint64_t key) {
    const Keys& keys = before_touched ? near_ : far_;
    if (keys.empty() || keys[before] == kFar) return false;
    return keys[before] + step_key(before) + 1 == key;
  };
  while ((touched ? near_ : far_)[way.back()] != 0) {
    const std::uint64_t key = (touched ? near_ : far_)[way.back()];
    const bool touches_here = map.cost(way.back()) <= range_.hi;
    for (const std::ptrdiff_t step : work_.steps) {
      const CellIndex before = work_.neighbour(way.back(), step);
      if (leads(before, touched, key)) {
        way.push_back(before);
        break;
      }
      if (touched && touches_here && leads(before, false, key)) {
        way.push_back(before);
        touched = false;
        break;
      }
    }
  }
  std::reverse(way.begin(), way.end());
  return way;
}

}  // namespace taut::pursuit::detail
