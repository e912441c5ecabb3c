// Our planners and OMPL's on the same mazes, in the same run, in CPU time; bench/README.md says how to read it.
//
// First table: every planner is asked for its first path, and every motion is tested by FreeSpace::sees, exactly.
// Second table: OMPL as it comes out of the box, with motions sampled at its default resolution, and what an exact
// check says of its answers.
//
//   ompl_bench [--benchmark_filter=REGEX] [--sides=7,15,25,41,61] [--mazes=5] [--seeds=3] [--limit=10]
//              [--audits=20]
//
// The filter is for planner names. --limit is CPU seconds for one run; who fails all runs of a size is not asked for
// larger ones.

#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include <algorithm>
#include <cstdio>
#include <functional>
#include <memory>
#include <optional>
#include <regex>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include <taut/geometry/maze_generator.h>
#include <taut/geometry/predicates.h>
#include <taut/search/shortest_path.h>
#include <taut/search/verify.h>

#include "ompl_planners.h"

namespace {

using namespace taut;
using namespace taut::bench;

struct Settings {
  std::regex filter{"."};
  std::vector<int> sides{7, 15, 25, 41, 61};
  int mazes = 5;  // a size
  int seeds = 3;
  double limit = 10;
  int audits = 20;
};

// ---- tables ---------------------------------------------------------------------------------------------------------

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values.empty() ? 0 : values[values.size() / 2];
}

/// A number of each run, those that found a path.
std::vector<double> of_found(const std::vector<Run>& runs, const std::function<double(const Run&)>& number) {
  std::vector<double> values;
  for (const Run& run : runs)
    if (run.found) values.push_back(number(run));
  return values;
}

std::string ratio_text(const std::vector<Run>& runs) {
  const bool all_equal =
      std::all_of(runs.begin(), runs.end(), [](const Run& run) { return !run.found || run.optimal; });
  if (all_equal) return "1";  // exactly
  return fmt::format("{:.4f}", median(of_found(runs, [](const Run& run) { return run.ratio; })));
}

/// Adds how the path compares with the shortest.
void judge(Run& run, const Task& task, const std::string& name) {
  if (!run.found) return;
  const Verdict verdict = verify(run.path, task.space, task.from, task.to);
  if (!verdict.valid) fmt::print("ERROR: {} gave a path that is none: {}\n", name, verdict.reason);
  run.optimal = run.path.length == task.optimum.length;
  run.ratio = run.path.length.value() / task.optimum.length.value();
  if (run.path.length < task.optimum.length) fmt::print("ERROR: {} is shorter than the shortest path\n", name);
}

FreeSpace maze(int side, std::uint64_t seed = 1, const Footprint& robot = Footprint::point()) {
  return FreeSpace(world_of(std::make_shared<GridMaze>(generate_biased_maze(side, side, seed))), robot);
}

void first_paths(const Settings& settings) {
  using Rule = PrmConnection::Rule;
  std::vector<Row> rows{
      {"taut-visibility", [](const Task& task, std::uint64_t, double) { return our_exact(task); }},
      {"taut-prm",
       [](const Task& t, std::uint64_t s, double limit) {
         return our_prm(t, s, limit, {Rule::visible, 8}, false);
       }},
      {"taut-prm-uniform",
       [](const Task& t, std::uint64_t s, double limit) {
         return our_prm(t, s, limit, {Rule::visible, 8}, false, PrmSampler::uniform);
       }},
      {"taut-prm-funnel",
       [](const Task& t, std::uint64_t s, double limit) {
         return our_prm(t, s, limit, {Rule::visible, 8}, true);
       }},
      {"taut-forest-funnel",
       [](const Task& t, std::uint64_t s, double limit) {
         return our_prm(t, s, limit, {Rule::forest, 8}, true);
       }},
      {"taut-forest",
       [](const Task& t, std::uint64_t s, double limit) {
         return our_prm(t, s, limit, {Rule::forest, 8}, false);
       }},
      ompl_row<og::PRM>("ompl-PRM"),
      ompl_row<og::LazyPRM>("ompl-LazyPRM", 25),  // in larger mazes it looks at no limit for minutes
      ompl_row<og::PRMstar>("ompl-PRMstar"),
      ompl_row<og::RRTConnect>("ompl-RRTConnect"),
      ompl_row<og::BITstar>("ompl-BITstar"),
  };
  std::erase_if(rows, [&](const Row& row) { return !std::regex_search(row.name, settings.filter); });
  fmt::print("{:<20}{:>6}{:>9}{:>12}{:>10}{:>10}{:>10}\n", "planner", "side", "solved", "cpu ms", "length", "vertices",
             "edges");
  for (const int side : settings.sides) {
    std::vector<Task> tasks;
    for (int seed = 1; seed <= settings.mazes; ++seed) tasks.emplace_back(maze(side, static_cast<std::uint64_t>(seed)));
    for (Row& row : rows) {
      if (!row.run || side > row.largest) continue;
      std::vector<Run> runs;
      for (const Task& task : tasks)
        for (int seed = 1; seed <= settings.seeds; ++seed) {
          runs.push_back(row.run(task, static_cast<std::uint64_t>(seed), settings.limit));
          judge(runs.back(), task, row.name);
        }
      const auto solved = std::count_if(runs.begin(), runs.end(), [](const Run& run) { return run.found; });
      if (solved == 0) row.run = nullptr;
      const auto middle = [&](auto number) { return median(of_found(runs, number)); };
      fmt::print("{:<20}{:>6}{:>9}{:>12}{:>10}{:>10.0f}{:>10.0f}\n", row.name, side,
                 fmt::format("{}/{}", solved, runs.size()),
                 solved ? fmt::format("{:.2f}", 1e3 * middle([](const Run& run) { return run.seconds; })) : "-",
                 solved ? ratio_text(runs) : "-", middle([](const Run& run) { return run.vertices; }),
                 middle([](const Run& run) { return run.edges; }));
      std::fflush(stdout);
    }
  }
}

