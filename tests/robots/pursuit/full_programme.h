// The independent check of exact plans: dynamic programming over all cells and all seconds, straight from the rules.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include <taut/robots/pursuit/chase_map.h>
#include <taut/robots/pursuit/pursuit.h>

namespace taut::test {

/// The least cost to be in the target's cell at its second; nothing when nobody can. O(cells x seconds).
inline std::optional<pursuit::Cost> least_cost(const pursuit::ChaseMap& map, pursuit::Clock clock) {
  using pursuit::Cost;
  constexpr Cost kNone = Cost{1} << 60;
  const auto at = [&](int x, int y) { return static_cast<std::size_t>((x - 1) * map.y_size() + y - 1); };
  std::vector<Cost> now(static_cast<std::size_t>(map.x_size() * map.y_size()), kNone);
  const Cell start = map.cell(map.start());
  now[at(start.x, start.y)] = 0;
  const int shift = clock == pursuit::Clock::one ? 1 : 0, entries = static_cast<int>(map.duration());
  Cost best = kNone;
  for (int t = 1; t <= entries - 1 + shift; ++t) {
    std::vector<Cost> next(now.size(), kNone);
    for (int x = 1; x <= map.x_size(); ++x)
      for (int y = 1; y <= map.y_size(); ++y) {
        if (now[at(x, y)] >= kNone) continue;
        const Cost cost = now[at(x, y)] + map.cost(map.index({x, y}));
        for (int nx = std::max(1, x - 1); nx <= std::min(map.x_size(), x + 1); ++nx)
          for (int ny = std::max(1, y - 1); ny <= std::min(map.y_size(), y + 1); ++ny)
            if (map.is_free(map.index({nx, ny}))) next[at(nx, ny)] = std::min(next[at(nx, ny)], cost);
      }
    now.swap(next);
    const Cell target = map.cell(map.target()[static_cast<std::size_t>(t - shift)]);
    best = std::min(best, now[at(target.x, target.y)]);
  }
  return best < kNone ? std::optional(best) : std::nullopt;
}

}  // namespace taut::test
