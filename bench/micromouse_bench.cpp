// Scores of all micromouse explorers on generated and on competition mazes: tables, and the time each takes a maze.
//   micromouse_bench [--sets gen,long,comp] [--explorers flood,score,...] [--mazes N] [--seeds FIRST] [FILE...]
//   micromouse_bench --tour N ...   prove plans N looks as one tour: three seeds, paired with each look for itself
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include <taut/geometry/errors.h>
#include <taut/geometry/maze_generator.h>
#include <taut/io/worlds/read_world.h>
#include <taut/robots/micromouse/contest_maze.h>
#include <taut/robots/micromouse/detail/scout.h>
#include <taut/robots/micromouse/explorers.h>
#include <taut/robots/micromouse/steps.h>
#include <taut/robots/micromouse/trial.h>

#include "shared_data.h"

namespace {

using namespace taut;
using namespace taut::micromouse;

struct Named {
  std::string name;
  GridMaze maze;
};

/// n = 12, 14, 16 in turn; a backtracker maze with walls taken down until 38 % of the interior ones stand, and a start
/// with one way.
GridMaze generated(int n, std::uint64_t seed) {
  GridMaze maze = generate_backtracker(n, n, seed);
  const double walls = (n - 1.0) * (n - 1.0), wanted = 0.38 * 2 * n * (n - 1.0);
  open_walls(maze, 1 - wanted / walls, seed);
  open_centre_room(maze);
  return maze;
}

std::vector<Named> generated_set(int count, std::uint64_t first) {
  std::vector<Named> set;
  for (int i = 0; i < count; ++i) {
    const int n = 12 + 2 * (i % 3);
    set.push_back({"gen" + std::to_string(n) + "-" + std::to_string(first + static_cast<std::uint64_t>(i)),
                   generated(n, first + static_cast<std::uint64_t>(i))});
  }
  return set;
}

/// Routes of 17, 22 and 25 steps.
std::vector<Named> long_set(int count, std::uint64_t first) {
  std::vector<Named> set;
  for (std::uint64_t seed = first; static_cast<int>(set.size()) < count; ++seed) {
    const std::vector<ContestShape> shapes{{12, 17}, {14, 22}, {16, 25}};
    const ContestShape& shape = shapes[set.size() % 3];
    if (auto maze = contest_maze(shape, seed))
      set.push_back({"long" + std::to_string(shape.side) + "-" + std::to_string(seed), *maze});
  }
  return set;
}

bool admitted(const Named& named) {
  try {
    const Task task = task_of(named.maze);
    return optimum(passages_of(named.maze), task).has_value();
  } catch (const InputError& e) {
    std::fprintf(stderr, "%s: %s\n", named.name.c_str(), e.what());
    return false;
  }
}

std::vector<Named> competition_set(const std::filesystem::path& folder) {
  std::vector<Named> set;
  std::vector<std::filesystem::path> files;
  if (folder.empty()) return set;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  for (const auto& file : files) {
    try {
      const World world = read_world_file(file.string());
      if (world.grid()) set.push_back({file.filename().string(), *world.grid()});
    } catch (const InputError& e) {
      std::fprintf(stderr, "%s\n", e.what());
    }
  }
  std::erase_if(set, [](const Named& n) {
    const bool ok = admitted(n);
    if (!ok) std::fprintf(stderr, "%s: no route or no micromouse maze\n", n.name.c_str());
    return !ok;
  });
  return set;
}

struct Totals {
  double score = 0, worst = 0, run1 = 0, run2 = 0, seconds = 0, slowest = 0;
  int finished = 0, optimal = 0;
};

void table(const std::string& title, const std::vector<Named>& set, const std::vector<Explorer>& explorers,
           bool verbose) {
  std::printf("%s: %zu mazes\n%-12s %9s %9s %9s %9s %9s %8s %9s %9s\n", title.c_str(), set.size(), "explorer",
              "finished", "optimal", "mean", "worst", "run 1", "run 2", "s/maze", "slowest");
  for (const Explorer explorer : explorers) {
    Totals t;
    for (const Named& n : set) {
      const Task task = task_of(n.maze);
      const auto begin = std::chrono::steady_clock::now();
      const auto robot = make_explorer(explorer, task, 1);
      const Record record = run_trial(n.maze, *robot);
      const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
      t.seconds += seconds;
      t.slowest = std::max(t.slowest, seconds);
      const int best = *optimum(passages_of(n.maze), task);
      if (verbose)
        std::printf("  %-28s %-12s S* %3d run1 %4d run2 %3d score %8.3f %s\n", n.name.c_str(),
                    std::string(name(explorer)).c_str(), best, record.run1, record.run2, record.score().value_or(-1),
                    std::string(name(record.status)).c_str());
      if (!record.score()) continue;
      ++t.finished;
      t.optimal += record.run2 == best;
      t.score += *record.score();
      t.worst = std::max(t.worst, *record.score());
      t.run1 += record.run1;
      t.run2 += record.run2;
    }
    const double n = std::max(1, t.finished);
    std::printf("%-12s %9d %9d %9.3f %9.3f %9.2f %8.3f %9.3f %9.3f\n", std::string(name(explorer)).c_str(), t.finished,
                t.optimal, t.score / n, t.worst, t.run1 / n, t.run2 / n,
                t.seconds / static_cast<double>(std::max<std::size_t>(1, set.size())), t.slowest);
    std::fflush(stdout);
  }
}

/// What tours of so many looks make of prove's scores: means over three seeds, the change paired by maze, its error.
void tour_table(const std::string& title, const std::vector<Named>& set, int tour) {
  constexpr std::uint64_t kSeeds = 3;
  double run1[2] = {0, 0}, score[2] = {0, 0}, sum = 0, squares = 0;
  for (const Named& n : set) {
    double change = 0;
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed)
      for (const int with : {0, 1}) {
        micromouse::detail::ScoutTuning tuning;
        tuning.tour = with * tour;
        micromouse::detail::Scout robot(task_of(n.maze), micromouse::detail::ScoutGoal::proof, seed, tuning);
        const Record record = run_trial(n.maze, robot);
        run1[with] += record.run1 / static_cast<double>(kSeeds);
        score[with] += record.score().value_or(0) / kSeeds;
        change += (2 * with - 1) * record.score().value_or(0) / kSeeds;
      }
    sum += change, squares += change * change;
  }
  const double m = static_cast<double>(std::max<std::size_t>(2, set.size()));
  std::printf("%s: %zu mazes, run 1 %.2f, with tours of %d looks %.2f; score %.3f, %.3f: %+.3f +- %.3f\n",
              title.c_str(), set.size(), run1[0] / m, tour, run1[1] / m, score[0] / m, score[1] / m, sum / m,
              std::sqrt(std::max(0.0, squares - sum * sum / m) / (m - 1) / m));
  std::fflush(stdout);
}

