// Cells of a grid, and which moves lead from one to the next.
#pragma once
#include <compare>
#include <cstdint>
#include <optional>
#include <string_view>

namespace taut {

/// A cell as grid files name it: row 0 is the top one. Ordered by row, then column.
struct GridPlace {
  std::uint32_t row = 0;
  std::uint32_t column = 0;

  friend constexpr auto operator<=>(const GridPlace&, const GridPlace&) = default;
};

/// Which neighbours a free cell has, all of them free. They are looked at in the order right, down, left, up, then
/// (where there are eight) right-down, left-down, left-up, right-up.
enum class GridMoves {
  four,    ///< unit moves
  eight,   ///< diagonal moves as well, past blocked cells and between two of them
  octile,  ///< diagonal moves only if both cells beside the move are free (MovingAI's rule)
};

/// `4`, `8`, `octile`
std::string_view name(GridMoves moves);
/// Nothing for any other word.
std::optional<GridMoves> grid_moves_named(std::string_view word);

}  // namespace taut
