#include <taut/robots/pursuit/detail/hops.h>

#include <algorithm>

#include <taut/robots/pursuit/detail/radix_heap.h>

namespace taut::pursuit::detail {

std::vector<std::ptrdiff_t> neighbour_steps(const ChaseMap& map) {
  const auto s = static_cast<std::ptrdiff_t>(map.stride());
  return {-s, -1, 1, s, -s - 1, -s + 1, s - 1, s + 1};
}

std::vector<int> hops_from(const ChaseMap& map, CellIndex from, int limit, const Watch& watch) {
  std::vector<int> hops(map.index_count(), kUnreachable);
  const auto steps = neighbour_steps(map);
  std::vector<CellIndex> wave{from}, next;
  hops[from] = 0;
  for (int moves = 1; !wave.empty() && moves <= limit; ++moves, wave.swap(next), next.clear()) {
    if (watch) watch();
    for (const CellIndex cell : wave)
      for (const std::ptrdiff_t step : steps) {
        const auto c = static_cast<CellIndex>(static_cast<std::ptrdiff_t>(cell) + step);
        if (hops[c] != kUnreachable || !map.is_free(c)) continue;
        hops[c] = moves;
        next.push_back(c);
      }
  }
  return hops;
}

std::vector<int> latest_departures(const ChaseMap& map, const std::vector<Meeting>& meetings, int now, std::uint32_t lo,
                                   const Watch& watch) {
  std::vector<int> latest(map.index_count(), -1);
  if (meetings.empty()) return latest;
  const auto steps = neighbour_steps(map);
  std::vector<CellIndex> wave, next;
  const auto enter = [&](CellIndex c, int second, std::vector<CellIndex>& into) {
    if (latest[c] >= 0 || !map.is_free(c) || map.cost(c) < lo) return;
    latest[c] = second;
    into.push_back(c);
  };
  auto meeting = meetings.rbegin();
  for (int second = meeting->second - now; second >= 0; --second, wave.swap(next), next.clear()) {
    for (; meeting != meetings.rend() && meeting->second - now == second; ++meeting) enter(meeting->cell, second, wave);
    if (wave.empty() && meeting == meetings.rend()) break;
    if (second == 0) break;
    if (watch) watch();
    for (const CellIndex c : wave)
      for (const std::ptrdiff_t step : steps)
        enter(static_cast<CellIndex>(static_cast<std::ptrdiff_t>(c) + step), second - 1, next);
  }
  return latest;
}

std::vector<CellIndex> fewest_moves(const ChaseMap& map, CellIndex from, CellIndex to) {
  constexpr std::uint8_t kNone = 255;
  const auto steps = neighbour_steps(map);
  std::vector<std::uint8_t> came_by(map.index_count(), kNone);
  std::vector<CellIndex> wave{from};
  came_by[from] = 0;
  for (std::size_t i = 0; i < wave.size() && wave[i] != to; ++i)
    for (std::size_t d = 0; d < steps.size(); ++d) {
      const auto c = static_cast<CellIndex>(static_cast<std::ptrdiff_t>(wave[i]) + steps[d]);
      if (came_by[c] != kNone || !map.is_free(c)) continue;
      came_by[c] = static_cast<std::uint8_t>(d);
      wave.push_back(c);
    }
  if (came_by[to] == kNone) return {};
  std::vector<CellIndex> way{to};
  while (way.back() != from)
    way.push_back(static_cast<CellIndex>(static_cast<std::ptrdiff_t>(way.back()) - steps[came_by[way.back()]]));
  std::reverse(way.begin(), way.end());
  return way;
}

std::vector<CellIndex> cheapest_way(const ChaseMap& map, CellIndex from, CellIndex to) {
  // From `to`, so that the way is read off forwards.
  const auto steps = neighbour_steps(map);
  std::vector<std::uint64_t> least(map.index_count(), ~std::uint64_t{0});
  std::vector<std::uint8_t> onward(map.index_count(), 0);
  RadixHeap<CellIndex> queue;
  least[to] = 0;
  queue.push(0, to);
  while (!queue.empty()) {
    const auto [cost, cell] = queue.pop();
    if (cost != least[cell]) continue;
    if (cell == from) break;
    for (std::size_t i = 0; i < steps.size(); ++i) {
      const auto before = static_cast<CellIndex>(static_cast<std::ptrdiff_t>(cell) + steps[i]);
      if (!map.is_free(before) || cost + map.cost(before) >= least[before]) continue;
      least[before] = cost + map.cost(before);
      onward[before] = static_cast<std::uint8_t>(i);
      queue.push(least[before], before);
    }
  }
  if (least[from] == ~std::uint64_t{0}) return {};
  std::vector<CellIndex> way{from};
  while (way.back() != to) {
    const CellIndex cell = way.back();
    std::ptrdiff_t step = -steps[onward[cell]];
    for (const std::ptrdiff_t s :
         steps) {  // straight ones first, where they are as good; cells of no cost could lead around in circles
      const std::uint64_t rest = least[static_cast<CellIndex>(static_cast<std::ptrdiff_t>(cell) + s)];
      if (rest >= least[cell] || rest + map.cost(cell) != least[cell]) continue;
      step = s;
      break;
    }
    way.push_back(static_cast<CellIndex>(static_cast<std::ptrdiff_t>(cell) + step));
  }
  return way;
}

}  // namespace taut::pursuit::detail
