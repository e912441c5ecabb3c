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
#include <taut/cli/progress.h>
#include <taut/cli/run.h>
#include <taut/cli/shards.h>
#include <taut/cli/solve/compare_report.h>
#include <taut/cli/solve/comparer.h>
#include <taut/cli/solve/prm_options.h>
#include <taut/cli/world/snap_ends.h>
#include <taut/geometry/errors.h>
#include <taut/io/pictures/comparison_svg.h>
#include <taut/io/results/comparison_json.h>
#include <taut/io/results/report.h>
#include <taut/io/results/words.h>
#include <taut/search/planners.h>
#include <taut/search/query_ends.h>

namespace taut::cli {

namespace {

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
  if (!options.more.empty() && (!options.svg.empty() || options.shards.is_shared()))
    throw UsageError("--svg, --shard, --join and --mpi are for one world");
  require_one_stdout({{"--svg", options.svg},
                      {"--json", options.common.json},
                      {"--csv", options.report.csv},
                      {"--html", options.report.html}});
  const auto is_prm = [](const Planner* p) { return roadmap_kind(p->kind)->is_prm; };
  if (!first_option(options.prm).empty() && !options.chosen.empty() &&
      std::none_of(options.chosen.begin(), options.chosen.end(), is_prm))
    throw UsageError(first_option(options.prm) + " makes no sense here: none of --planners is a prm");
  for (const Planner* p : options.chosen)
    if (is_prm(p)) require_prm_options_fit(options.prm, *roadmap_kind(p->kind));
}

void add_options(CommandLine& app, CompareOptions& options) {
  add_world_options(app, options.world);
  app.add_option("MORE", options.more,
                 "Further worlds: then each planner's success, lengths and times over all of them");
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
  add_csv_option(app, options.report);
  add_html_option(app, options.report);
  app.callback([&options] { check(options); });
  app.example("taut compare maze.txt --svg planners.svg");
  app.example("taut compare maze.txt --planners polyanya,prm,prm-funnel --runs 20");
  app.example("taut compare mazes/*.txt --runs 5 --html planners.html --csv planners.csv");
}

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

// A world, read and made ready.
struct Arena {
  Input input;
  FreeSpace space;
};

Arena arena_of(const WorldOptions& world, const QueryOptions& query, Run& run) {
  Input input = read_input(world, query, run);
  require_ends(input);
  FreeSpace space = run.stage("space", [&] { return triangulated(FreeSpace(input.world, query.robot)); });
  require_free(space, *input.world.start(), "start");
  if (input.world.goal().point) require_free(space, *input.world.goal().point, "goal");
  return {std::move(input), std::move(space)};
}

Comparison compare(const CompareOptions& options, Run& run, const Arena& arena, const NoteComparison& tell) {
  Comparison comparison = compare_planners(options, run, arena.input, arena.space, tell);
  require_verified(comparison);
  for (const PlannerRuns& p : comparison.planners)
    if (!p.unfit.empty()) note(fmt::format("taut: {} did not run: {}", p.planner->name, p.unfit));
  return comparison;
}

// Several worlds: what was found on each goes into the result, its roadmaps are let go.
int run_many(const CompareOptions& options, Run& run, const std::vector<std::string>& files) {
  Json worlds = Json::array();
  const TellProgress tell = shown_progress(options.common);
  Answer answer;
  ProgressCount done("worlds", files.size(), tell);
  for (const std::string& file : files) {
    WorldOptions world = options.world;
    world.file = file;
    const Comparison comparison = compare(options, run, arena_of(world, options.query, run), [](const Comparison&) {});
    Json json{{"file", file}, {"status", name(outcome_of(comparison))}};
    const Json found = comparison_json(comparison);
    for (const auto& [key, value] : *found.members()) json[key] = value;
    worlds.push_back(std::move(json));
    answer.result = {{"worlds", worlds}};
    const Json summary = report_summary(report_rows(answer.result), "name");
    answer.line = worlds_table(summary);
    answer.result["summary"] = summary;
    run.so_far(answer.result, answer.line);
    done.add();
  }
  add_reports(answer, options.report, fmt::format("{} worlds", files.size()), "name");
  return run.end(std::move(answer));
}

// What many runs come to: the rate of success and quartiles.
std::string runs_table(const Json& result) { return "\n" + worlds_table(report_summary(report_rows(result), "name")); }

int run(const CompareOptions& options, Run& run) {
  std::vector<std::string> files{options.world.file};
  files.insert(files.end(), options.more.begin(), options.more.end());
  run.sources(files);
  run.promise(options.svg);
  promise_reports(options.report, run);
  if (files.size() > 1) return run_many(options, run, files);
  const Arena arena = arena_of(options.world, options.query, run);
  if (options.shards.shard > 0) return compare_shard(options, run, arena.input, arena.space);
  const auto keep = [&](const Comparison& c) { run.so_far(comparison_json(c), comparison_table(c)); };
  const Comparison comparison = compare(options, run, arena, keep);
  Answer answer;
  answer.outcome = outcome_of(comparison);
  answer.reason = reason_for(answer.outcome);
  if (answer.outcome == Outcome::unproven) complain(answer.reason);
  answer.result = comparison_json(comparison);
  answer.line = comparison_table(comparison);
  if (options.runs > 1) answer.line += runs_table(answer.result);
  if (!options.svg.empty())
    answer.files = {
        {options.svg, comparison_svg(comparison, arena.space, title_of(arena.input.name), arena.input.moves)}};
  add_reports(answer, options.report, title_of(arena.input.name), "name");
  return run.end(std::move(answer));
}

}  // namespace

Command compare_command(CommandLine& app) {
  return command<CompareOptions>(app, "compare", "Let several planners solve the same maze, side by side", add_options,
                                 run);
}

}  // namespace taut::cli
