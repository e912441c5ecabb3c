// A grid with a search on it, from the ground up.
#pragma once

#include <string>
#include <vector>

#include <taut/io/pictures/detail/svg_frame.h>
#include <taut/io/pictures/grid_svg.h>

namespace taut::detail {

inline constexpr double kGridPlaySeconds = 8;  ///< of a film, until all cells are there
inline constexpr double kGridPathSeconds = 2;  ///< then, until the path is

/// The groups of a grid_svg(), `cell` pixels a cell, its north-west corner there. `grid` and `picture` must outlive it.
class GridDrawing {
 public:
  GridDrawing(const OccupancyGrid& grid, const GridPicture& picture, double cell, Point corner)
      : grid_(grid), what_(picture), cell_(cell), corner_(corner) {}

  std::string text();

  /// Rules for the page's head.
  static std::string style();
  /// The legend for what this picture shows.
  static std::vector<SvgKey> keys(const GridPicture& picture);

 private:
  static constexpr std::uint8_t kFree = 255, kBlocked = 254;

  void cells();
  void lines();
  void frontier();
  void path();
  void ends();
  std::string appears(double seconds) const;
  std::size_t index(GridPlace p) const { return std::size_t{p.row} * grid_.width + p.column; }

  const OccupancyGrid& grid_;
  const GridPicture& what_;
  double cell_;
  Point corner_;
  std::string out_;
};

}  // namespace taut::detail
