// Pictures of searches on grids.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include <taut/geometry/occupancy_grid.h>
#include <taut/search/grid/grid_moves.h>

namespace taut {

/// What to draw over a grid. Recorded as GridResult does.
struct GridPicture {
  std::string title;
  std::vector<std::string> facts;
  std::vector<GridPlace> visited;   ///< shaded by order, the first darkest
  std::vector<GridPlace> frontier;  ///< outlined
  std::vector<GridPlace> path;
  std::optional<GridPlace> start;
  std::optional<GridPlace> goal;
  /// Plays in a browser: cells appear in their order within 8 seconds, then the path is drawn. Can be paused.
  bool animated = false;
};

/// One SVG document, row 0 at the top. Cells in a row with one colour are one rectangle, and 64 colours, dark blue to
/// yellow, stand for the order, so that the size grows with the outline of what was visited, not with its cells. Same
/// input, same bytes.
std::string grid_svg(const OccupancyGrid& grid, const GridPicture& picture);

/// Searches of one grid side by side on a page of 1000 pixels' width: a panel for each, its title above and its facts
/// below, in letters of 15 pixels; one legend, `title` and `facts` head it. Films stand still. Same input, same bytes.
std::string grid_comparison_svg(const OccupancyGrid& grid, std::span<const GridPicture> pictures,
                                const std::string& title, const std::vector<std::string>& facts);

}  // namespace taut