/// Walls, and not their ends, that the path goes through.
std::size_t walls_crossed(const Path& path, const World& world) {
  return static_cast<std::size_t>(std::count_if(world.walls().begin(), world.walls().end(), [&](const Wall& wall) {
    for (std::size_t i = 0; i + 1 < path.points.size(); ++i)
      if (cross_properly({path.points[i], path.points[i + 1]}, {wall.a, wall.b})) return true;
    return false;
  }));
}

void audit(const Settings& settings, const std::string& name, const Task& task, int side,
           const std::function<Run(const Task&)>& run) {
  if (!std::regex_search(name, settings.filter)) return;
  std::vector<double> ratios, walls;
  int solved = 0, valid = 0;
  for (int i = 0; i < settings.audits; ++i) {
    const Run answer = run(task);
    if (!answer.found) continue;
    ++solved;
    valid += verify(answer.path, task.space, task.from, task.to).valid;
    ratios.push_back(answer.path.length.value() / task.optimum.length.value());
    walls.push_back(static_cast<double>(walls_crossed(answer.path, task.space.world())));
  }
  fmt::print("{:<26}{:>6}{:>9}{:>9}{:>14.0f}{:>9.3f}\n", name, side, fmt::format("{}/{}", solved, settings.audits),
             fmt::format("{}/{}", valid, solved), median(walls), median(ratios));
  std::fflush(stdout);
}

void audits(const Settings& settings) {
  fmt::print("\n{:<26}{:>6}{:>9}{:>9}{:>14}{:>9}\n", "OMPL, sampled motions", "side", "solved", "valid",
             "walls crossed", "length");
  for (const int side : settings.sides) {
    if (side != 25 && side != 61) continue;
    for (const auto& [robot, shape] : {std::pair("point", Footprint::point()), {"disc:0.1", Footprint::disc(0.1)}}) {
      const Task task(maze(side, 1, shape));
      audit(settings, fmt::format("ompl-PRM, {}", robot), task, side,
            [&](const Task& t) { return ompl_run<og::PRM>(t, settings.limit, false); });
      audit(settings, fmt::format("ompl-RRTConnect, {}", robot), task, side,
            [&](const Task& t) { return ompl_run<og::RRTConnect>(t, settings.limit, false); });
    }
  }
}

std::vector<int> numbers_in(const std::string& list) {
  std::vector<int> numbers;
  for (std::size_t from = 0; from <= list.size();) {
    const std::size_t comma = std::min(list.find(',', from), list.size());
    numbers.push_back(std::stoi(list.substr(from, comma - from)));
    from = comma + 1;
  }
  return numbers;
}

Settings settings_of(int count, char** words) {
  Settings settings;
  for (int i = 1; i < count; ++i) {
    const std::string word = words[i];
    const auto value_of = [&](std::string_view name) -> std::optional<std::string> {
      return word.starts_with(name) ? std::optional(word.substr(name.size())) : std::nullopt;
    };
    if (const auto filter = value_of("--benchmark_filter=")) settings.filter = std::regex(*filter);
    if (const auto sides = value_of("--sides=")) settings.sides = numbers_in(*sides);
    if (const auto mazes = value_of("--mazes=")) settings.mazes = std::stoi(*mazes);
    if (const auto seeds = value_of("--seeds=")) settings.seeds = std::stoi(*seeds);
    if (const auto limit = value_of("--limit=")) settings.limit = std::stod(*limit);
    if (const auto count_of = value_of("--audits=")) settings.audits = std::stoi(*count_of);
  }
  return settings;
}

}  // namespace

int main(int count, char** words) {
  ompl::msg::noOutputHandler();
  ompl::RNG::setSeed(1);
  const Settings settings = settings_of(count, words);
  first_paths(settings);
  if (settings.audits > 0) audits(settings);
}
