// taut bug: a robot that touches walls, or sees some way, by Bug 1, Bug 2 or Tangent Bug.
#include <fmt/format.h>

#include <taut/cli/bug/compare.h>
#include <taut/cli/bug/journey.h>
#include <taut/cli/command.h>
#include <taut/cli/messages.h>
#include <taut/cli/path_files.h>
#include <taut/io/pictures/bug_svg.h>
#include <taut/io/results/bug_json.h>

namespace taut::cli {

using bug::Algorithm;
using bug::Journey;

namespace {

struct BugOptions {
  WorldOptions world;
  QueryOptions query;
  CommonOptions common;
  bug::Options bug;
  std::string svg;
  std::string animation;
  PathFiles files;
};

Algorithm algorithm_of(const std::string& text) {
  if (text == "1") return Algorithm::bug1;
  if (text == "2") return Algorithm::bug2;
  for (const Algorithm algorithm : {Algorithm::bug1, Algorithm::bug2, Algorithm::tangent})
    if (text == name(algorithm)) return algorithm;
  throw UsageError("'" + text + "' is not bug1, bug2 or tangent");
}

void require_sense(const CommandLine& app, BugOptions& options) {
  if (options.world.file.empty()) throw UsageError("FILE is required");
  settle_animation(app, options.animation, options.svg, options.common.json);
  if (app.count("--range") > 0 && options.bug.algorithm != Algorithm::tangent)
    throw UsageError(fmt::format("--range is for --algorithm tangent: {} only touches", name(options.bug.algorithm)));
}

void add_options(CommandLine& app, BugOptions& options) {
  add_world_options(app, options.world).required(false);  // not when `compare` follows
  add_query_options(app, options.query);
  app.add_option_function(
         "--algorithm", [&options](const std::string& text) { options.bug.algorithm = algorithm_of(text); },
         "Whose rules, see below (default: bug2)")
      .type_name("NAME")
      .group("Query");
  app.add_option_function(
         "--range", [&options](const std::string& text) { options.bug.range = bug_range_of(text); },
         "How far tangent sees: a number, 0 is touch alone, or inf (default)")
      .type_name("R")
      .group("Query");
  add_turn_option(app, options.bug);
  add_svg_option(app, options.svg);
  add_path_file_options(app, options.files);
  add_animate_option(app, options.animation, "Write a picture in which the robot moves");
  app.optional_subcommand();
  app.callback([&app, &options] {
    if (!app.has_subcommand()) require_sense(app, options);
  });
  explain_bugs(app);
  app.example("taut bug data/maze_25x25.txt --algorithm tangent --range 2 --svg bug.svg");
}

// Of those that were asked for.
std::vector<OutputFile> pictures(const BugOptions& options, const BugWorld& world, const Journey& journey) {
  bug::BugPicture picture{title_of(world.name),  bug_facts(world, options.bug, journey, false),
                          world.start,           world.goal,
                          options.bug.algorithm, world.moves};
  std::vector<OutputFile> files;
  for (const bool moves : {false, true}) {
    const std::string& file = moves ? options.animation : options.svg;
    picture.moves = moves;
    if (!file.empty()) files.push_back({file, bug_svg(world.space, journey, picture)});
  }
  return files;
}

int run(const BugOptions& options, Run& run) {
  run.source(options.world.file);
  for (const std::string& file : {options.svg, options.animation}) run.promise(file);
  promise(run, options.files);
  const BugWorld world = read_bug_world(options.world, options.query, run);
  Json known{{"algorithm", name(options.bug.algorithm)}, {"length", nullptr}};
  if (world.shortest) known["shortest"] = world.shortest->value();
  run.so_far(std::move(known));
  bug::Options how = options.bug;
  how.record_views = !options.svg.empty() || !options.animation.empty();
  const Journey journey = checked_journey(world, how, run);
  std::vector<OutputFile> files = run.stage("draw", [&] { return pictures(options, world, journey); });
  add_path_files(files, options.files,
                 {{.name = std::string(name(options.bug.algorithm)),
                   .points = journey.path.points,
                   .length = journey.path.length.value()}});
  return run.end({.outcome = outcome_of(world),
                  .reason = reason_of(world),
                  .result = bug_json(journey, how, world.start, world.goal, world.shortest),
                  .line = fmt::format("{}: {}, {}\n", world.name, fmt::join(bug_facts(world, how, journey, true), ", "),
                                      seconds_text(run.seconds().cpu)),
                  .files = std::move(files)});
}

}  // namespace

std::vector<Command> bug_commands(CommandLine& app) {
  Command bug = command<BugOptions>(
      app, "bug", "Find the way by touch (Bug 1, Bug 2) or by sight (Tangent Bug), with its length bound", add_options,
      run);
  return {bug_compare_command(*bug.line), bug};
}

}  // namespace taut::cli
