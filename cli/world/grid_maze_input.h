// Grid mazes as the options ask for them, and words for their cells.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include <taut/cli/command_line.h>
#include <taut/geometry/grid_maze.h>
#include <taut/io/worlds/read_world.h>
#include <taut/robots/micromouse/rules.h>

namespace taut::cli {

/// Which maze, and what it is written in.
struct MazeOptions {
  std::string file;
  std::optional<Format> format;
};

/// A grid maze, read.
struct GridMazeInput {
  GridMaze maze;
  std::string name;               ///< of the file; `<stdin>`
  std::size_t unknown_walls = 0;  ///< nobody has looked at, read as open
};

void add_maze_options(CommandLine& app, MazeOptions& options, const char* name = "MAZE");

/// Throws InputError, also when the file is readable but describes no grid maze.
GridMazeInput read_grid_maze(const std::string& file, std::optional<Format> format = std::nullopt);

/// `(3,4)`; `(3,4) north`
std::string cell_text(Cell cell);
std::string wall_text(const micromouse::CellSide& wall);
const char* side_name(Side side);

}  // namespace taut::cli
