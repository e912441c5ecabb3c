// taut grid scen: a MovingAI scenario file, every optimal length checked.
#include <fmt/format.h>

#include <cmath>
#include <map>
#include <utility>

#include <taut/cli/command.h>
#include <taut/cli/grid/grid.h>
#include <taut/cli/messages.h>
#include <taut/cli/run.h>
#include <taut/cli/world/foreign.h>
#include <taut/geometry/errors.h>
#include <taut/io/worlds/movingai.h>
#include <taut/io/worlds/read_world.h>

namespace taut::cli {

namespace {

struct ScenarioOptions {
  std::string map;
  std::string scenarios;
  CommonOptions common;
  GridAlgorithm algorithm = GridAlgorithm::jps;
};

void add_options(CommandLine& app, ScenarioOptions& options) {
  app.add_option("MAP", options.map, "A MovingAI map; - is standard input").required();
  app.add_option("SCEN", options.scenarios, "Its scenarios; where they are for a larger or smaller one, it is scaled")
      .required();
  app.add_option_function(
         "--algorithm", [&options](const std::string& text) { options.algorithm = grid_algorithm_of(text); },
         "One that finds the least cost: jps (default), astar, dijkstra, bidirectional-astar or idastar")
      .type_name("NAME")
      .group("Search");
  app.example("taut grid scen arena.map arena.map.scen --algorithm astar");
  app.callback([&options] {
    if (!finds_least_cost({options.algorithm, natural_heuristic(GridMoves::octile)}, GridMoves::octile))
      throw UsageError(fmt::format("{} does not find the least cost", name(options.algorithm)));
    if (options.map == "-" && options.scenarios == "-")
      throw UsageError("MAP and SCEN cannot both come from standard input");
  });
}

/// Is this what the file says, as far as its digits go? Half a unit of the last one, and what doubles round.
bool agrees(double cost, const Scenario& scenario) {
  return std::abs(cost - scenario.optimal) <= 0.5 * scenario.unit() + 1e-12 * cost;
}

/// Of those who add up diagonal moves of the length of a single-precision root of two.
double single_precision(GridCost cost) {
  return static_cast<double>(cost.straight()) + static_cast<double>(cost.diagonal()) * double{1.41421356F};
}

/// Lengths between corners of cells are shorter by more than single precision makes of any.
constexpr double kAngleGain = 1e-6;

/// What came of the scenarios so far.
class Tally {
 public:
  explicit Tally(GridAlgorithm algorithm) : algorithm_(algorithm) {}

  void add(const Scenario& scenario, const GridResult& result, const std::string& file) {
    const bool found = result.status == SearchStatus::found;
    const double cost = found ? result.cost.value() : 0;
    ++run_;
    steps_ += result.steps;
    cost_ += cost;
    if (found ? agrees(cost, scenario) : result.status == SearchStatus::none && scenario.says_none()) return;
    if (found && agrees(single_precision(result.cost), scenario)) {
      ++single_;
      return;
    }
    shorter_ += found && cost * (1 - kAngleGain) > scenario.optimal && !scenario.says_none();
    const std::string what = found ? fmt::format("{:.8f}", cost) : "no path";
    note(fmt::format("{}:{}: says {}, found {}", file, scenario.line, scenario.optimal_text, what));
    mismatches_.push_back({{"line", scenario.line}, {"expected", scenario.optimal_text}, {"found", what}});
  }

  std::size_t missed() const { return mismatches_.size(); }
  /// As any-angle lengths between corners of cells are.
  bool is_all_shorter() const { return missed() > 0 && shorter_ == missed(); }
  /// How many agree only with a root of two of single precision.
  std::size_t single() const { return single_; }

  Json json() const {
    return {{"scenarios", run_},
            {"matched", run_ - missed()},
            {"mismatches", mismatches_},
            {"algorithm", name(algorithm_)},
            {"steps", steps_},
            {"cost", cost_},
            {"single_precision", single_}};
  }
  std::string text(const std::string& file, double seconds) const {
    return fmt::format("{}: {}, {} as the file says, {}; {}, total cost {:.6f}, {}\n", file,
                       count_text(run_, "scenario"), run_ - missed(), count_text(missed(), "mismatch", "mismatches"),
                       count_text(steps_, "step"), cost_, seconds_text(seconds));
  }

