// What formats that list the four sides of every cell have in common.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <taut/geometry/grid_maze.h>

namespace taut::detail {

/// The sides of each cell as its own entry in a file tells them.
class CellWalls {
 public:
  CellWalls(int width, int height)
      : width_(width),
        height_(height),
        walls_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)),
        lines_(walls_.size()) {}

  int width() const { return width_; }
  int height() const { return height_; }

  /// Bit i of `walls`: the side Side(i) is a wall. `line`: where the file says so, 0 unknown.
  void set(Cell c, std::uint8_t walls, int line) {
    walls_[index(c)] = walls;
    lines_[index(c)] = line;
  }
  bool wall(Cell c, Side side) const { return (walls_[index(c)] >> static_cast<int>(side)) & 1; }
  int line(Cell c) const { return lines_[index(c)]; }

 private:
  std::size_t index(Cell c) const {
    return static_cast<std::size_t>(c.x) * static_cast<std::size_t>(height_) + static_cast<std::size_t>(c.y);
  }

  int width_;
  int height_;
  std::vector<std::uint8_t> walls_;
  std::vector<int> lines_;
};

/// The maze when every two neighbours agree; else InputError with both cells and the later line of theirs. With
/// `closed` an open border is an error too. Start and goal are left as GridMaze sets them.
GridMaze agreed(const CellWalls& cells, bool closed, const std::string& source);

/// How many sides of the border are open.
int count_openings(const GridMaze& maze);

}  // namespace taut::detail
