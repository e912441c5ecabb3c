// Least costs on grids by relaxing every move until nothing changes, and small random grids to try it on.
#pragma once

#include <cstdint>
#include <optional>
#include <ostream>
#include <vector>

#include <taut/geometry/draws.h>
#include <taut/geometry/occupancy_grid.h>
#include <taut/search/grid/grid_moves.h>

namespace taut {

inline void PrintTo(GridMoves moves, std::ostream* out) { *out << name(moves); }

}  // namespace taut

namespace taut::test {

/// straight + diagonal sqrt(2)
struct Counts {
  std::int64_t straight = 0, diagonal = 0;
};

// Exactly: the sign of da + db sqrt(2).
inline bool less(Counts a, Counts b) {
  const std::int64_t da = a.straight - b.straight, db = a.diagonal - b.diagonal;
  if (da <= 0 && db <= 0) return da < 0 || db < 0;
  if (da >= 0 && db >= 0) return false;
  return da < 0 ? da * da > 2 * db * db : da * da < 2 * db * db;
}

inline bool may_move(const OccupancyGrid& g, GridMoves moves, int r, int c, int dr, int dc) {
  if (!g.free(c, r) || !g.free(c + dc, r + dr)) return false;
  if (dr == 0 || dc == 0) return true;
  if (moves == GridMoves::four) return false;
  return moves == GridMoves::eight || (g.free(c + dc, r) && g.free(c, r + dr));
}

inline std::vector<std::optional<Counts>> brute_force(const OccupancyGrid& g, GridMoves moves, GridPlace from) {
  const int w = static_cast<int>(g.width), h = static_cast<int>(g.height);
  std::vector<std::optional<Counts>> cost(g.blocked.size());
  cost[from.row * g.width + from.column] = Counts{};
  for (bool changed = true; changed;) {
    changed = false;
    for (int r = 0; r < h; ++r)
      for (int c = 0; c < w; ++c)
        for (int dr = -1; dr <= 1; ++dr)
          for (int dc = -1; dc <= 1; ++dc) {
            const auto& here = cost[static_cast<std::size_t>(r * w + c)];
            if ((dr == 0 && dc == 0) || !here || !may_move(g, moves, r, c, dr, dc)) continue;
            auto& there = cost[static_cast<std::size_t>((r + dr) * w + c + dc)];
            const Counts through{here->straight + (dr == 0 || dc == 0), here->diagonal + (dr != 0 && dc != 0)};
            if (there && !less(through, *there)) continue;
            there = through;
            changed = true;
          }
  }
  return cost;
}

inline OccupancyGrid random_grid(Draws& draws, std::uint32_t most) {
  OccupancyGrid g{1 + draws.below(most), 1 + draws.below(most), {}};
  const std::uint32_t share = 5 + draws.below(50);
  for (std::uint32_t i = 0; i < g.width * g.height; ++i) g.blocked.push_back(draws.below(100) < share);
  return g;
}

inline GridPlace free_place(Draws& draws, OccupancyGrid& g) {
  const std::uint32_t row = draws.below(g.height);
  const std::uint32_t column = draws.below(g.width);
  g.blocked[row * g.width + column] = 0;
  return {row, column};
}

}  // namespace taut::test