 private:
  GridAlgorithm algorithm_;
  std::size_t run_ = 0, shorter_ = 0, single_ = 0, steps_ = 0;
  double cost_ = 0;
  Json mismatches_ = Json::array();
};

constexpr std::uint64_t kMostCells = 400'000'000;

/// The map, and what its scenarios scale it to.
class ScaledMaps {
 public:
  ScaledMaps(const OccupancyGrid& grid, std::string name) : name_(std::move(name)) {
    width_ = grid.width;
    height_ = grid.height;
    maps_.try_emplace({width_, height_}, grid);
  }

  struct Map {
    explicit Map(OccupancyGrid cells) : grid(std::move(cells)), search(grid, GridMoves::octile) {}
    OccupancyGrid grid;
    GridSearch search;
  };

  /// Of the scenario's size. Throws InputError where that is no multiple or fraction of the map's.
  Map& of(const Scenario& s, const std::string& file) {
    const auto known = maps_.find({s.width, s.height});
    if (known != maps_.end()) return known->second;
    if (std::uint64_t{s.width} * s.height > kMostCells || s.width == 0 ||
        std::uint64_t{s.width} * height_ != std::uint64_t{s.height} * width_)
      throw InputError(
          file, static_cast<int>(s.line),
          fmt::format("is for a map of {} x {} cells, {} has {} x {}", s.width, s.height, name_, width_, height_));
    note(
        fmt::format("{}:{}: for a map of {} x {} cells: {} is scaled to that", file, s.line, s.width, s.height, name_));
    const OccupancyGrid& grid = maps_.at({width_, height_}).grid;
    return maps_.try_emplace({s.width, s.height}, scaled(grid, s.width, s.height)).first->second;
  }

 private:
  std::string name_;
  std::uint32_t width_ = 0, height_ = 0;
  std::map<std::pair<std::uint32_t, std::uint32_t>, Map> maps_;
};

/// Throws InputError unless both ends are free cells.
void require_free(const OccupancyGrid& grid, const Scenario& s, const std::string& file) {
  const int line = static_cast<int>(s.line);
  for (const GridPlace p : {GridPlace{s.start_row, s.start_column}, GridPlace{s.goal_row, s.goal_column}})
    if (!grid.free(p.column, p.row))
      throw InputError(file, line, fmt::format("column {}, row {} is blocked or outside", p.column, p.row));
}

OccupancyGrid read_map(const std::string& file, const std::string& source) {
  const std::string bytes = read_bytes(file);
  return read_own(bytes, source, {FileKind::world}, [&] { return read_movingai_map(bytes, source); });
}

std::vector<Scenario> read_scenarios(const std::string& file, const std::string& source) {
  const std::string bytes = read_bytes(file);
  return read_own(bytes, source, {FileKind::scenarios}, [&] { return read_movingai_scenarios(bytes, source); });
}

int run(const ScenarioOptions& options, Run& run) {
  run.sources({options.map, options.scenarios});
  const std::string map = source_name(options.map), file = source_name(options.scenarios);
  const OccupancyGrid grid = run.stage("read", [&] { return read_map(options.map, map); });
  const std::vector<Scenario> scenarios = run.stage("read", [&] { return read_scenarios(options.scenarios, file); });
  ScaledMaps maps(grid, map);
  const GridQuery query{options.algorithm, natural_heuristic(GridMoves::octile)};
  Tally tally(options.algorithm);
  for (const Scenario& s : scenarios) {
    ScaledMaps::Map& of_size = maps.of(s, file);
    require_free(of_size.grid, s, file);
    const GridPlace start{s.start_row, s.start_column}, goal{s.goal_row, s.goal_column};
    tally.add(s, run.stage("search", [&] { return of_size.search.find(start, goal, query); }), file);
    run.so_far(tally.json(), tally.text(file, run.seconds("search").cpu));
  }
  if (tally.single() > 0)
    note(fmt::format("{}: {} as the file says only where the root of two is of single precision", file,
                     count_text(tally.single(), "length")));
  if (tally.is_all_shorter())
    note(
        "all that differ are shorter in the file, as any-angle lengths between corners of cells are: `taut batch` "
        "checks those");
  return run.end({.outcome = tally.missed() > 0 ? Outcome::differs : Outcome::done,
                  .reason = tally.missed() > 0 ? count_text(tally.missed(), "mismatch", "mismatches") : "",
                  .result = tally.json(),
                  .line = tally.text(file, run.seconds("search").cpu)});
}

}  // namespace

Command grid_scenario_command(CommandLine& grid) {
  return command<ScenarioOptions>(
      grid, "scen",
      "Run a MovingAI scenario file and check each optimal length to its own digits (exit 1: some differ)", add_options,
      run);
}

}  // namespace taut::cli
