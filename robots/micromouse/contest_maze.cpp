#include <taut/robots/micromouse/contest_maze.h>
#include <utility>
#include <vector>

#include <taut/geometry/draws.h>
#include <taut/geometry/maze_generator.h>
#include <taut/robots/micromouse/steps.h>

namespace taut::micromouse {

namespace {

using taut::Draws;

/// Interior walls that stand and that `wanted` accepts, in order of cells.
template <class Wanted>
std::vector<CellSide> walls_of(const GridMaze& maze, Wanted wanted) {
  std::vector<CellSide> walls;
  for (int y = 0; y < maze.height(); ++y)
    for (int x = 0; x < maze.width(); ++x)
      for (const Side side : {Side::north, Side::east}) {
        const CellSide wall{{x, y}, side};
        if (maze.contains(ahead(wall.cell, side)) && maze.wall(wall.cell, side) && wanted(wall)) walls.push_back(wall);
      }
  return walls;
}

void open(GridMaze& maze, const CellSide& wall) { maze.set_wall(wall.cell, wall.side, false); }

void close_room(GridMaze& maze, const Task& task, Draws& draws) {
  std::vector<CellSide> sides;
  for (const Cell c : task.goal)
    for (const Side side : kSides)
      if (!task.in_goal(ahead(c, side))) sides.push_back({c, side});
  for (const CellSide& s : sides) maze.set_wall(s.cell, s.side, true);
  open(maze, sides[draws.below(static_cast<std::uint32_t>(sides.size()))]);
}

/// Takes down drawn ones of these walls until every cell is reached; false when that is impossible.
template <class Wanted>
bool connect(GridMaze& maze, Wanted wanted, Draws& draws) {
  for (;;) {
    const StepField reached(passages_of(maze), {maze.start});
    const auto between = walls_of(maze, [&](const CellSide& w) {
      return wanted(w) && reached.reached(w.cell) != reached.reached(ahead(w.cell, w.side));
    });
    if (between.empty()) break;
    open(maze, between[draws.below(static_cast<std::uint32_t>(between.size()))]);
  }
  const StepField reached(passages_of(maze), {maze.start});
  for (int y = 0; y < maze.height(); ++y)
    for (int x = 0; x < maze.width(); ++x)
      if (!reached.reached({x, y})) return false;
  return true;
}

}  // namespace

std::optional<GridMaze> contest_maze(const ContestShape& shape, std::uint64_t seed) {
  GridMaze maze = generate_backtracker(shape.side, shape.side, seed);
  open_centre_room(maze);
  const Task task = task_of(maze);
  Draws draws(seed);
  if (shape.one_entrance) close_room(maze, task, draws);
  const auto free = [&](const CellSide& w) {
    return w.cell != task.start && !(shape.one_entrance && task.in_goal(w.cell) != task.in_goal(ahead(w.cell, w.side)));
  };
  if (!connect(maze, free, draws)) return std::nullopt;
  const auto all = [](const CellSide&) { return true; };
  const auto interior = 2.0 * shape.side * (shape.side - 1);
  auto spare = static_cast<int>(walls_of(maze, all).size()) - static_cast<int>(kContestWalls * interior);
  auto walls = walls_of(maze, free);
  for (std::size_t i = walls.size(); i-- > 1;)
    std::swap(walls[i], walls[draws.below(static_cast<std::uint32_t>(i + 1))]);
  for (auto wall = walls.begin(); wall != walls.end() && spare > 0; ++wall) {
    open(maze, *wall);
    --spare;
    if (*optimum(passages_of(maze), task) >= shape.steps) continue;
    maze.set_wall(wall->cell, wall->side, true);
    ++spare;
  }
  if (spare > 0 || *optimum(passages_of(maze), task) < shape.steps) return std::nullopt;
  return maze;
}

}  // namespace taut::micromouse
