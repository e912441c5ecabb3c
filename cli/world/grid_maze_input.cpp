#include <taut/cli/world/grid_maze_input.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include <taut/cli/input.h>
#include <taut/geometry/errors.h>

namespace taut::cli {

namespace {

Format maze_format_of(const std::string& text) {
  constexpr std::array kMazes{Format::cell_values, Format::drawing, Format::maz, Format::num};
  const std::optional<Format> format = format_named(text);
  if (!format || std::ranges::find(kMazes, *format) == kMazes.end())
    throw UsageError("--format: '" + text + "' is not cells, drawing, maz or num");
  return *format;
}

}  // namespace

void add_maze_options(CommandLine& app, MazeOptions& options, const char* name) {
  app.add_option(name, options.file, "The maze to read; - is standard input").required();
  app.add_option_function(
         "--format", [&options](const std::string& text) { options.format = maze_format_of(text); },
         "What it is written in: cells, drawing, maz, num (default: found out from its content)")
      .type_name("NAME")
      .group("World");
}

GridMazeInput read_grid_maze(const std::string& file, std::optional<Format> format) {
  ReadNotes notes;
  ReadOptions options;
  options.format = format;
  const World world = read_world_of(file, options, notes);
  if (!world.grid())
    throw InputError(world.source(), 0,
                     fmt::format("is a world of {}, not a grid maze (cells, drawing, maz or num)", name(notes.format)));
  return {*world.grid(), world.source(), notes.unknown_walls};
}

std::string cell_text(Cell cell) { return fmt::format("({},{})", cell.x, cell.y); }

const char* side_name(Side side) {
  static constexpr const char* kNames[] = {"north", "east", "south", "west"};
  return kNames[static_cast<std::size_t>(side)];
}

std::string wall_text(const micromouse::CellSide& wall) { return cell_text(wall.cell) + " " + side_name(wall.side); }

}  // namespace taut::cli
