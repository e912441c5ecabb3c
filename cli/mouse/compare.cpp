// taut mouse compare: all explorers over many mazes.
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

#include <taut/cli/command_line.h>
#include <taut/cli/exit_code.h>
#include <taut/cli/messages.h>
#include <taut/cli/mouse/mouse.h>
#include <taut/cli/mouse/report.h>
#include <taut/cli/output.h>
#include <taut/cli/report.h>
#include <taut/cli/timing.h>
#include <taut/io/results/detail/result_values.h>

namespace taut::cli {

namespace {

using Json = nlohmann::ordered_json;
using micromouse::Explorer;
using micromouse::Record;
using micromouse::TrialStatus;

struct CompareOptions {
  std::vector<std::string> files;
  CommonOptions common;
  std::vector<Explorer> explorers = micromouse::all_explorers();
  int max_steps = micromouse::kMaxSteps;
  std::string json;
  bool quiet = false;
};

/// One explorer in one maze.
struct Score {
  int run1 = 0;
  int run2 = 0;
  std::optional<int> thirtieths;
  bool proven = false;
  std::string reason;
};

struct Contest {
  std::vector<MouseMaze> mazes;
  std::vector<MouseYardsticks> yardsticks;
  std::vector<std::string> without_route;
  std::vector<std::vector<Score>> scores;  // by explorer, then maze
  std::vector<double> seconds;             // by explorer
};

/// Of an explorer, over all mazes it finished.
struct Summary {
  std::size_t finished = 0;
  std::size_t failures = 0;
  std::size_t proven = 0;
  double mean = 0;
  double mean_floor = 0;  ///< of the same mazes
  std::optional<std::size_t> worst;
};

std::vector<Explorer> explorers_in(const std::string& list) {
  std::vector<Explorer> explorers;
  for (std::size_t from = 0; from <= list.size();) {
    const std::size_t comma = std::min(list.find(',', from), list.size());
    explorers.push_back(explorer_of(list.substr(from, comma - from), "--explorers"));
    from = comma + 1;
  }
  return explorers;
}

void add_options(CommandLine& app, CompareOptions& options) {
  app.add_option("MAZE", options.files, "The mazes, of any format").required();
  app.add_option_function(
         "--explorers", [&options](const std::string& list) { options.explorers = explorers_in(list); },
         "Which, separated by commas (default: all)")
      .type_name("LIST")
      .group("Robot");
  app.add_option("--max-steps", options.max_steps, "Of both runs together (default: 1000)")
      .type_name("N")
      .range(1, 1'000'000)
      .group("Robot");
  app.add_option("--json", options.json, "Write every score as JSON; - is standard output")
      .type_name("FILE")
      .group("Output");
  app.add_flag("--quiet,-q", options.quiet, "No table on standard output").group("Output");
}

Contest read(const CompareOptions& options) {
  Contest contest;
  for (const std::string& file : options.files) {
    MouseMaze maze = read_mouse_maze(file);
    if (const auto y = yardsticks(maze.maze, false)) {
      contest.mazes.push_back(std::move(maze));
      contest.yardsticks.push_back(*y);
    } else {
      note("taut: " + maze.name + ": the maze has no way from the start to the goal; left out");
      contest.without_route.push_back(maze.name);
    }
  }
  return contest;
}

Score score_of(const CompareOptions& options, Explorer explorer, const GridMaze& maze) {
  const auto robot =
      micromouse::make_explorer(explorer, micromouse::task_of(maze, options.max_steps), options.common.seed);
  const Record record = micromouse::run_trial(maze, *robot, options.max_steps);
  return {record.run1, record.run2, record.thirtieths(), micromouse::certificate(record).has_value(),
          record.status == TrialStatus::finished ? "" : std::string(name(record.status))};
}

void run_all(const CompareOptions& options, Contest& contest) {
  const std::size_t all = options.explorers.size() * contest.mazes.size();
  std::size_t done = 0;
  for (const Explorer explorer : options.explorers) {
    const Stopwatch watch;
    auto& row = contest.scores.emplace_back();
    for (const MouseMaze& maze : contest.mazes) {
      if (!options.quiet) progress(fmt::format("{} of {}: {} in {}", ++done, all, name(explorer), title_of(maze.name)));
      row.push_back(score_of(options, explorer, maze.maze));
    }
    contest.seconds.push_back(watch.seconds());
  }
  end_progress();
}

Summary summary_of(const std::vector<Score>& scores, const Contest& contest) {
  Summary summary;
  int sum = 0;
  double floors = 0;
  for (std::size_t i = 0; i < scores.size(); ++i) {
    summary.proven += scores[i].proven ? 1U : 0U;
    if (!scores[i].thirtieths) {
      ++summary.failures;
      continue;
    }
    ++summary.finished;
    sum += *scores[i].thirtieths;
    floors += contest.yardsticks[i].floor;
    if (!summary.worst || *scores[i].thirtieths > *scores[*summary.worst].thirtieths) summary.worst = i;
  }
  if (summary.finished == 0) return summary;
  summary.mean = static_cast<double>(sum) / (micromouse::kExplorationShare * static_cast<double>(summary.finished));
  summary.mean_floor = floors / static_cast<double>(summary.finished);
  return summary;
}

double value_of(int thirtieths) { return static_cast<double>(thirtieths) / micromouse::kExplorationShare; }

std::string table(const CompareOptions& options, const Contest& contest) {
  std::string out = fmt::format("{:<12}{:>9}{:>9}{:>10}{:>10}{:>8}{:>9}  {}\n", "explorer", "mean", "/ floor", "worst",
                                "failures", "proven", "s / maze", "worst maze");
  for (std::size_t i = 0; i < options.explorers.size(); ++i) {
    const Summary s = summary_of(contest.scores[i], contest);
    const auto number = [&](double value) { return s.worst ? fmt::format("{:.3f}", value) : std::string("-"); };
    const double mazes = static_cast<double>(contest.mazes.size());
    out += fmt::format("{:<12}{:>9}{:>9}{:>10}{:>10}{:>8}{:>9.3f}  {}\n", name(options.explorers[i]), number(s.mean),
                       number(s.mean / s.mean_floor),
                       number(s.worst ? value_of(*contest.scores[i][*s.worst].thirtieths) : 0), s.failures, s.proven,
                       contest.seconds[i] / mazes, s.worst ? title_of(contest.mazes[*s.worst].name) : "");
  }
  return out + fmt::format("{}, mean score = run 2 + run 1 / 30 of those finished\n",
                           count_text(contest.mazes.size(), "maze"));
}

Json json_of(const Score& s, const MouseMaze& maze, const MouseYardsticks& y) {
  Json json{{"maze", maze.name},  {"score", s.thirtieths ? Json(value_of(*s.thirtieths)) : Json(nullptr)},
            {"run1", s.run1},     {"run2", s.run2},
            {"proven", s.proven}, {"optimum", y.optimum},
            {"floor", y.floor}};
  if (!s.reason.empty()) json["reason"] = s.reason;
  return json;
}

Json json_of(const CompareOptions& options, const Contest& contest) {
  Json explorers = Json::array();
  for (std::size_t i = 0; i < options.explorers.size(); ++i) {
    const Summary s = summary_of(contest.scores[i], contest);
    Json runs = Json::array();
    for (std::size_t k = 0; k < contest.mazes.size(); ++k)
      runs.push_back(json_of(contest.scores[i][k], contest.mazes[k], contest.yardsticks[k]));
    explorers.push_back({{"explorer", name(options.explorers[i])},
                         {"mean", s.worst ? Json(s.mean) : Json(nullptr)},
                         {"mean_floor", s.worst ? Json(s.mean_floor) : Json(nullptr)},
                         {"worst", s.worst ? Json(value_of(*contest.scores[i][*s.worst].thirtieths)) : Json(nullptr)},
                         {"worst_maze", s.worst ? Json(contest.mazes[*s.worst].name) : Json(nullptr)},
                         {"failures", s.failures},
                         {"proven", s.proven},
                         {"seconds", contest.seconds[i]},
                         {"runs", runs}});
  }
  return {{"program", "taut"},
          {"version", TAUT_VERSION},
          {"seed", options.common.seed},
          {"mazes", contest.mazes.size()},
          {"without_route", contest.without_route},
          {"explorers", explorers}};
}

int run(const CompareOptions& options) {
  require_writable(options.json);
  begin_stage("read");
  Contest contest = read(options);
  if (contest.mazes.empty()) return ExitCode::kNone;
  begin_stage("run");
  run_all(options, contest);
  finish();
  write_file(options.json, options.json.empty() ? "" : detail::json_text(json_of(options, contest)));
  if (!options.quiet && options.json != "-") print(table(options, contest));
  return kFound;
}

}  // namespace

Command mouse_compare_command(CommandLine& group) {
  return command<CompareOptions>(group, "compare", "All explorers over many mazes: mean, worst, failures", add_options,
                                 run);
}

}  // namespace taut::cli
