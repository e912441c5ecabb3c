// Grid maps as comma-separated values, and as drawings.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <taut/geometry/occupancy_grid.h>
#include <taut/search/grid/grid_moves.h>

namespace taut {

/// A grid and, where the file says so, where to go from and to.
struct GridTask {
  OccupancyGrid grid;
  std::optional<GridPlace> start;
  std::optional<GridPlace> goal;
};

/// `start,row,column` and `goal,row,column` (from 0, padded with empty fields), either or both of which may be missing,
/// then rows of 0 (free) and 1 (blocked), the top row first. CRLF, blank lines, blanks around fields and empty fields
/// at line ends are fine. Throws InputError with line and culprit: a line out of place, a number that is none, a row
/// shorter or longer than the first, a value other than 0 and 1, start or goal outside or blocked.
GridTask read_grid_csv(std::string_view text, const std::string& source);

/// Reads back the same. Precondition: start and goal are there.
std::string grid_csv_text(const GridTask& task);

/// Rows of characters, free ones of `._0` and blocked ones of `#X1@`, at most one `S` and one `G` (free), all of the
/// same length. Throws InputError.
GridTask read_grid_drawing(std::string_view text, const std::string& source);

/// Any of the above or a MovingAI map, by content: `type` begins a map; `start`, `goal` or a line with commas a csv,
/// anything else a drawing.
GridTask read_grid(std::string_view text, const std::string& source);

}  // namespace taut
