// Worlds that several benches run in.
#pragma once

#include <memory>
#include <utility>

#include <taut/geometry/maze_generator.h>
#include <taut/geometry/occupancy_world.h>
#include <taut/geometry/world.h>

namespace taut::bench {

/// A perfect maze of cells x cells unit cells with a part of its inner walls taken out: 0 leaves it perfect.
inline World opened_maze(int cells, double opened) {
  auto maze = std::make_shared<GridMaze>(generate_backtracker(cells, cells, 1));
  open_walls(*maze, opened, 1);
  return world_of(std::move(maze));
}

/// The same maze as a grid map: walls one cell thick, corridors `wide` cells wide.
inline World opened_block_maze(int cells, int wide, double opened) {
  GridMaze maze = generate_backtracker(cells, cells, 1);
  open_walls(maze, opened, 1);
  const int pitch = wide + 1, side = cells * pitch + 1;
  OccupancyGrid grid{static_cast<std::uint32_t>(side), static_cast<std::uint32_t>(side), {}};
  const auto blocked = [&](int x, int y) {
    const bool in_column = x % pitch == 0, in_row = y % pitch == 0;
    if (in_column && in_row) return true;
    const Cell cell{(x - in_column) / pitch, (y - in_row) / pitch};
    if (in_column) return x == 0 || maze.wall(cell, Side::east);
    return in_row && (y == 0 || maze.wall(cell, Side::north));
  };
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) grid.blocked.push_back(blocked(x, y));
  return world_of(grid);
}

/// The same walls turned by an angle whose sine and cosine are 5/13 and 12/13: none is axis-parallel.
inline World turned(const World& straight) {
  const auto turn = [](Point p) { return Point{(12 * p.x - 5 * p.y) / 13, (5 * p.x + 12 * p.y) / 13}; };
  WorldParts parts;
  for (const Wall& wall : straight.walls()) parts.walls.push_back({turn(wall.a), turn(wall.b), wall.thickness, 0});
  return World(parts);
}

}  // namespace taut::bench
