// taut bug: a robot that touches walls, or sees some way, by Bug 1, Bug 2 or Tangent Bug; taut bug compare: all of
// them.
#include <fmt/format.h>

#include <algorithm>

#include <taut/cli/bug/run.h>
#include <taut/cli/command.h>
#include <taut/cli/command_line.h>
#include <taut/cli/exit_code.h>
#include <taut/cli/output.h>
#include <taut/cli/report.h>
#include <taut/cli/timing.h>

namespace taut::cli {

using bug::Algorithm;
using bug::Journey;

namespace {

void add_turn_option(CommandLine& app, bug::Options& options) {
  app.add_option_function(
         "--turn", [&options](const std::string& text) { options.turn = bug_turn_of(text); },
         "Where to turn at an obstacle (tangent: when both sides promise the same): left (default) or right")
      .type_name("SIDE")
      .group("Query");
}

// ---- taut bug FILE

struct BugOptions {
  WorldOptions world;
  QueryOptions query;
  OutputOptions output;
  CommonOptions common;
  bug::Options bug;
  std::string animation;
};

void require_sense(const CommandLine& app, BugOptions& options) {
  if (options.world.file.empty()) throw UsageError("FILE is required");
  settle_animation(app, options.animation, options.output.svg, options.output.json);
  if (app.count("--range") > 0 && options.bug.algorithm != Algorithm::tangent)
    throw UsageError("--range is for --algorithm tangent: " + name_of(options.bug.algorithm) + " only touches");
}

void add_options(CommandLine& app, BugOptions& options) {
  add_world_options(app, options.world).required(false);  // not when `compare` follows
  add_query_options(app, options.query);
  app.add_option_function(
         "--algorithm", [&options](const std::string& text) { options.bug.algorithm = bug_algorithm_of(text); },
         "bug1, bug2 (default) or tangent")
      .type_name("NAME")
      .group("Query");
  app.add_option_function(
         "--range", [&options](const std::string& text) { options.bug.range = bug_range_of(text); },
         "How far tangent sees: a number, 0 is touch alone, or inf (default)")
      .type_name("R")
      .group("Query");
  add_turn_option(app, options.bug);
  add_output_options(app, options.output);
  add_animate_option(app, options.animation, "Write a picture in which the robot moves");
  app.optional_subcommand();
  app.callback([&app, &options] {
    if (!app.has_subcommand()) require_sense(app, options);
  });
}

int run(const BugOptions& options) {
  const Stopwatch total;
  for (const std::string& file : {options.output.svg, options.output.json, options.animation}) require_writable(file);
  const BugWorld world = read_bug_world(options.world, options.query);
  bug::Options how = options.bug;
  how.record_views = !options.output.svg.empty() || !options.animation.empty();
  const Journey journey = checked_journey(world, how);
  begin_stage("write");
  const std::string picture = options.output.svg.empty() ? "" : bug_svg(world, how, journey, false);
  const std::string animation = options.animation.empty() ? "" : bug_svg(world, how, journey, true);
  const std::string json = options.output.json.empty() ? "" : bug_json(world, how, journey);
  finish();
  write_file(options.output.svg, picture);
  write_file(options.animation, animation);
  write_file(options.output.json, json);
  if (!options.output.quiet && !options.output.stdout_taken() && options.animation != "-")
    print(fmt::format("{}: {}, {}\n", world.name, fmt::join(bug_facts(world, how, journey), ", "),
                      seconds_text(total.seconds())));
  return journey.reached ? kFound : world.is_shut ? kNone : kStopped;
}

// ---- taut bug compare FILE...

struct CompareOptions {
  WorldOptions world;
  std::vector<std::string> files;
  QueryOptions query;
  CommonOptions common;
  bug::Options bug;
  std::vector<double> ranges{0, bug_range_of("inf")};
};

std::vector<double> ranges_in(const std::string& list) {
  std::vector<double> ranges;
  for (std::size_t from = 0; from <= list.size();) {
    const std::size_t comma = std::min(list.find(',', from), list.size());
    ranges.push_back(bug_range_of(list.substr(from, comma - from)));
    from = comma + 1;
  }
  return ranges;
}

void add_compare_options(CommandLine& app, CompareOptions& options) {
  app.add_option("FILE", options.files, "Worlds").required();
  add_query_options(app, options.query);
  app.add_option_function(
         "--range", [&options](const std::string& list) { options.ranges = ranges_in(list); },
         "The ranges of tangent, separated by commas (default: 0,inf)")
      .type_name("LIST")
      .group("Query");
  add_turn_option(app, options.bug);
}

std::string row(const BugWorld& world, const bug::Options& options, const Journey& journey) {
  const auto ratio = ratio_of(world, journey);
  std::size_t followed = 0;
  for (const bug::Obstacle& o : journey.obstacles) followed += o.hits;
  return fmt::format("{:<24} {:<8} {:>6} {:>8} {:>14} {:>8} {:>14} {:>9}\n", title_of(world.name),
                     name_of(options.algorithm),
                     options.algorithm == Algorithm::tangent ? range_text(options.range) : "",
                     journey.reached ? "found" : "none", journey.path.length.decimals(6),
                     ratio ? fmt::format("{:.3f}", *ratio) : "", fmt::format("{:.6f}", journey.bound.hi), followed);
}

std::string rows(const BugWorld& world, const CompareOptions& options) {
  std::string text;
  const auto add = [&](Algorithm algorithm, double range) {
    const bug::Options how{algorithm, options.bug.turn, range};
    text += row(world, how, checked_journey(world, how));
  };
  add(Algorithm::bug1, 0);
  add(Algorithm::bug2, 0);
  for (const double range : options.ranges) add(Algorithm::tangent, range);
  return text + fmt::format("{:<24} {:<8} {:>6} {:>8} {:>14}\n", title_of(world.name), "shortest", "",
                            world.shortest ? "found" : "none", world.shortest ? world.shortest->decimals(6) : "");
}

int run_compare(const CompareOptions& options) {
  std::string table = fmt::format("{:<24} {:<8} {:>6} {:>8} {:>14} {:>8} {:>14} {:>9}\n", "world", "robot", "range",
                                  "goal", "length", "ratio", "bound", "followed");
  int code = kFound;
  for (const std::string& file : options.files) {
    WorldOptions one = options.world;
    one.file = file;
    const BugWorld world = read_bug_world(one, options.query);
    table += rows(world, options);
    code = std::max<int>(code, world.shortest ? kFound : world.is_shut ? kNone : kStopped);
  }
  finish();
  print(table);
  return code;
}

}  // namespace

std::vector<Command> bug_commands(CommandLine& app) {
  Command bug = command<BugOptions>(
      app, "bug", "Find the way by touch (Bug 1, Bug 2) or by sight (Tangent Bug), with its length bound", add_options,
      run);
  CommandLine& group = *bug.line;
  return {command<CompareOptions>(group, "compare", "All bugs on the same worlds, beside the shortest path",
                                  add_compare_options, run_compare),
          std::move(bug)};
}

}  // namespace taut::cli
