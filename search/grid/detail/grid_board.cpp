#include <taut/search/grid/detail/grid_board.h>

#include <string>

#include <taut/geometry/errors.h>

namespace taut::detail {

namespace {

constexpr std::uint64_t kMostCells = 400'000'000;  // so that GridCost's order is exact and cells fit 32 bits

void check(const OccupancyGrid& grid) {
  const std::uint64_t cells = std::uint64_t{grid.width} * grid.height;
  const std::string size = std::to_string(grid.width) + " x " + std::to_string(grid.height);
  if (cells == 0) throw InputError("", 0, "a grid of " + size + " has no cell");
  if (cells > kMostCells) throw InputError("", 0, "a grid of " + size + " is too large, at most 400000000 cells");
  if (grid.blocked.size() != cells)
    throw InputError("", 0, "a grid of " + size + " with " + std::to_string(grid.blocked.size()) + " cells");
}

}  // namespace

GridBoard::GridBoard(const OccupancyGrid& grid, GridMoves moves)
    : width_(grid.width), height_(grid.height), stride_(grid.width + 2), moves_(moves) {
  check(grid);
  for (unsigned i = 0; i < 8; ++i) step_[i] = kColumn[i] + std::int64_t{stride_} * kRow[i];
  free_.assign(std::size_t{stride_} * (height_ + 2), 0);
  mask_.assign(free_.size(), 0);
  for (std::uint32_t row = 0; row < height_; ++row)
    for (std::uint32_t column = 0; column < width_; ++column)
      free_[cell({row, column})] = grid.blocked[std::size_t{row} * width_ + column] == 0;
  for (std::uint32_t row = 0; row < height_; ++row)
    for (BoardCell c = cell({row, 0}), end = c + width_; c < end; ++c)
      if (free(c)) mask_[c] = mask_of(c);
}

std::uint8_t GridBoard::mask_of(BoardCell c) const {
  unsigned mask = 0;
  const unsigned count = moves_ == GridMoves::four ? 4 : 8;
  for (unsigned i = 0; i < count; ++i) {
    if (!free(moved(c, i))) continue;
    const bool beside =
        i < 4 || moves_ == GridMoves::eight || (free(c + kColumn[i]) && free(c + step_[i] - kColumn[i]));
    if (beside) mask |= 1U << i;
  }
  return static_cast<std::uint8_t>(mask);
}

}  // namespace taut::detail
