#include <algorithm>
#include <bit>

#include <taut/robots/pursuit/detail/reduced.h>

namespace taut::pursuit::detail {

void Workspace::offer(const std::vector<CellIndex>& way, int seconds) {
  const WayCost cost = cost_of(map(), way);
  if (cost.total(way.size() - 1, seconds) >= upper()) return;
  best = plan_along(*chase, way, seconds);
  if (better) better(best);
}

void Workspace::count(std::size_t& since) {
  ++effort.expanded;
  if (++since < 4096) return;
  since = 0;
  if (stopped && stopped()) throw SearchStopped{"out of time"};
}

struct ForwardSearch::Query {
  Range range;
  const std::vector<Meeting>& meetings;
  std::vector<Meeting> by_cell;   // sorted by cell, then second
  std::vector<std::uint8_t> met;  // per meeting, in order of seconds
  std::size_t first = 0;          // the earliest not met
  bool touched_at_start;
  Cost most_reduced = 0;  // a way whose reduced cost is more cannot be better than the best plan
  RangeBound bound;
};

void ForwardSearch::release() {
  far_ = {};
  near_ = {};
}

void ForwardSearch::begin(Query& query) {
  const std::size_t cells = work_.map().index_count();
  near_.assign(cells, kFar);
  if (query.touched_at_start)
    far_ = {};
  else
    far_.assign(cells, kFar);
  queue_.clear();
  query.by_cell = query.meetings;
  std::sort(query.by_cell.begin(), query.by_cell.end(), [](const Meeting& a, const Meeting& b) {
    return a.cell != b.cell ? a.cell < b.cell : a.second < b.second;
  });
  query.met.assign(query.meetings.size(), 0);
  ++work_.effort.searches;
}

RangeBound ForwardSearch::run(const Range& range, const std::vector<Meeting>& meetings) {
  const CellIndex from = work_.chase->from;
  const std::uint32_t start_cost = work_.map().cost(from);
  Query query{range, meetings, {}, {}, 0, start_cost <= range.hi, 0, {}};
  if (start_cost < range.lo || meetings.empty()) return query.bound;
  begin(query);
  (query.touched_at_start ? near_ : far_)[from] = 0;
  queue_.push(0, (std::uint64_t{from} << 1) | query.touched_at_start);
  std::size_t since = 0;
  while (!queue_.empty()) {
    const auto [key, state] = queue_.pop();
    const auto cell = static_cast<CellIndex>(state >> 1);
    const bool touched = state & 1;
    if (key != (touched ? near_ : far_)[cell] || (!touched && near_[cell] < key)) continue;
    while (query.first < meetings.size() && query.met[query.first]) ++query.first;
    if (query.first == meetings.size()) break;
    query.most_reduced = work_.upper() - Cost{range.lo} * work_.seconds(meetings[query.first]) - 1;
    if (static_cast<Cost>(key >> work_.bits) > query.most_reduced) break;
    work_.count(since);
    expand(query, key, state);
  }
  for (std::size_t i = 0; i < meetings.size(); ++i)
    if (!query.met[i] && Cost{range.lo} * work_.seconds(meetings[i]) < work_.upper())
      query.bound.open.push_back(meetings[i]);
  return query.bound;
}

void ForwardSearch::expand(Query& query, std::uint64_t key, std::uint64_t state) {
  const auto cell = static_cast<CellIndex>(state >> 1);
  const bool touched = state & 1;
  if (touched && work_.is_target[cell]) arrive(query, key, cell);
  // Ways that are too slow are followed nevertheless: dropping one would let a dearer way pass for the least. Their moves stop counting.
  const std::uint64_t most_moves = (std::uint64_t{1} << work_.bits) - 1;
  const std::uint64_t next =
      key + (std::uint64_t{work_.map().cost(cell) - query.range.lo} << work_.bits) + ((key & most_moves) < most_moves);
  if (static_cast<Cost>(next >> work_.bits) > query.most_reduced) return;
  for (const std::ptrdiff_t step : work_.steps) relax(query, work_.neighbour(cell, step), touched, next);
}

void ForwardSearch::relax(Query& query, CellIndex cell, bool touched, std::uint64_t key) {
  if (key >= near_[cell]) return;
  const std::uint32_t cost = work_.map().cost(cell);
  if (cost == ChaseMap::kObstacle || cost < query.range.lo) return;
  touched = touched || cost <= query.range.hi;
  std::uint64_t& known = (touched ? near_ : far_)[cell];
  if (key >= known) return;
  if (work_.latest[cell] < 0) return;
  known = key;
  queue_.push(key, (std::uint64_t{cell} << 1) | touched);
}

// The earliest meeting at the cell that is not over, and all later ones there, are reached.
void ForwardSearch::arrive(Query& query, std::uint64_t key, CellIndex cell) {
  const auto moves = static_cast<int>(key & ((std::uint64_t{1} << work_.bits) - 1));
  const auto less = [](const Meeting& a, const Meeting& b) {
    return a.cell != b.cell ? a.cell < b.cell : a.second < b.second;
  };
  auto at = std::lower_bound(query.by_cell.begin(), query.by_cell.end(), Meeting{cell, moves + work_.chase->now}, less);
  if (at == query.by_cell.end() || at->cell != cell) return;
  const Cost value = static_cast<Cost>(key >> work_.bits) + Cost{query.range.lo} * work_.seconds(*at);
  if (value < work_.upper() && value < query.bound.least) {
    const std::vector<CellIndex> way = trace(query, cell);
    query.bound.least = value;
    query.bound.cheapest = cost_of(work_.map(), way).least;
    work_.offer(way, work_.seconds(*at));
  }
  for (; at != query.by_cell.end() && at->cell == cell; ++at) {
    const auto by_second = std::lower_bound(query.meetings.begin(), query.meetings.end(), at->second,
                                            [](const Meeting& m, int second) { return m.second < second; });
    query.met[static_cast<std::size_t>(by_second - query.meetings.begin())] = 1;
  }
}

std::vector<CellIndex> ForwardSearch::trace(const Query& query, CellIndex cell) const {
  const ChaseMap& map = work_.map();
  std::vector<CellIndex> way{cell};
  bool touched = true;
  const auto leads = [&](CellIndex before, bool before_touched, std::uint64_t key) {
    const std::vector<std::uint64_t>& keys = before_touched ? near_ : far_;
    if (keys.empty() || keys[before] == kFar) return false;
    return keys[before] + (std::uint64_t{map.cost(before) - query.range.lo} << work_.bits) + 1 == key;
  };
  while ((touched ? near_ : far_)[way.back()] != 0) {
    const std::uint64_t key = (touched ? near_ : far_)[way.back()];
    const bool touches_here = map.cost(way.back()) <= query.range.hi;
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
