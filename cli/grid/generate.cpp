// taut grid generate: grid maps and scenarios from a seed.
#include <fmt/format.h>

#include <charconv>
#include <random>

#include <taut/cli/command.h>
#include <taut/cli/messages.h>
#include <taut/cli/run.h>
#include <taut/io/worlds/movingai.h>
#include <taut/search/grid/grid_generator.h>
#include <taut/search/grid/grid_search.h>

namespace taut::cli {

namespace {

constexpr std::size_t kTries = 1000;  // for a pair that a path joins
constexpr std::uint32_t kLargestSide = 20000;

struct GenerateOptions {
  GridKind kind = GridKind::maze;
  std::uint32_t width = 64;
  std::uint32_t height = 64;
  CommonOptions common;
  std::string output = "-";
  std::string scenario_file;
  std::size_t scenarios = 100;
};

void read_size(const std::string& text, GenerateOptions& options) {
  const char* const end = text.data() + text.size();
  const auto width = std::from_chars(text.data(), end, options.width);
  if (width.ec == std::errc() && width.ptr != end && *width.ptr == 'x') {
    const auto height = std::from_chars(width.ptr + 1, end, options.height);
    if (height.ec == std::errc() && height.ptr == end && std::min(options.width, options.height) >= 2 &&
        std::max(options.width, options.height) <= kLargestSide)
      return;
  }
  throw UsageError(
      fmt::format("'{}' is no size; sizes are written WIDTHxHEIGHT, each from 2 to {}", text, kLargestSide));
}

void add_options(CommandLine& app, GenerateOptions& options) {
  app.add_option_function(
         "--kind",
         [&options](const std::string& text) {
           const auto kind = grid_kind_named(text);
           if (!kind) throw UsageError("'" + text + "' is no kind of grid; they are maze, rooms and random");
           options.kind = *kind;
         },
         "maze (default), rooms or random")
      .type_name("KIND")
      .group("Map");
  app.add_option_function(
         "--size", [&options](const std::string& text) { read_size(text, options); }, "In cells (default: 64x64)")
      .type_name("WIDTHxHEIGHT")
      .group("Map");
  app.add_option("--output,-o", options.output, "Where the MovingAI map goes (default: standard output)")
      .type_name("FILE")
      .group("Output");
  app.add_option("--scen", options.scenario_file, "Also write scenarios with their optimal lengths, by Dijkstra")
      .type_name("FILE")
      .group("Output");
  app.add_option("--scenarios", options.scenarios, "How many (default: 100)")
      .range(1, 100000)
      .type_name("N")
      .group("Output");
  app.example("taut grid generate --kind rooms --size 80x60 --seed 3 -o rooms.map --scen rooms.map.scen");
  app.callback([&app, &options] {
    if (app.count("--scenarios") > 0 && options.scenario_file.empty()) throw UsageError("--scenarios needs --scen");
  });
}

/// A free cell, every one as likely.
GridPlace drawn_place(const OccupancyGrid& grid, std::mt19937_64& engine) {
  for (;;) {
    const auto row = static_cast<std::uint32_t>(engine() % grid.height);
    const auto column = static_cast<std::uint32_t>(engine() % grid.width);
    if (grid.free(column, row)) return {row, column};
  }
}

/// Pairs that a path joins, in the order they were drawn; the bucket is a quarter of the length, as in MovingAI's
/// files.
std::vector<Scenario> drawn_scenarios(const OccupancyGrid& grid, const GenerateOptions& options) {
  GridSearch search(grid, GridMoves::octile);
  std::mt19937_64 engine(options.common.seed);
  std::vector<Scenario> all;
  const std::string map = options.output == "-" ? "map" : title_of(options.output);
  for (std::size_t tries = 0; all.size() < options.scenarios && tries < kTries * options.scenarios; ++tries) {
    const GridPlace start = drawn_place(grid, engine);
    const GridPlace goal = drawn_place(grid, engine);
    const GridResult result = search.find(start, goal, {GridAlgorithm::dijkstra, {}});
    if (result.status != SearchStatus::found) continue;
    const double length = result.cost.value();
    all.push_back({static_cast<std::uint32_t>(length / 4), map, grid.width, grid.height, start.column, start.row,
                   goal.column, goal.row, length, fmt::format("{:.8f}", length), all.size() + 2, 8});
  }
  return all;
}

int run(const GenerateOptions& options, Run& run) {
  run.promise(options.output);
  run.promise(options.scenario_file);
  const OccupancyGrid grid = run.stage(
      "generate", [&] { return generate_grid(options.kind, options.width, options.height, options.common.seed); });
  Json result{
      {"kind", name(options.kind)}, {"width", grid.width}, {"height", grid.height}, {"seed", options.common.seed}};
  std::vector<OutputFile> files{{options.output, movingai_map_text(grid)}};
  if (!options.scenario_file.empty()) {
    const std::vector<Scenario> drawn = run.stage("scenarios", [&] { return drawn_scenarios(grid, options); });
    result["scenarios"] = drawn.size();
    files.push_back({options.scenario_file, movingai_scenario_text(drawn)});
  }
  return run.end({.result = std::move(result), .files = std::move(files)});
}

}  // namespace

Command grid_generate_command(CommandLine& grid) {
  return command<GenerateOptions>(grid, "generate", "A grid map, and scenarios for it, from a seed", add_options, run);
}

}  // namespace taut::cli
