// What the subcommands of `taut mouse` share.
#pragma once

#include <optional>
#include <string>

#include <taut/cli/command.h>
#include <taut/cli/command_line.h>
#include <taut/cli/world/grid_maze_input.h>
#include <taut/robots/micromouse/explorers.h>
#include <taut/robots/micromouse/rules.h>

namespace taut::cli {

void add_max_steps_option(CommandLine& app, int& max_steps);
/// And the lines that say what each explorer does.
void add_explorer_options(CommandLine& app, micromouse::Explorer& explorer);
void explain_explorers(CommandLine& app);

/// `flood`, or a UsageError that says what there is.
micromouse::Explorer explorer_of(const std::string& word, const char* option);

/// read_grid_maze, as a micromouse runs in it: where the border has openings they are closed, and a note says so. Also
/// throws what task_of throws.
GridMazeInput read_mouse_maze(const std::string& file, std::optional<Format> format = std::nullopt);

/// How many sides of the border are open.
std::size_t border_openings(const GridMaze& maze);

/// Says on stderr that the maze has no way to the goal, and ends the run: exit code 1.
int no_route(const std::string& name, Run& run);

Command mouse_run_command(CommandLine& group);
Command mouse_compare_command(CommandLine& group);
Command mouse_check_command(CommandLine& group);
Command mouse_serve_command(CommandLine& group);
Command mouse_speed_command(CommandLine& group);

}  // namespace taut::cli
