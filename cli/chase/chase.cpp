// taut chase: catching a moving target on a cost map.
#include <fmt/format.h>

#include <optional>
#include <string>
#include <vector>

#include <taut/cli/chase/chase_text.h>
#include <taut/cli/chase/options.h>
#include <taut/cli/command.h>
#include <taut/cli/messages.h>
#include <taut/cli/path_files.h>
#include <taut/cli/run.h>
#include <taut/io/pictures/chase_svg.h>
#include <taut/io/results/chase_json.h>

namespace taut::cli {

using namespace pursuit;

namespace {

std::string planner_list() {
  std::string names;
  for (const NamedPursuer& p : chase_pursuers()) names += (names.empty() ? "" : ", ") + std::string(p.name);
  return names;
}

const NamedPursuer* pursuer_of(const std::string& name) {
  if (name == "report") throw UsageError("--planner: report is entry now; did you mean `--planner entry`?");
  const NamedPursuer* found = chase_pursuer(name);
  if (!found) throw UsageError("--planner: '" + name + "' is not one of " + planner_list());
  return found;
}

struct ChaseOptions {
  std::string file;
  const NamedPursuer* pursuer = chase_pursuer("exact");
  bool names_planner = false;
  ChaseRuleOptions rules;
  bool online = false;
  std::optional<int> horizon;
  std::string svg;
  std::string animation;
  bool path = false;
  PathFiles files;
  CommonOptions common;
};

void add_options(CommandLine& app, ChaseOptions& options) {
  app.add_option("MAP", options.file, "The cost map to read, sections N C R T M; - is standard input");
  app.add_option_function(
         "--planner",
         [&options](const std::string& text) {
           options.pursuer = pursuer_of(text);
           options.names_planner = true;
         },
         "Who plans, see below (default: exact)")
      .type_name("NAME")
      .group("Rules");
  app.add_flag("--online", options.online,
               "Do not know the target's way: see it second by second, and the horizon ahead")
      .group("Rules");
  app.add_option("--horizon", options.horizon, "Seconds of the target's way that are seen ahead (default: 0)")
      .type_name("S")
      .range(0, 1'000'000)
      .group("Rules");
  add_chase_rule_options(app, options.rules, options.common.limits);
  add_svg_option(app, options.svg);
  add_animate_option(app, options.animation, "Write a moving picture (SVG)");
  app.add_flag("--path", options.path, "Print where the robot is at each second: `SECOND X,Y`").group("Output");
  add_path_file_options(app, options.files);
  app.optional_subcommand();
  app.callback([&app, &options] {
    if (app.has_subcommand()) return;
    if (options.file.empty()) throw UsageError("MAP is required");
    if (options.horizon && !options.online) throw UsageError("--horizon needs --online");
    if (options.online && options.names_planner) throw UsageError("--online plans by itself, without --planner");
    settle_animation(app, options.animation, options.svg, options.common.json);
  });
  explain_chase_planners(app);
  app.example("taut chase data/town_60x40.chase --svg town.svg");
  app.example("taut chase data/town_60x40.chase --online --horizon 5 --animate town.svg");
}

ChaseRequest request_of(const ChaseOptions& options) {
  ChaseRequest request = options.rules.request(*options.pursuer);
  request.jobs = options.common.limits.jobs;
  if (options.online) request.horizon = options.horizon.value_or(0);
  return request;
}

Outcome outcome_of(const ChaseRun& run) {
  return run.is_caught() ? Outcome::found : run.is_hopeless() ? Outcome::none : Outcome::unproven;
}

// Of those that were asked for.
std::vector<OutputFile> pictures(const ChaseOptions& options, const ChaseMap& map, const ChaseRun& chase) {
  std::vector<OutputFile> files;
  const std::string title = title_of(map.source());
  if (!options.svg.empty()) files.push_back({options.svg, chase_svg(map, chase, title, false)});
  if (!options.animation.empty()) files.push_back({options.animation, chase_svg(map, chase, title, true)});
  return files;
}

std::string effort_text(const ChaseRun& run) {
  return fmt::format("first move after {}, slowest {}, {}, {} expanded, {} labels{}",
                     seconds_text(run.result.first_thought), seconds_text(run.result.longest_thought),
                     count_text(static_cast<std::size_t>(run.plans), "plan"), run.effort.expanded, run.effort.labels,
                     run.seconds_ahead > 0 ? ", planned " + seconds_text(run.seconds_ahead) + " while moving" : "");
}

int run(const ChaseOptions& options, Run& run) {
  run.source(options.file);
  for (const std::string& file : {options.svg, options.animation}) run.promise(file);
  promise(run, options.files);
  const ChaseMap map = run.stage("read", [&] { return read_chase_file(options.file); });
  if (map.rounded()) note(fmt::format("taut: {}: costs have more digits than fit and were rounded", map.source()));
  const ChaseRequest request = request_of(options);
  const auto hear = [&](const ChasePlan& plan) {
    run.so_far(chase_plan_json(map, request, plan), plan_text(map, plan));
  };
  hear({});
  const ChaseRun chase = run.stage("chase", [&] { return run_chase(map, request, hear); });
  Json json = checked_json(map, chase);
  std::vector<OutputFile> files = run.stage("draw", [&] { return pictures(options, map, chase); });
  if (!chase.result.track.empty()) add_path_files(files, options.files, {track_path(map, chase)});
  return run.end({.outcome = outcome_of(chase),
                  .reason = chase.is_caught() ? "" : chase.why_not(),
                  .result = std::move(json),
                  .line = chase_text(map, chase),
                  .listing = options.path ? track_text(map, chase) : "",
                  .stats = {{"chase", effort_text(chase)}},
                  .files = std::move(files)});
}

}  // namespace

std::vector<Command> chase_commands(CommandLine& app) {
  Command chase =
      command<ChaseOptions>(app, "chase", "Catch a moving target on a cost map at least cost", add_options, run);
  return {chase_compare_command(*chase.line), chase_generate_command(*chase.line), chase_plane_command(*chase.line),
          chase};
}

}  // namespace taut::cli