std::vector<std::string> split(const std::string& list) {
  std::vector<std::string> parts;
  std::istringstream in(list);
  for (std::string part; std::getline(in, part, ',');) parts.push_back(part);
  return parts;
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<Explorer> explorers = all_explorers();
  std::vector<std::string> sets{"gen", "long", "comp"};
  std::vector<std::string> files;
  int mazes = 100;
  std::uint64_t first = 1;
  bool verbose = false;
  int tour = 0;
  for (int i = 1; i < argc; ++i) {
    const std::string arg = argv[i];
    if (arg == "--verbose") {
      verbose = true;
    } else if (arg.rfind("--", 0) == 0 && i + 1 < argc) {
      const std::string value = argv[++i];
      if (arg == "--sets") sets = split(value);
      if (arg == "--mazes") mazes = std::stoi(value);
      if (arg == "--seeds") first = std::stoull(value);
      if (arg == "--tour") tour = std::stoi(value);
      if (arg == "--explorers") {
        explorers.clear();
        for (const std::string& word : split(value))
          if (const auto e = explorer_named(word)) explorers.push_back(*e);
      }
    } else {
      files.push_back(arg);
    }
  }
  if (!files.empty()) {
    std::vector<Named> set;
    for (const std::string& file : files) set.push_back({file, *read_world_file(file).grid()});
    table("files", set, explorers, true);
    return 0;
  }
  const auto report = [&](const std::string& title, const std::vector<Named>& set) {
    if (tour > 0)
      tour_table(title, set, tour);
    else
      table(title, set, explorers, verbose);
  };
  for (const std::string& s : sets) {
    if (s == "gen") report("generated, 38 % walls", generated_set(mazes, first));
    if (s == "long") report("long routes, 38 % walls", long_set(mazes, first));
    if (s == "comp") report("competition", competition_set(bench::shared_data("micromouse/competition")));
  }
}
