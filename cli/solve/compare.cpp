// taut compare: planners side by side on one maze.
#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <taut/cli/command.h>
#include <taut/cli/command_line.h>
#include <taut/cli/input.h>
#include <taut/cli/jobs.h>
#include <taut/cli/messages.h>
#include <taut/cli/run.h>
#include <taut/cli/shards.h>
#include <taut/cli/solve/compare_report.h>
#include <taut/cli/solve/packed_runs.h>
#include <taut/cli/solve/prm_options.h>
#include <taut/cli/stop.h>
#include <taut/cli/world/snap_ends.h>
#include <taut/geometry/errors.h>
#include <taut/geometry/parallel.h>
#include <taut/geometry/rounding.h>
#include <taut/io/pictures/comparison_svg.h>
#include <taut/io/results/comparison_json.h>
#include <taut/io/results/words.h>
#include <taut/io/saved/packed.h>
#include <taut/io/saved/roadmap_file.h>
#include <taut/io/saved/shard_file.h>
#include <taut/search/no_path.h>
#include <taut/search/planners.h>
#include <taut/search/query_ends.h>

namespace taut::cli {

namespace {

struct CompareOptions {
  WorldOptions world;
  QueryOptions query;
  CommonOptions common;
  std::vector<const Planner*> chosen;
  std::size_t runs = 1;
  PrmRequest prm;
  std::string svg;
  ShardOptions shards;
};

std::vector<Choice> choices() {
  std::vector<Choice> choices;
  for (const Planner& p : planners()) choices.emplace_back(p.name, p.what);
  return choices;
}

std::vector<const Planner*> planners_in(const std::string& list) {
  std::vector<const Planner*> chosen;
  for (std::size_t from = 0; from <= list.size();) {
    const std::size_t comma = std::min(list.find(',', from), list.size());
    const std::string name = list.substr(from, comma - from);
    chosen.push_back(planner(name));
    if (!chosen.back()) throw not_one_of(name, choices());
    from = comma + 1;
  }
  return chosen;
}

void check(const CompareOptions& options) {
  if (options.shards.is_shared() && !options.svg.empty())
    throw UsageError("--svg draws roadmaps, which shards do not keep");
  require_one_stdout({{"--svg", options.svg}, {"--json", options.common.json}});
  const auto is_prm = [](const Planner* p) { return roadmap_kind(p->kind)->is_prm; };
  if (!first_option(options.prm).empty() && !options.chosen.empty() &&
      std::none_of(options.chosen.begin(), options.chosen.end(), is_prm))
    throw UsageError(first_option(options.prm) + " makes no sense here: none of --planners is a prm");
  for (const Planner* p : options.chosen)
    if (is_prm(p)) require_prm_options_fit(options.prm, *roadmap_kind(p->kind));
}

void add_options(CommandLine& app, CompareOptions& options) {
  add_world_options(app, options.world);
  add_query_options(app, options.query);
  app.add_option_function(
         "--planners", [&options](const std::string& list) { options.chosen = planners_in(list); },
         "Which, separated by commas, see below (default: all that fit)")
      .type_name("LIST")
      .group("Planners");
  app.explain("Planners", choices());
  app.add_option("--runs", options.runs,
                 "How often each randomised planner runs, with seeds --seed, --seed + 1, ... (default: 1)")
      .type_name("N")
      .range(1, 100000)
      .group("Planners");
  app.renamed("--roadmap", "--planners");
  add_prm_options(app, options.prm, true);
  add_jobs_option(app, options.common.limits);
  add_shard_options(app, options.shards, options.common);
  add_svg_option(app, options.svg);
  app.callback([&options] { check(options); });
  app.example("taut compare maze.txt --svg planners.svg");
  app.example("taut compare maze.txt --planners polyanya,prm,prm-funnel --runs 20");
}

// Runs the planners; what is finished, in their order, is kept.
class Comparer {
 public:
  Comparer(const CompareOptions& options, Run& run, const Input& input, const FreeSpace& space)
      : options_(options),
        run_(run),
        space_(space),
        work_(work_mark(options, input)),
        comparison_{*input.world.start(), input.world.goal(), options.common.seed, options.runs} {
    comparison_.within = path_bound(space);
    plan();
  }

  /// One run of one planner is an item.
  int do_shard() {
    Answer answer = run_.stage("planners", [&] { return cli::do_shard(options_.shards, items(), run_); });
    end_progress();
    return run_.end(std::move(answer));
  }

  Comparison compare() {
    run_.stage("planners", [&] {
      if (options_.shards.is_shared()) return take();
      each_in_parallel(tasks_.size(), {options_.common.limits.jobs, {}, [this](std::size_t over) { note_until(over); }},
                       [this](std::size_t i) { tasks_[i].done = done(tasks_[i]); });
    });
    end_progress();
    find_optimum();
    return std::move(comparison_);
  }

 private:
  /// One run of one planner; or none at all.
  struct Task {
    const Planner* planner;
    std::size_t run;
    bool is_last;
    std::string too_large{};
    PlannerRuns done{};
  };

  /// What results depend on.
  static std::string work_mark(const CompareOptions& options, const Input& input) {
    if (!options.shards.is_shared()) return {};
    const Goal& goal = input.world.goal();
    Packer packer;
    packer.put(*input.world.start()).put(goal.point.value_or(Point{})).put(std::uint64_t{goal.room.size()});
    for (const Box& box : goal.room) packer.put(box.min).put(box.max);
    const std::string texts[] = {TAUT_VERSION, options.shards.how, fingerprint(input.world), std::move(packer).bytes()};
    return mark_of(texts);
  }

