// Mazes for the micromouse tests.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <taut/geometry/errors.h>
#include <taut/geometry/maze_generator.h>
#include <taut/io/worlds/read_world.h>
#include <taut/robots/micromouse/contest_maze.h>
#include <taut/robots/micromouse/steps.h>

#include "support/paths.h"

namespace taut::micromouse {

inline GridMaze drawn(const std::string& drawing) { return *read_world(drawing).grid(); }

/// Of the interior cell sides 38 % are walls.
inline GridMaze generated(int n, std::uint64_t seed) {
  GridMaze maze = generate_backtracker(n, n, seed);
  open_walls(maze, 1 - 0.38 * 2 * n / (n - 1.0), seed);
  open_centre_room(maze);
  return maze;
}

/// Sides of 12, 14 and 16 in turn, with routes of 17 to 25 steps.
inline std::vector<GridMaze> contest_mazes(int count, std::uint64_t first) {
  std::vector<GridMaze> mazes;
  for (std::uint64_t seed = first; static_cast<int>(mazes.size()) < count; ++seed) {
    const std::array<ContestShape, 3> shapes{{{12, 17}, {14, 22}, {16, 25}}};
    if (const auto maze = contest_maze(shapes[mazes.size() % 3], seed)) mazes.push_back(*maze);
  }
  return mazes;
}

inline GridMaze maze_in(const std::filesystem::path& file) { return *read_world_file(file.string()).grid(); }

/// A maze of 12 x 12 by others, where the shared data are.
inline std::optional<GridMaze> first_of_the_course() {
  if (const auto shared = test::shared_data_dir()) return maze_in(*shared / "micromouse" / "test_maze_01.txt");
  return std::nullopt;
}

/// Of the shared mazes of competitions, those of 16 x 16 and less that have a route; every `nth` of them.
inline std::vector<GridMaze> competition(std::size_t nth = 1) {
  const auto files = test::shared_files("micromouse/competition");
  std::vector<GridMaze> mazes;
  for (std::size_t i = 0; i < files.size(); i += nth) {
    try {
      const auto grid = read_world_file(files[i].string()).grid();
      if (grid && grid->width() <= 16 && optimum(passages_of(*grid), task_of(*grid))) mazes.push_back(*grid);
    } catch (const InputError&) {
    }
  }
  return mazes;
}

}  // namespace taut::micromouse
