// taut mouse compare: all explorers over many mazes.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include <taut/cli/command_line.h>
#include <taut/cli/jobs.h>
#include <taut/cli/messages.h>
#include <taut/cli/mouse/mouse.h>
#include <taut/cli/progress.h>
#include <taut/cli/report_files.h>
#include <taut/cli/run.h>
#include <taut/geometry/parallel.h>
#include <taut/io/results/mouse_json.h>
#include <taut/search/stopwatch.h>

namespace taut::cli {

namespace {

using micromouse::Contest;
using micromouse::Explorer;

struct CompareOptions {
  std::vector<std::string> files;
  CommonOptions common;
  ReportOptions report;
  std::vector<Explorer> explorers = micromouse::all_explorers();
  int max_steps = micromouse::kMaxSteps;
  int seeds = 1;
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
  app.add_option("--seeds", options.seeds,
                 "So many seeds, from --seed on, for those that draw (random, prove, score): how much seeds matter")
      .type_name("N")
      .range(1, 1000)
      .group("Robot");
  add_max_steps_option(app, options.max_steps);
  add_jobs_option(app, options.common.limits);
  add_csv_option(app, options.report);
  add_html_option(app, options.report);
  explain_explorers(app);
  app.example("taut mouse compare mazes/*.maz --explorers flood,score --json scores.json");
}

/// The mazes, the same by index as their names in the contest.
std::vector<GridMaze> read(const CompareOptions& options, Contest& contest) {
  std::vector<GridMaze> mazes;
  for (const std::string& file : options.files) {
    GridMazeInput read = read_mouse_maze(file);
    if (const auto y = micromouse::yardsticks(read.maze)) {
      mazes.push_back(std::move(read.maze));
      contest.mazes.push_back(read.name);
      contest.yardsticks.push_back(*y);
    } else {
      note("taut: " + read.name + ": the maze has no way from the start to the goal; left out");
      contest.without_route.push_back(read.name);
    }
  }
  return mazes;
}

std::string row(const Contest& contest, std::size_t i) {
  const Contest::Summary s = contest.summary(i);
  const auto number = [&](double value) { return s.worst ? fmt::format("{:.3f}", value) : std::string("-"); };
  const double mazes = static_cast<double>(std::max<std::size_t>(contest.scores[i].size(), 1));
  return fmt::format("{:<12}{:>9}{:>9}{:>10}{:>10}{:>8}{:>9.3f}  {}\n", name(contest.explorers[i]), number(s.mean),
                     number(s.mean / s.mean_floor), number(s.worst_score), s.failures, s.proven,
                     contest.seconds[i] / mazes, s.worst ? title_of(contest.mazes[*s.worst]) : "");
}

std::string spread_line(const Contest& contest, std::size_t i) {
  const auto spread = contest.spread(i);
  if (!spread) return "";
  std::string means;
  for (const double mean : spread->means) means += fmt::format("{}{:.3f}", means.empty() ? "" : ", ", mean);
  return fmt::format("{}: {} by seed; standard deviation of the mean {:.3f}, of one maze {:.3f}\n",
                     name(contest.explorers[i]), means, spread->of_means, spread->of_a_maze);
}

/// An explorer that has not been everywhere says so.
std::string table(const Contest& contest) {
  std::string out = fmt::format("{:<12}{:>9}{:>9}{:>10}{:>10}{:>8}{:>9}  {}\n", "explorer", "mean", "/ floor", "worst",
                                "failures", "proven", "CPU s", "worst maze");
  for (std::size_t i = 0; i < contest.scores.size(); ++i) out += row(contest, i);
  out += fmt::format("{}, mean score = run 2 + run 1 / 30 of those finished; CPU seconds a maze\n",
                     count_text(contest.mazes.size(), "maze"));
  for (std::size_t i = 0; i < contest.scores.size(); ++i)
    if (const std::size_t ran = contest.scores[i].size(); ran < contest.mazes.size())
      out += fmt::format("{}: the first {} only\n", name(contest.explorers[i]), count_text(ran, "maze"));
  for (std::size_t i = 0; i < contest.scores.size(); ++i) out += spread_line(contest, i);
  return out;
}

/// Every explorer in every maze; what is finished, in their order, is kept.
class Trials {
 public:
  Trials(const CompareOptions& options, const std::vector<GridMaze>& mazes, Contest& contest, Run& run)
      : options_(options),
        mazes_(mazes),
        contest_(contest),
        run_(run),
        trials_(mazes.size() * options.explorers.size()) {}

