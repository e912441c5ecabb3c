// A page with a micromouse maze on it, as such mazes are drawn: north up, posts as small squares, walls between them.
#pragma once

#include <string>
#include <vector>

#include <taut/geometry/grid_maze.h>
#include <taut/geometry/point.h>
#include <taut/io/pictures/detail/svg_frame.h>
#include <taut/robots/micromouse/rules.h>

namespace taut::detail {

/// Layout and parts of the drawing. Every part is SVG text for between head() and foot(); colours come from the style
/// in head() and follow prefers-color-scheme. Same input, same bytes.
class MouseSheet {
 public:
  MouseSheet(const GridMaze& maze, std::string title, std::vector<std::string> facts, std::vector<SvgKey> keys);

  std::string head() const;      ///< up to and with the floor
  std::string controls() const;  ///< of a film, before the foot
  std::string foot() const { return frame_.foot(); }

  /// The middle of a cell in pixels, or any point whose unit is a cell and whose origin is the lower left corner.
  Point pixel(Cell cell) const;
  Point pixel(Point p) const;

  std::string posts() const;
  std::string goal_room() const;  ///< tinted
  std::string ends() const;       ///< markers of start and goal, the latter in the middle of its room

  /// Path data.
  std::string wall(const micromouse::CellSide& wall) const;
  std::string square(Cell cell) const;
  std::string line(const std::vector<Point>& points) const;  ///< in cells

  /// The mouse as a wedge that looks up, around (0, 0); degrees are clockwise.
  std::string wedge() const;
  std::string placed(Cell cell, double degrees) const;  ///< the value of a transform attribute

  static std::string group(const std::string& name, const std::string& content);
  static std::string path(const std::string& data);

 private:
  std::string style() const;
  std::vector<Cell> goal_cells() const;

  GridMaze maze_;
  double pitch_;
  SvgFrame frame_;
};

/// All standing walls of a maze, each once, by rows from the south.
std::vector<micromouse::CellSide> standing_walls(const GridMaze& maze);

/// The middles of cells.
Point middle(Cell cell);

}  // namespace taut::detail
