// What the subcommands of `taut mouse` share.
#pragma once

#include <optional>
#include <string>

#include <taut/cli/command.h>
#include <taut/cli/command_line.h>
#include <taut/geometry/grid_maze.h>
#include <taut/io/worlds/read_world.h>
#include <taut/robots/micromouse/explorers.h>
#include <taut/robots/micromouse/rules.h>

namespace taut::cli {

/// Which maze, and what it is written in.
struct MazeOptions {
  std::string file;
  std::optional<Format> format;
};

/// A grid maze, read.
struct MouseMaze {
  GridMaze maze;
  std::string name;               ///< of the file; `<stdin>`
  std::size_t unknown_walls = 0;  ///< nobody has looked at, read as open
};

void add_maze_options(CommandLine& app, MazeOptions& options, const char* name = "MAZE");
void add_max_steps_option(CommandLine& app, int& max_steps);
/// And the lines that say what each explorer does.
void add_explorer_options(CommandLine& app, micromouse::Explorer& explorer);
void explain_explorers(CommandLine& app);

/// `flood`, or a UsageError that says what there is.
micromouse::Explorer explorer_of(const std::string& word, const char* option);

/// Throws InputError, also when the file is readable but describes no grid maze.
MouseMaze read_grid_maze(const std::string& file, std::optional<Format> format = std::nullopt);

/// The same as a micromouse runs in: where the border has openings they are closed, and a note says so. Also throws
/// what task_of throws.
MouseMaze read_mouse_maze(const std::string& file, std::optional<Format> format = std::nullopt);

/// How many sides of the border are open.
std::size_t border_openings(const GridMaze& maze);

/// `(3,4)`; `(3,4) north`
std::string cell_text(Cell cell);
std::string wall_text(const micromouse::CellSide& wall);
const char* side_name(Side side);

/// Says on stderr that the maze has no way to the goal, and ends the run: exit code 1.
int no_route(const std::string& name, Run& run);

Command mouse_run_command(CommandLine& group);
Command mouse_compare_command(CommandLine& group);
Command mouse_check_command(CommandLine& group);
Command mouse_serve_command(CommandLine& group);
Command mouse_speed_command(CommandLine& group);

}  // namespace taut::cli