  Items items() {
    return {work_, tasks_.size(), [] {},
            [this] { return [this](std::size_t i) { return packed_runs(done(tasks_[i])); }; }};
  }

  void take() {
    take_all(options_.shards, items(), run_, [this](std::size_t i, std::string_view bytes) {
      tasks_[i].done = unpacked_runs(*tasks_[i].planner, bytes, fmt::format("item {} of the shards", i));
      note_until(i + 1);
    });
  }

  void plan() {
    std::vector<const Planner*> list = options_.chosen;
    if (list.empty())
      for (const Planner& p : planners()) list.push_back(&p);
    for (const Planner* p : list) {
      const std::string why = options_.chosen.empty() ? too_large(*p, space_) : "";
      const std::size_t runs = why.empty() && roadmap_kind(p->kind)->random ? options_.runs : 1;
      for (std::size_t i = 0; i < runs; ++i) tasks_.push_back({p, i, i + 1 == runs, why});
    }
  }

  PlannerRuns done(const Task& task) const {
    if (!task.too_large.empty()) return {task.planner, false, {}, task.too_large + "; ask for it with --planners"};
    begin_stage(task.planner->name);
    return runs_of(*task.planner, task.run);
  }

  PlannerRuns runs_of(const Planner& p, std::size_t number) const {
    return run_planner(
        p, space_, comparison_.start, comparison_.goal, options_.common.seed + number, 1,
        {1, {}, {}, options_.prm, options_.common.limits.seconds.has_value(), prm_progress(options_.common.quiet)});
  }

  /// A planner that is unfit in one run, as for a world that is none of cells, is unfit.
  void note_until(std::size_t over) {
    for (; noted_ < over; ++noted_) {
      Task& task = tasks_[noted_];
      if (task.run == 0) {
        runs_ = std::move(task.done);
      } else if (!task.done.unfit.empty()) {
        runs_.runs.clear();
        runs_.unfit = task.done.unfit;
      } else if (runs_.unfit.empty()) {
        runs_.runs.push_back(std::move(task.done.runs.front()));
      }
      if (task.is_last) note_planner();
    }
  }

  void note_planner() {
    comparison_.add(std::move(runs_));
    refuse_if_asked_for(comparison_.planners.back());
    run_.so_far(comparison_json(comparison_), comparison_table(comparison_));
  }

  void refuse_if_asked_for(const PlannerRuns& runs) const {
    if (!options_.chosen.empty() && !runs.unfit.empty())
      throw InputError("", 0, fmt::format("{} cannot run: {}", runs.planner->name, runs.unfit));
  }

  /// The shortest path in the plane: where none of the planners promises that, it is found here.
  void find_optimum() {
    const auto is_optimal = [](const PlannerRuns& runs) { return runs.optimal && !runs.runs.empty(); };
    if (std::ranges::none_of(comparison_.planners, is_optimal))
      if (const PlannerRuns best = runs_of(planners()[0], 0); best.solved() > 0)
        comparison_.optimum = best.typical().path.length;
    comparison_.is_shut = !comparison_.optimum && NoPath(space_).walls(comparison_.start, comparison_.goal).has_value();
  }

  const CompareOptions& options_;
  Run& run_;
  const FreeSpace& space_;
  std::string work_;  // of shards
  Comparison comparison_;
  std::vector<Task> tasks_;  // by planner, then run
  std::size_t noted_ = 0;
  PlannerRuns runs_;  // of the planner that is being noted
};

Outcome outcome_of(const Comparison& comparison) {
  return comparison.optimum ? Outcome::found : comparison.is_shut ? Outcome::none : Outcome::unproven;
}

std::string reason_for(Outcome outcome) {
  if (outcome == Outcome::none) return "walls separate start and goal";
  return outcome == Outcome::unproven ? "no planner found a path, and no walls prove that there is none" : "";
}

/// A path that fails the check is a defect of its planner, whatever the others found.
void require_verified(const Comparison& comparison) {
  const PlannerRuns* const wrong = comparison.wrong();
  if (wrong == nullptr) return;
  note(comparison_table(comparison));
  throw std::logic_error(fmt::format("a path of {} does not pass the check", wrong->planner->name));
}

int run(const CompareOptions& options, Run& run) {
  run.source(options.world.file);
  run.promise(options.svg);
  const Input input = read_input(options.world, options.query, run);
  require_ends(input);
  const FreeSpace space = run.stage("space", [&] { return triangulated(FreeSpace(input.world, options.query.robot)); });
  require_free(space, *input.world.start(), "start");
  if (input.world.goal().point) require_free(space, *input.world.goal().point, "goal");
  Comparer comparer(options, run, input, space);
  if (options.shards.shard > 0) return comparer.do_shard();
  const Comparison comparison = comparer.compare();
  require_verified(comparison);
  for (const PlannerRuns& p : comparison.planners)
    if (!p.unfit.empty()) note(fmt::format("taut: {} did not run: {}", p.planner->name, p.unfit));
  Answer answer;
  answer.outcome = outcome_of(comparison);
  answer.reason = reason_for(answer.outcome);
  if (answer.outcome == Outcome::unproven) complain(answer.reason);
  answer.result = comparison_json(comparison);
  answer.line = comparison_table(comparison);
  if (!options.svg.empty())
    answer.files = {{options.svg, comparison_svg(comparison, space, title_of(input.name), input.moves)}};
  return run.end(std::move(answer));
}

}  // namespace

Command compare_command(CommandLine& app) {
  return command<CompareOptions>(app, "compare", "Let several planners solve the same maze, side by side", add_options,
                                 run);
}

}  // namespace taut::cli
