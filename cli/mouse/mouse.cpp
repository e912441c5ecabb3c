#include <taut/cli/command_line.h>
#include <taut/cli/mouse/mouse.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include <taut/cli/input.h>
#include <taut/cli/messages.h>
#include <taut/cli/run.h>
#include <taut/geometry/errors.h>

namespace taut::cli {

namespace {

using micromouse::Explorer;

template <typename Visit>
void for_each_border_side(const GridMaze& maze, Visit visit) {
  for (int x = 0; x < maze.width(); ++x) visit(Cell{x, 0}, Side::south), visit(Cell{x, maze.height() - 1}, Side::north);
  for (int y = 0; y < maze.height(); ++y) visit(Cell{0, y}, Side::west), visit(Cell{maze.width() - 1, y}, Side::east);
}

std::string explorer_names() {
  std::string names;
  for (const Explorer e : micromouse::all_explorers())
    names += (names.empty() ? "" : ", ") + std::string(micromouse::name(e));
  return names;
}

}  // namespace

void add_max_steps_option(CommandLine& app, int& max_steps) {
  app.add_option("--max-steps", max_steps, "Of both runs together (default: 1000)")
      .type_name("N")
      .range(1, 1'000'000)
      .group("Robot");
}

void add_explorer_options(CommandLine& app, Explorer& explorer) {
  const auto take = [&explorer](const std::string& word) { explorer = explorer_of(word, "--explorer"); };
  app.add_option_function("--explorer", take, "How run 1 explores (default: score)").type_name("NAME").group("Robot");
  app.renamed("--mode", "--explorer");
  explain_explorers(app);
}

void explain_explorers(CommandLine& app) {
  app.explain("Explorers", {{"random", "an open direction and 1 to 3 cells, drawn (--seed)"},
                            {"wall", "keeps the wall to its left; may circle for ever"},
                            {"dfs", "into a cell not yet visited, the one nearer to the goal first, else back"},
                            {"bfs", "to the nearest unvisited cell, until none is left or the steps get short"},
                            {"flood", "along the fewest steps to the goal, unknown walls taken for open"},
                            {"astar", "the same by the fewest cells, from where it stands"},
                            {"plain-prove", "flood, then to the nearest cell beside an unknown wall of the best route"},
                            {"prove", "where a look most likely cuts a shorter plan, until the optimum is proven"},
                            {"score", "the same, until knowing more no longer pays its thirtieths"}});
}

Explorer explorer_of(const std::string& word, const char* option) {
  const std::optional<Explorer> explorer = micromouse::explorer_named(word);
  if (!explorer) throw UsageError(std::string(option) + ": '" + word + "' is not one of " + explorer_names());
  return *explorer;
}

GridMazeInput read_mouse_maze(const std::string& file, std::optional<Format> format) {
  GridMazeInput read = read_grid_maze(file, format);
  if (const std::size_t open = border_openings(read.maze); open > 0) {
    note(fmt::format("taut: {}: the border has {}: closed, as a micromouse maze has none", read.name,
                     count_text(open, "opening")));
    for_each_border_side(read.maze, [&](Cell c, Side side) { read.maze.set_wall(c, side, true); });
  }
  if (read.unknown_walls > 0)
    note(fmt::format("taut: {}: {} in the drawing, taken as open", read.name,
                     count_text(read.unknown_walls, "unknown wall")));
  try {
    micromouse::task_of(read.maze);
  } catch (const InputError& error) {
    throw InputError(read.name, 0, error.what());
  }
  return read;
}

std::size_t border_openings(const GridMaze& maze) {
  std::size_t open = 0;
  for_each_border_side(maze, [&](Cell c, Side side) { open += maze.wall(c, side) ? 0U : 1U; });
  return open;
}

int no_route(const std::string& name, Run& run) {
  const std::string why = "the maze has no way from the start to the goal";
  complain(name + ": " + why);
  return run.end({.outcome = Outcome::none, .reason = why});
}

std::vector<Command> mouse_commands(CommandLine& app) {
  CommandLine group = command_group(app, "mouse", "Micromouse: explore an unknown maze, then race through it");
  std::vector<Command> commands;
  commands.push_back(mouse_run_command(group));
  commands.push_back(mouse_compare_command(group));
  commands.push_back(mouse_check_command(group));
  commands.push_back(mouse_serve_command(group));
  commands.push_back(mouse_speed_command(group));
  return commands;
}

}  // namespace taut::cli
