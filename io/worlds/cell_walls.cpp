#include <taut/io/worlds/detail/cell_walls.h>

#include <algorithm>

#include <taut/geometry/errors.h>
#include <taut/geometry/text.h>

namespace taut::detail {

namespace {

std::string direction(Side side) {
  switch (side) {
    case Side::north: return "upwards";
    case Side::east: return "to the right";
    case Side::south: return "downwards";
    case Side::west: return "to the left";
  }
  return {};
}

[[noreturn]] void fail_pair(const CellWalls& cells, Cell c, Cell next, Side side, const std::string& source) {
  const bool wall = cells.wall(c, side);
  throw InputError(source, std::max(cells.line(c), cells.line(next)),
                   "cell " + text(c) + " says " + (wall ? "wall " : "open ") + direction(side) + ", cell " +
                       text(next) + " says " + (wall ? "open" : "wall"));
}

Side opposite(Side side) { return kSides[(static_cast<std::size_t>(side) + 2) % 4]; }

}  // namespace

GridMaze agreed(const CellWalls& cells, bool closed, const std::string& source) {
  GridMaze maze(cells.width(), cells.height(), true);
  for (int x = 0; x < cells.width(); ++x)
    for (int y = 0; y < cells.height(); ++y)
      for (Side side : kSides) {
        const Cell c{x, y}, next = GridMaze::neighbour(c, side);
        const bool wall = cells.wall(c, side);
        if (!maze.contains(next) && closed && !wall)
          throw InputError(source, cells.line(c),
                           "cell " + text(c) + " is open " + direction(side) + ", but the border is closed");
        if (maze.contains(next) && (side == Side::north || side == Side::east) &&
            cells.wall(next, opposite(side)) != wall)
          fail_pair(cells, c, next, side, source);
        maze.set_wall(c, side, wall);
      }
  return maze;
}

int count_openings(const GridMaze& maze) {
  int open = 0;
  for (int x = 0; x < maze.width(); ++x)
    open += !maze.wall({x, 0}, Side::south) + !maze.wall({x, maze.height() - 1}, Side::north);
  for (int y = 0; y < maze.height(); ++y)
    open += !maze.wall({0, y}, Side::west) + !maze.wall({maze.width() - 1, y}, Side::east);
  return open;
}

}  // namespace taut::detail
