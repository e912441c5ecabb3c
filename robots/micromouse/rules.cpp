#include <taut/robots/micromouse/rules.h>

#include <algorithm>
#include <string>

#include <taut/geometry/errors.h>

namespace taut::micromouse {

namespace {

constexpr int kLargestSide = 256;

std::string text(Cell c) { return "(" + std::to_string(c.x) + "," + std::to_string(c.y) + ")"; }

void admit_border(const GridMaze& maze) {
  for (int y = 0; y < maze.height(); ++y)
    for (int x = 0; x < maze.width(); ++x)
      for (const Side side : kSides)
        if (!maze.contains(GridMaze::neighbour({x, y}, side)) && !maze.wall({x, y}, side))
          throw InputError("", 0,
                           "cell " + text({x, y}) + " is open to the outside: a micromouse maze has a closed border");
}

}  // namespace

bool Task::in_goal(Cell c) const { return std::binary_search(goal.begin(), goal.end(), c); }

Task task_of(const GridMaze& maze, int max_steps) {
  if (std::max(maze.width(), maze.height()) > kLargestSide)
    throw InputError("", 0,
                     "maze of " + std::to_string(maze.width()) + " x " + std::to_string(maze.height()) +
                         " cells: a micromouse maze has at most 256 a side");
  Task task{maze.width(), maze.height(), maze.start, maze.goal, max_steps};
  if (task.goal.empty()) task.goal = centre_room(maze.width(), maze.height());
  std::sort(task.goal.begin(), task.goal.end());
  task.goal.erase(std::unique(task.goal.begin(), task.goal.end()), task.goal.end());
  if (!maze.contains(task.start)) throw InputError("", 0, "start " + text(task.start) + " lies outside the maze");
  for (const Cell c : task.goal)
    if (!maze.contains(c)) throw InputError("", 0, "goal cell " + text(c) + " lies outside the maze");
  admit_border(maze);
  return task;
}

Cell ahead(Cell cell, Side side, int count) {
  switch (side) {
    case Side::north: return {cell.x, cell.y + count};
    case Side::east: return {cell.x + count, cell.y};
    case Side::south: return {cell.x, cell.y - count};
    case Side::west: return {cell.x - count, cell.y};
  }
  return cell;
}

CellSide canonical(CellSide wall) {
  if (wall.side == Side::south && wall.cell.y > 0) return {ahead(wall.cell, Side::south), Side::north};
  if (wall.side == Side::west && wall.cell.x > 0) return {ahead(wall.cell, Side::west), Side::east};
  return wall;
}

}  // namespace taut::micromouse
