// taut compare: planners side by side on one maze.
#include <fmt/format.h>

#include <algorithm>
#include <string>

#include <taut/cli/command.h>
#include <taut/cli/command_line.h>
#include <taut/cli/exit_code.h>
#include <taut/cli/input.h>
#include <taut/cli/messages.h>
#include <taut/cli/output.h>
#include <taut/cli/report.h>
#include <taut/cli/solve/compare_report.h>
#include <taut/cli/solve/planners.h>
#include <taut/cli/timing.h>
#include <taut/search/no_path.h>
#include <taut/search/query_ends.h>

namespace taut::cli {

namespace {

constexpr std::size_t kMostPlaces =
    20'000;  // beyond it a full visibility graph may take all memory: only when asked for

struct CompareOptions {
  WorldOptions world;
  QueryOptions query;
  OutputOptions output;
  CommonOptions common;
  std::vector<const Planner*> chosen;
  std::size_t runs = 1;
  PrmRequest prm;
};

std::vector<const Planner*> planners_in(const std::string& list) {
  std::vector<const Planner*> chosen;
  for (std::size_t from = 0; from <= list.size();) {
    const std::size_t comma = std::min(list.find(',', from), list.size());
    const std::string name = list.substr(from, comma - from);
    chosen.push_back(planner(name));
    if (!chosen.back()) throw UsageError("--planners: '" + name + "' is not one of " + planner_names());
    from = comma + 1;
  }
  return chosen;
}

void add_options(CommandLine& app, CompareOptions& options) {
  add_world_options(app, options.world);
  add_query_options(app, options.query);
  app.add_option_function(
         "--planners", [&options](const std::string& list) { options.chosen = planners_in(list); },
         "Which, separated by commas (default: all that fit): " + planner_names())
      .type_name("LIST")
      .group("Planners");
  app.add_option("--runs", options.runs,
                 "How often each randomised planner runs, with seeds --seed, --seed + 1, ... (default: 1)")
      .type_name("N")
      .range(1, 100000)
      .group("Planners");
  add_prm_options(app, options.prm, true);
  add_output_options(app, options.output);
  app.callback([&options] {
    if (options.output.svg == "-" && options.output.json == "-")
      throw UsageError("--svg - and --json - cannot both have standard output");
    const auto is_prm = [](const Planner* p) { return roadmap_kind(p->kind)->is_prm; };
    if (!options.prm.first().empty() && !options.chosen.empty() &&
        std::none_of(options.chosen.begin(), options.chosen.end(), is_prm))
      throw UsageError(options.prm.first() + " makes no sense here: none of --planners is a prm");
    for (const Planner* p : options.chosen)
      if (is_prm(p)) require_prm_options_fit(options.prm, *roadmap_kind(p->kind));
  });
}

std::string unfit(const Planner& planner, const FreeSpace& space, bool asked_for) {
  const std::size_t places = space.triangulation().sectors.size();
  if (asked_for || std::string(planner.kind) != "full" || places <= kMostPlaces) return {};
  return fmt::format("{} places are many for a full visibility graph; ask for it with --planners", places);
}

/// The shortest path in the plane: from the list's first planner that finds it, else found here.
Comparison compare(const CompareOptions& options, const Input& input, const FreeSpace& space) {
  Comparison comparison{input.name, *input.world.start(), input.world.goal(), options.common.seed, options.runs};
  const auto run = [&](const Planner& p) {
    return run_planner(
        p, space, comparison.start, comparison.goal, options.common.seed, options.runs,
        {1, {}, {}, options.prm, options.common.limits.seconds.has_value(), prm_progress(options.output.quiet)});
  };
  std::vector<const Planner*> list = options.chosen;
  if (list.empty())
    for (const Planner& p : planners()) list.push_back(&p);
  for (const Planner* p : list) {
    const std::string why = unfit(*p, space, !options.chosen.empty());
    comparison.planners.push_back(why.empty() ? run(*p) : PlannerRuns{p, false, {}, why});
    const PlannerRuns& last = comparison.planners.back();
    if (!options.chosen.empty() && !last.unfit.empty())
      throw InputError("", 0, fmt::format("{} cannot run: {}", p->name, last.unfit));
    if (!comparison.optimum && last.optimal && last.solved() > 0) comparison.optimum = last.typical().path.length;
  }
  const auto is_optimal = [](const PlannerRuns& runs) { return runs.optimal && !runs.runs.empty(); };
  if (std::none_of(comparison.planners.begin(), comparison.planners.end(), is_optimal))
    if (const PlannerRuns best = run(planners()[0]); best.solved() > 0) comparison.optimum = best.typical().path.length;
  comparison.is_shut = !comparison.optimum && NoPath(space).walls(comparison.start, comparison.goal).has_value();
  return comparison;
}

/// A path that fails the check is a defect of its planner, whatever the others found.
int exit_code(const Comparison& comparison) {
  if (const PlannerRuns* wrong = comparison.wrong()) {
    complain(fmt::format("internal error: a path of {} does not pass the check", wrong->planner->name));
    return kInternal;
  }
  if (comparison.optimum) return kFound;
  if (comparison.is_shut) return kNone;
  complain("no planner found a path, and no walls prove that there is none");
  return kStopped;
}

int run(const CompareOptions& options) {
  require_writable(options.output.svg);
  require_writable(options.output.json);
  const Stopwatch total;
  double read = 0, build = 0;
  const Input input = timed("read", read, [&] { return read_input(options.world, options.query); });
  require_ends(input);
  const FreeSpace space = timed("space", build, [&] { return FreeSpace(input.world, options.query.robot); });
  require_free(space, *input.world.start(), "start");
  if (input.world.goal().point) require_free(space, *input.world.goal().point, "goal");
  const Comparison comparison = compare(options, input, space);
  begin_stage("write");
  const std::string drawing = options.output.svg.empty() ? "" : comparison_svg(comparison, space);
  const std::string json = options.output.json.empty() ? "" : comparison_json(comparison);
  finish();
  write_file(options.output.svg, drawing);
  write_file(options.output.json, json);
  if (!options.output.quiet && !options.output.stdout_taken()) print(comparison_table(comparison));
  for (const PlannerRuns& p : comparison.planners)
    if (!p.unfit.empty()) note(fmt::format("taut: {} did not run: {}", p.planner->name, p.unfit));
  if (options.output.stats)
    note(fmt::format("read {:.4f} s, free space {:.4f} s, total {:.4f} s, peak memory {}", read, build, total.seconds(),
                     peak_memory_text()));
  return exit_code(comparison);
}

}  // namespace

Command compare_command(CommandLine& app) {
  return command<CompareOptions>(app, "compare", "Let several planners solve the same maze, side by side", add_options,
                                 run);
}

}  // namespace taut::cli