  void run_all() {
    const Parallel how{options_.common.limits.jobs, {}, [this](std::size_t over) { note_until(over); }};
    each_in_parallel(trials_.size(), how, [this](std::size_t i) {
      const Stopwatch watch(Stopwatch::Of::thread);
      trials_[i].score = score_of(explorer(i), mazes_[i % mazes_.size()], options_.max_steps, options_.common.seed);
      trials_[i].seconds = watch.seconds().cpu;
    });
    for (int seed = 1; seed < options_.seeds; ++seed) again(seed);
  }

 private:
  struct Trial {
    micromouse::Score score;
    double seconds = 0;
  };

  /// Those that draw, by a further seed.
  void again(int further) {
    contest_.more.resize(options_.explorers.size());
    for (std::size_t e = 0; e < options_.explorers.size(); ++e) {
      if (!is_random(options_.explorers[e])) continue;
      std::vector<micromouse::Score> row(mazes_.size());
      each_in_parallel(mazes_.size(), {options_.common.limits.jobs, {}, {}}, [&](std::size_t k) {
        row[k] = score_of(options_.explorers[e], mazes_[k], options_.max_steps,
                          options_.common.seed + static_cast<std::uint64_t>(further));
      });
      contest_.more[e].push_back(std::move(row));
      run_.so_far(mouse_contest_json(contest_, options_.common.seed), table(contest_));
    }
  }

  Explorer explorer(std::size_t i) const { return options_.explorers[i / mazes_.size()]; }

  void note_until(std::size_t over) {
    for (; noted_ < over; ++noted_, done_.add()) {
      if (noted_ % mazes_.size() == 0) {
        contest_.scores.emplace_back();
        contest_.seconds.push_back(0);
      }
      contest_.scores.back().push_back(std::move(trials_[noted_].score));
      contest_.seconds.back() += trials_[noted_].seconds;
    }
    keeping_.tell([this] { run_.so_far(mouse_contest_json(contest_, options_.common.seed), table(contest_)); });
  }

  const CompareOptions& options_;
  const std::vector<GridMaze>& mazes_;
  Contest& contest_;
  Run& run_;
  std::vector<Trial> trials_;  // by explorer, then maze
  TellProgress show_ = shown_progress(options_.common);
  ProgressCount done_{"trials", trials_.size(), show_};
  std::size_t noted_ = 0;
  Keeping keeping_;
};

int run(const CompareOptions& options, Run& run) {
  run.sources(options.files);
  promise_reports(options.report, run);
  Contest contest;
  contest.explorers = options.explorers;
  const std::vector<GridMaze> mazes = run.stage("read", [&] { return read(options, contest); });
  if (mazes.empty())
    return run.end({.outcome = Outcome::none,
                    .reason = "no maze has a way from its start to its goal",
                    .result = mouse_contest_json(contest, options.common.seed)});
  run.stage("run", [&] { Trials(options, mazes, contest, run).run_all(); });
  Answer answer{.result = mouse_contest_json(contest, options.common.seed), .line = table(contest)};
  add_reports(answer, options.report, "explorers of mazes", "explorer");
  return run.end(std::move(answer));
}

}  // namespace

Command mouse_compare_command(CommandLine& group) {
  return command<CompareOptions>(group, "compare", "All explorers over many mazes: mean, worst, failures", add_options,
                                 run);
}

}  // namespace taut::cli
