// A grid with a rim of blocked cells around it, moves looked up in a byte a cell.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include <taut/geometry/occupancy_grid.h>
#include <taut/search/grid/grid_cost.h>
#include <taut/search/grid/grid_moves.h>

namespace taut::detail {

/// A cell of a GridBoard; 0 is in the rim and stands for none.
using BoardCell = std::uint32_t;

class GridBoard {
 public:
  /// Throws InputError as GridSearch does.
  GridBoard(const OccupancyGrid& grid, GridMoves moves);

  // Moves by number, in the order of GridMoves.
  static constexpr std::array<int, 8> kColumn{1, 0, -1, 0, 1, -1, -1, 1};
  static constexpr std::array<int, 8> kRow{0, 1, 0, -1, 1, 1, -1, -1};
  static constexpr std::int64_t cost(unsigned move) { return move < 4 ? GridCost::kStraight : GridCost::kDiagonal; }

  GridMoves moves() const { return moves_; }
  std::uint32_t width() const { return width_; }
  std::uint32_t height() const { return height_; }
  std::size_t size() const { return free_.size(); }  ///< with the rim
  std::int64_t step(unsigned move) const { return step_[move]; }

  bool free(BoardCell c) const { return free_[c] != 0; }
  bool free(std::int64_t c) const { return free_[static_cast<std::size_t>(c)] != 0; }
  /// Bit i: move i may be made here.
  std::uint8_t moves_from(BoardCell c) const { return mask_[c]; }
  bool may(BoardCell c, unsigned move) const { return (mask_[c] >> move & 1) != 0; }
  BoardCell moved(BoardCell c, unsigned move) const { return static_cast<BoardCell>(c + step_[move]); }

  BoardCell cell(GridPlace p) const { return (p.row + 1) * stride_ + p.column + 1; }
  GridPlace place(BoardCell c) const { return {c / stride_ - 1, c % stride_ - 1}; }
  bool contains(GridPlace p) const { return p.row < height_ && p.column < width_; }

  /// Calls look(move, neighbour) in the order of the moves.
  template <typename Look>
  void for_neighbours(BoardCell c, Look look) const {
    for (unsigned rest = mask_[c]; rest != 0; rest &= rest - 1) {
      const auto move = static_cast<unsigned>(std::countr_zero(rest));
      look(move, moved(c, move));
    }
  }

 private:
  std::uint8_t mask_of(BoardCell c) const;

  std::uint32_t width_;
  std::uint32_t height_;
  std::uint32_t stride_;
  GridMoves moves_;
  std::array<std::int64_t, 8> step_{};
  std::vector<std::uint8_t> free_;
  std::vector<std::uint8_t> mask_;
};

/// The number of the move in this direction, each of dc, dr in -1 .. 1, not both 0.
constexpr unsigned move_towards(int dc, int dr) {
  for (unsigned i = 0; i < 8; ++i)
    if (GridBoard::kColumn[i] == dc && GridBoard::kRow[i] == dr) return i;
  return 8;
}

}  // namespace taut::detail
