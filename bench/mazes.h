// Worlds that several benches run in.
#pragma once

#include <memory>
#include <utility>

#include <taut/geometry/maze_generator.h>
#include <taut/geometry/world.h>

namespace taut::bench {

/// A perfect maze of cells x cells unit cells with a part of its inner walls taken out: 0 leaves it perfect.
inline World opened_maze(int cells, double opened) {
  auto maze = std::make_shared<GridMaze>(generate_backtracker(cells, cells, 1));
  open_walls(*maze, opened, 1);
  return world_of(std::move(maze));
}

/// The same walls turned by an angle whose sine and cosine are 5/13 and 12/13: none is axis-parallel.
inline World turned(const World& straight) {
  const auto turn = [](Point p) { return Point{(12 * p.x - 5 * p.y) / 13, (5 * p.x + 12 * p.y) / 13}; };
  WorldParts parts;
  for (const Wall& wall : straight.walls()) parts.walls.push_back({turn(wall.a), turn(wall.b), wall.thickness, 0});
  return World(parts);
}

}  // namespace taut::bench
