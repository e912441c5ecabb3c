// taut generate: mazes from a seed.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <memory>
#include <string_view>
#include <utility>

#include <taut/cli/command.h>
#include <taut/cli/command_line.h>
#include <taut/cli/messages.h>
#include <taut/cli/run.h>
#include <taut/geometry/errors.h>
#include <taut/geometry/maze_generator.h>
#include <taut/io/worlds/roadblock_map.h>
#include <taut/io/worlds/write_world.h>
#include <taut/robots/roadblocks/roadblock_map_generator.h>

namespace taut::cli {

namespace {

struct Size {
  int width = 0;
  int height = 0;
};

enum class Kind : std::uint8_t { biased, backtracker, roadblocks };

struct GenerateOptions {
  Size size;
  Kind kind = Kind::biased;
  int roadblocks = 4;
  int samples = 10;
  int lane = roadblocks::kLeastLane;
  double loops = 0;
  Format format = Format::segments;
  std::string file = "-";
  CommonOptions common;
};

Size size_of(const std::string& text) {
  const auto number = [&](std::string_view part) {
    int value = 0;
    const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), value);
    if (error != std::errc{} || end != part.data() + part.size() || value < 1 || value > 20000)
      throw UsageError("--size: '" + text + "' is not WIDTHxHEIGHT or N, of 1 to 20000");
    return value;
  };
  const std::size_t by = text.find('x');
  if (by == std::string::npos) return {number(text), number(text)};
  return {number(std::string_view(text).substr(0, by)), number(std::string_view(text).substr(by + 1))};
}

constexpr std::array<std::string_view, 3> kKinds{"biased", "backtracker", "roadblocks"};

Kind kind_of(const std::string& text) {
  const auto at = std::ranges::find(kKinds, text);
  if (at == kKinds.end()) throw UsageError("--kind: '" + text + "' is not biased, backtracker or roadblocks");
  return static_cast<Kind>(at - kKinds.begin());
}

double loops_of(const std::string& text) {
  const double share = number_of(text, "--loops");
  if (share < 0 || share > 1) throw UsageError("--loops: '" + text + "' is not a share of 0 to 1");
  return share;
}

// Options that would be without effect, or mazes that a format cannot hold.
void check(const CommandLine& app, const GenerateOptions& options) {
  const bool roadblocks = options.kind == Kind::roadblocks;
  if (roadblocks && app.count("--as") + app.count("--loops") > 0)
    throw UsageError("--kind roadblocks writes maps of a format of their own: not with --as or --loops");
  if (!roadblocks && app.count("--roadblocks") + app.count("--samples") + app.count("--lane") > 0)
    throw UsageError("--roadblocks, --samples and --lane need --kind roadblocks");
  if (options.kind == Kind::biased && options.format == Format::cell_values)
    throw UsageError("--as cells knows no openings in the border: take --kind backtracker");
}

void add_options(CommandLine& app, GenerateOptions& options) {
  const auto add = [&](const char* name, auto& value, auto parse, const char* type, const char* description) {
    return app
        .add_option_function(
            name, [&value, parse](const std::string& text) { value = parse(text); }, description)
        .type_name(type)
        .group("Maze");
  };
  add("--size", options.size, size_of, "WxH", "Width and height in cells, or one number for both").required();
  add("--kind", options.kind, kind_of, "NAME",
      "biased (default): a spanning tree of varied texture, open at two corners; backtracker: long corridors, closed, "
      "goal top right; roadblocks: rooms and narrow lanes for taut drive, 24 or more a side");
  app.add_option("--roadblocks", options.roadblocks,
                 "With --kind roadblocks: how many, fewer only where all lanes are full (default: 4)")
      .group("Maze");
  app.add_option("--samples", options.samples, "With --kind roadblocks: how many (default: 10)").group("Maze");
  app.add_option(
         "--lane", options.lane,
         "With --kind roadblocks: cells across the narrowest lanes, 2 (default) to 6; where walls are squares the "
         "car needs 3")
      .group("Maze");
  add("--loops", options.loops, loops_of, "SHARE", "Take down this share of the inner walls, 0 to 1 (default: 0)");
  add("--as", options.format, format_of, "NAME",
      "segments (default), drawing, cells, maz, num, wkt, geojson; in cells, maz and num the goal is the room in the "
      "middle");
  app.add_option("-o,--output", options.file, "Write to this file instead of standard output")
      .type_name("FILE")
      .group("Maze");
  app.renamed("--format", "--as");
  app.callback([&app, &options] { check(app, options); });
  app.example("taut generate --size 45x45 --seed 1 --loops 0.1 -o maze.txt");
}

GridMaze maze_of(const GenerateOptions& options) {
  const auto [width, height] = options.size;
  const std::uint64_t seed = options.common.seed;
  GridMaze maze = options.kind == Kind::biased ? generate_biased_maze(height, width, seed)
                                               : generate_backtracker(width, height, seed);
  if (options.loops > 0) open_walls(maze, options.loops, seed);
  const auto formats_of_mice = {Format::cell_values, Format::maz, Format::num};
  if (!maze.goal.empty() && std::ranges::find(formats_of_mice, options.format) != formats_of_mice.end())
    open_centre_room(maze);
  return maze;
}

// The command that makes the same file again.
std::string recipe(const GenerateOptions& options) {
  std::string text =
      fmt::format("taut generate --size {}x{} --kind {} --seed {}", options.size.width, options.size.height,
                  kKinds[static_cast<std::size_t>(options.kind)], options.common.seed);
  if (options.kind == Kind::roadblocks)
    return text + fmt::format(" --roadblocks {} --samples {}{}", options.roadblocks, options.samples,
                              options.lane == roadblocks::kLeastLane ? "" : fmt::format(" --lane {}", options.lane));
  if (options.loops > 0) text += " --loops " + number_text(options.loops);
  return text;
}

std::string bytes_of(const GenerateOptions& options) {
  if (options.kind == Kind::roadblocks) {
    const auto [width, height] = options.size;
    return roadblock_map_text(roadblocks::generate_roadblock_map({width, height, options.roadblocks, options.samples,
                                                                  options.common.seed, options.lane}),
                              recipe(options));
  }
  auto maze = std::make_shared<const GridMaze>(maze_of(options));
  const World world = world_of(std::move(maze));
  if (options.format != Format::segments) return write_world(world, options.format);
  // The source of the biased mazes has cell centres at whole numbers.
  return write_segments(world, {recipe(options), options.kind == Kind::biased ? Point{0.5, 0.5} : Point{}});
}

int run(const GenerateOptions& options, Run& run) {
  run.promise(options.file);
  std::string bytes = run.stage("generate", [&] {
    try {
      return bytes_of(options);
    } catch (const InputError& error) {
      throw UsageError(error.what());  // all input is the command line
    }
  });
  Json result{{"recipe", recipe(options)}, {"bytes", bytes.size()}};
  return run.end({.result = std::move(result), .files = {{options.file, std::move(bytes)}}});
}

}  // namespace

Command generate_command(CommandLine& app) {
  return command<GenerateOptions>(app, "generate", "Make a maze from a seed", add_options, run);
}

}  // namespace taut::cli
