// Cells in messages.
#pragma once

#include <string>

#include <taut/geometry/errors.h>
#include <taut/search/grid/detail/grid_board.h>

namespace taut::detail {

/// `(row 3, column 5)`
inline std::string text(GridPlace p) {
  return "(row " + std::to_string(p.row) + ", column " + std::to_string(p.column) + ")";
}

/// Throws InputError when the place is outside or blocked; `what` is `start` or `goal`.
inline BoardCell free_cell(const GridBoard& board, GridPlace p, const char* what) {
  if (!board.contains(p))
    throw InputError("", 0,
                     std::string(what) + " " + text(p) + " is outside the grid of " + std::to_string(board.height()) +
                         " rows and " + std::to_string(board.width()) + " columns");
  const BoardCell c = board.cell(p);
  if (!board.free(c)) throw InputError("", 0, std::string(what) + " " + text(p) + " is blocked");
  return c;
}

}  // namespace taut::detail
