#include <taut/cli/solve/comparer.h>

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include <taut/cli/messages.h>
#include <taut/cli/progress.h>
#include <taut/cli/solve/packed_runs.h>
#include <taut/cli/solve/prm_options.h>
#include <taut/cli/stop.h>
#include <taut/geometry/errors.h>
#include <taut/geometry/parallel.h>
#include <taut/geometry/rounding.h>
#include <taut/io/saved/packed.h>
#include <taut/io/saved/roadmap_file.h>
#include <taut/io/saved/shard_file.h>
#include <taut/search/no_path.h>

namespace taut::cli {

namespace {

// Runs the planners; what is finished, in their order, is kept.
class Comparer {
 public:
  Comparer(const CompareOptions& options, Run& run, const Input& input, const FreeSpace& space, NoteComparison note)
      : options_(options),
        run_(run),
        space_(space),
        tell_(std::move(note)),
        tell_progress_(options.more.empty() ? shown_progress(options.common) : nullptr),  // else worlds are told
        work_(work_mark(options, input)),
        comparison_{*input.world.start(), input.world.goal(), options.common.seed, options.runs} {
    comparison_.within = path_bound(space);
    plan();
  }

  /// One run of one planner is an item.
  int do_shard() {
    return run_.end(run_.stage("planners", [&] { return cli::do_shard(options_.shards, items(), run_); }));
  }

  Comparison compare() {
    run_.stage("planners", [&] {
      if (options_.shards.is_shared()) return take();
      if (tell_progress_) tell_progress_({"runs", 0, tasks_.size()});
      each_in_parallel(tasks_.size(), {options_.common.limits.jobs, {}, [this](std::size_t over) { note_until(over); }},
                       [this](std::size_t i) { tasks_[i].done = done(tasks_[i]); });
    });
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
    return run_planner(p, space_, comparison_.start, comparison_.goal, options_.common.seed + number, 1,
                       {1, {}, {}, options_.prm, options_.common.limits.seconds.has_value()});
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
    if (tell_progress_) tell_progress_({"runs", noted_, tasks_.size()});
  }

  void note_planner() {
    comparison_.add(std::move(runs_));
    refuse_if_asked_for(comparison_.planners.back());
    tell_(comparison_);
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
  NoteComparison tell_;
  TellProgress tell_progress_;
  std::string work_;  // of shards
  Comparison comparison_;
  std::vector<Task> tasks_;  // by planner, then run
  std::size_t noted_ = 0;
  PlannerRuns runs_;  // of the planner that is being noted
};

}  // namespace

Comparison compare_planners(const CompareOptions& options, Run& run, const Input& input, const FreeSpace& space,
                            const NoteComparison& note) {
  return Comparer(options, run, input, space, note).compare();
}

int compare_shard(const CompareOptions& options, Run& run, const Input& input, const FreeSpace& space) {
  return Comparer(options, run, input, space, [](const Comparison&) {}).do_shard();
}

}  // namespace taut::cli
