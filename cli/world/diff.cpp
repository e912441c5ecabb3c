// taut diff: in which walls do two mazes differ?
#include <fmt/format.h>

#include <algorithm>

#include <taut/cli/command.h>
#include <taut/cli/command_line.h>
#include <taut/cli/messages.h>
#include <taut/cli/run.h>
#include <taut/cli/world/grid_maze_input.h>
#include <taut/geometry/errors.h>

namespace taut::cli {

namespace {

using micromouse::CellSide;

struct DiffOptions {
  std::string a, b;
  CommonOptions common;
};

void add_options(CommandLine& app, DiffOptions& options) {
  app.add_option("A", options.a, "A grid maze, of any format; - is standard input").required();
  app.add_option("B", options.b, "Another one").required();
}

std::vector<CellSide> differing(const GridMaze& a, const GridMaze& b) {
  std::vector<CellSide> walls;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x)
      for (const Side side : kSides) {
        const CellSide wall{{x, y}, side};
        if (micromouse::canonical(wall) == wall && a.wall({x, y}, side) != b.wall({x, y}, side)) walls.push_back(wall);
      }
  return walls;
}

std::vector<Cell> goal_of(const GridMaze& maze) {
  std::vector<Cell> goal = maze.goal.empty() ? centre_room(maze.width(), maze.height()) : maze.goal;
  std::sort(goal.begin(), goal.end());
  return goal;
}

std::string text_of(const GridMazeInput& a, const GridMazeInput& b, const std::vector<CellSide>& walls) {
  std::string out;
  for (const CellSide& w : walls)
    out += fmt::format("{}: {} / {}\n", wall_text(w), a.maze.wall(w.cell, w.side) ? "wall" : "open",
                       b.maze.wall(w.cell, w.side) ? "wall" : "open");
  if (a.maze.start != b.maze.start)
    out += fmt::format("start: {} / {}\n", cell_text(a.maze.start), cell_text(b.maze.start));
  if (goal_of(a.maze) != goal_of(b.maze)) out += "the goals differ\n";
  return out + (walls.empty() ? "no wall differs\n"
                              : fmt::format("{} {}\n", count_text(walls.size(), "wall"),
                                            walls.size() == 1 ? "differs" : "differ"));
}

Json json_of(const GridMazeInput& a, const GridMazeInput& b, const std::vector<CellSide>& walls) {
  Json list = Json::array();
  for (const CellSide& w : walls)
    list.push_back({{"cell", {w.cell.x, w.cell.y}},
                    {"side", side_name(w.side)},
                    {"a", a.maze.wall(w.cell, w.side) ? "wall" : "open"},
                    {"b", b.maze.wall(w.cell, w.side) ? "wall" : "open"}});
  return {{"a", a.name},
          {"b", b.name},
          {"differ", walls.size()},
          {"same_start", a.maze.start == b.maze.start},
          {"same_goal", goal_of(a.maze) == goal_of(b.maze)},
          {"walls", list}};
}

std::string size_text(const GridMaze& maze) { return fmt::format("{} x {}", maze.width(), maze.height()); }

Answer different_sizes(const GridMazeInput& a, const GridMazeInput& b) {
  const std::string reason = fmt::format("the sizes differ: {} / {}", size_text(a.maze), size_text(b.maze));
  return {.outcome = Outcome::differs,
          .reason = reason,
          .result = {{"a", a.name},
                     {"b", b.name},
                     {"differ", nullptr},
                     {"size_a", {a.maze.width(), a.maze.height()}},
                     {"size_b", {b.maze.width(), b.maze.height()}}},
          .line = reason + "\n"};
}

Answer answer_of(const GridMazeInput& a, const GridMazeInput& b) {
  if (a.maze.width() != b.maze.width() || a.maze.height() != b.maze.height()) return different_sizes(a, b);
  const std::vector<CellSide> walls = differing(a.maze, b.maze);
  Answer answer{.result = json_of(a, b, walls), .line = text_of(a, b, walls)};
  if (walls.empty()) return answer;
  answer.outcome = Outcome::differs;
  answer.reason = count_text(walls.size(), "wall differs", "walls differ");
  return answer;
}

int run(const DiffOptions& options, Run& run) {
  run.sources({options.a, options.b});
  if (options.a == "-" && options.b == "-") throw InputError("<stdin>", 0, "cannot be both mazes");
  const auto read = [&](const std::string& file) { return run.stage("read", [&] { return read_grid_maze(file); }); };
  const GridMazeInput a = read(options.a), b = read(options.b);
  return run.end(answer_of(a, b));
}

}  // namespace

Command diff_command(CommandLine& app) {
  return command<DiffOptions>(app, "diff", "How many walls differ between two grid mazes; exit code 1 when any does",
                              add_options, run);
}

}  // namespace taut::cli
