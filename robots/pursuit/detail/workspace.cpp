#include <taut/robots/pursuit/detail/reduced.h>

namespace taut::pursuit::detail {

namespace {

constexpr Cost kParts = 16;

}  // namespace

std::vector<int> Workspace::latest_for(const std::vector<Meeting>& meetings, std::uint32_t lo) const {
  std::vector<int> departures = latest_departures(map(), meetings, chase->now, lo);
  for (std::size_t i = 0; i < departures.size(); ++i)
    if (departures[i] < hops[i]) departures[i] = -1;
  return departures;
}

void Workspace::choose_parts(std::uint32_t dearest_cost) {
  dearest = dearest_cost;
  const Cost last = std::max(1, chase->meetings.back().second - chase->now);
  const bool fits = kParts * dearest < (std::numeric_limits<Cost>::max() >> bits) / 4 / last;
  parts = fits ? kParts : 1;
}

Cost Workspace::least_u(Cost upper) const {
  const Cost last = std::max(1, chase->meetings.back().second - chase->now);
  const Cost most = (std::numeric_limits<Cost>::max() >> bits) / parts, room = most - std::min(upper, most);
  return -std::min(Cost{dearest}, std::max<Cost>(0, room / last - 1)) * parts;
}

void Worker::offer(const std::vector<CellIndex>& way, int seconds) {
  const Cost cost = cost_of(work.map(), way).total(way.size() - 1, seconds);
  if (cost < upper()) best = {cost, way, seconds};
}

void Worker::count(std::size_t& since) {
  ++effort.expanded;
  if (++since < 4096) return;
  since = 0;
  if (work.stopped && work.stopped()) throw SearchStopped{"out of time"};
}

void Worker::offer_earliest(const std::vector<Meeting>& meetings) {
  std::vector<CellIndex> way{work.chase->from};
  const auto seconds_at = [&](CellIndex c) {
    if (work.is_target[c])
      for (const Meeting& m : meetings)
        if (m.cell == c && work.seconds(m) == work.latest[c]) return work.seconds(m);
    return -1;
  };
  int seconds = seconds_at(way.back());
  while (seconds < 0) {
    const CellIndex cell = way.back();
    for (const std::ptrdiff_t step : work.steps)
      if (work.latest[work.neighbour(cell, step)] == work.latest[cell] + 1) {
        way.push_back(work.neighbour(cell, step));
        break;
      }
    seconds = seconds_at(way.back());
  }
  offer(way, seconds);
}

}  // namespace taut::pursuit::detail
