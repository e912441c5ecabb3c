// taut chase: catching a moving target on a cost map.
#include <fmt/format.h>
#include <CLI/Error.hpp>
#include <CLI/Option.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include <taut/cli/chase_run.h>
#include <taut/cli/chase_svg.h>
#include <taut/cli/command.h>
#include <taut/cli/exit_code.h>
#include <taut/cli/messages.h>
#include <taut/cli/output.h>
#include <taut/cli/report.h>
#include <taut/cli/timing.h>
#include <taut/geometry/errors.h>
#include <taut/io/read_world.h>
#include <taut/robots/pursuit/chase_generator.h>
#include <taut/robots/pursuit/read_chase_map.h>

namespace taut::cli {

using namespace pursuit;

namespace {

constexpr double kPlanSeconds = 0.9;  // the rules grant one; the rest is for what goes on around

std::string planner_list() {
  std::string names;
  for (const NamedPlanner& p : chase_planners()) names += (names.empty() ? "" : ", ") + std::string(p.name);
  return names;
}

const NamedPlanner* planner_of(const std::string& name) {
  const NamedPlanner* found = chase_planner(name);
  if (!found) throw CLI::ValidationError("--planner: '" + name + "' is not one of " + planner_list());
  return found;
}

Clock clock_of(const std::string& text) {
  if (text != "zero" && text != "one") throw CLI::ValidationError("--clock: '" + text + "' is not zero or one");
  return text == "one" ? Clock::one : Clock::zero;
}

/// The rules, the same for one chase and for many.
struct RuleOptions {
  Clock clock = Clock::zero;
  bool free_planning = false;
  std::optional<double> plan_seconds;

  ChaseRequest request(const NamedPlanner* planner) const {
    return {planner, clock, free_planning, plan_seconds.value_or(free_planning ? 0 : kPlanSeconds), std::nullopt};
  }
};

void add_rule_options(CLI::App& app, RuleOptions& rules) {
  app.add_option_function<std::string>(
         "--clock", [&rules](const std::string& text) { rules.clock = clock_of(text); },
         "The second of the target's first entry: zero (default) or one, the other scoring program's")
      ->type_name("CLOCK")
      ->group("Rules");
  app.add_flag("--free-planning", rules.free_planning, "Planning takes no time, however long it takes")->group("Rules");
  app.add_option_function<std::string>(
         "--plan-seconds",
         [&rules](const std::string& text) {
           rules.plan_seconds = number_of(text);
           if (*rules.plan_seconds < 0) throw CLI::ValidationError("--plan-seconds: '" + text + "' is below 0");
         },
         "Let exact, report and weighted plan for that long; exact then takes its best so far. 0: to the end (default: "
         "0.9, with --free-planning 0)")
      ->type_name("S")
      ->group("Rules");
}

ChaseMap read_map(const std::string& file) { return read_chase_map(read_bytes(file), file == "-" ? "<stdin>" : file); }

// ---- taut chase MAP

struct ChaseOptions {
  std::string file;
  const NamedPlanner* planner = chase_planner("exact");
  bool names_planner = false;
  RuleOptions rules;
  bool online = false;
  std::optional<int> horizon;
  OutputOptions output;
  std::string animation;
  bool path = false;
  CommonOptions common;
};

void require_one_stdout(const ChaseOptions& options) {
  if ((options.output.svg == "-") + (options.output.json == "-") + (options.animation == "-") > 1)
    throw CLI::ValidationError("only one of --svg, --animate and --json can have standard output");
}

void add_options(CLI::App& app, ChaseOptions& options) {
  app.add_option("MAP", options.file, "The cost map to read, sections N C R T M; - is standard input");
  app.add_option_function<std::string>(
         "--planner",
         [&options](const std::string& text) {
           options.planner = planner_of(text);
           options.names_planner = true;
         },
         "Who plans: exact (default), report, weighted, first")
      ->type_name("NAME")
      ->group("Rules");
  app.add_flag("--online", options.online,
               "Do not know the target's way: see it second by second, and the horizon ahead")
      ->group("Rules");
  app.add_option("--horizon", options.horizon, "Seconds of the target's way that are seen ahead (default: 0)")
      ->type_name("S")
      ->check(CLI::Range(0, 1'000'000))
      ->group("Rules");
  add_rule_options(app, options.rules);
  add_output_options(app, options.output);
  app.add_option("--animate", options.animation, "Write a moving picture (SVG); - is standard output")
      ->type_name("FILE")
      ->group("Output");
  app.add_flag("--path", options.path, "Print where the robot is at each second: `SECOND X,Y`")->group("Output");
  app.require_subcommand(0, 1);
  app.callback([&app, &options] {
    if (!app.get_subcommands().empty()) return;
    if (options.file.empty()) throw CLI::RequiredError("MAP");
    if (options.horizon && !options.online) throw CLI::ValidationError("--horizon needs --online");
    if (options.online && options.names_planner)
      throw CLI::ValidationError("--online plans by itself, without --planner");
    require_one_stdout(options);
  });
}

ChaseRequest request_of(const ChaseOptions& options) {
  ChaseRequest request = options.rules.request(options.planner);
  if (options.online) request.horizon = options.horizon.value_or(0);
  return request;
}

void say_what_it_took(const ChaseRun& run, double read) {
  note(fmt::format("read {}, first move after {}, slowest {}, {}, {} expanded, {} labels, peak memory {}",
                   seconds_text(read), seconds_text(run.result.first_thought), seconds_text(run.result.longest_thought),
                   count_text(static_cast<std::size_t>(run.plans), "plan"), run.effort.expanded, run.effort.labels,
                   peak_memory_text()));
}

int run(const ChaseOptions& options) {
  for (const std::string& file : {options.output.svg, options.output.json, options.animation}) require_writable(file);
  double read = 0, played = 0;
  const ChaseMap map = timed("read", read, [&] { return read_map(options.file); });
  if (map.rounded()) note(fmt::format("taut: {}: costs have more digits than fit and were rounded", map.source()));
  const ChaseRun run = timed("chase", played, [&] { return run_chase(map, request_of(options)); });
  begin_stage("write");
  const std::string drawing = options.output.svg.empty() ? "" : chase_svg(map, run, false);
  const std::string animation = options.animation.empty() ? "" : chase_svg(map, run, true);
  const std::string json = options.output.json.empty() ? "" : chase_json(map, run).dump() + "\n";
  finish();
  write_file(options.output.svg, drawing);
  write_file(options.animation, animation);
  write_file(options.output.json, json);
  if (!options.output.stdout_taken() && options.animation != "-") {
    if (!options.output.quiet) print(chase_text(map, run));
    if (options.path) print(track_text(map, run));
  }
  if (options.output.stats) say_what_it_took(run, read);
  if (run.exit_code() == kInternal) complain("internal error: " + run.why_not());
  return run.exit_code();
}

// ---- taut chase compare MAP...

struct CompareOptions {
  std::vector<std::string> files;
  RuleOptions rules;
  std::string json;
  CommonOptions common;
};

void add_compare_options(CLI::App& app, CompareOptions& options) {
  app.add_option("MAP", options.files, "Cost maps")->required();
  add_rule_options(app, options.rules);
  app.add_option("--json", options.json, "Write everything as JSON; - is standard output")
      ->type_name("FILE")
      ->group("Output");
}

std::string row(const ChaseMap& map, const ChaseRun& run) {
  const ChaseResult& r = run.result;
  return fmt::format("{:<20} {:<9} {:>6} {:>6} {:>6} {:>12} {:>7} {:>12} {:>12}\n", title_of(map.source()),
                     run.request.planner_name(), run.is_caught() ? "yes" : "no", r.time, r.moves, map.cost_text(r.cost),
                     run.is_proven(map) || run.is_hopeless() ? "yes" : "no", seconds_text(r.first_thought),
                     seconds_text(r.longest_thought));
}

int run_compare(const CompareOptions& options) {
  require_writable(options.json);
  std::string table = fmt::format("{:<20} {:<9} {:>6} {:>6} {:>6} {:>12} {:>7} {:>12} {:>12}\n", "map", "planner",
                                  "caught", "time", "moves", "cost", "proven", "first plan", "slowest");
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  int code = kFound;
  double ignored = 0;
  for (const std::string& file : options.files) {
    const ChaseMap map = timed("read", ignored, [&] { return read_map(file); });
    int best = kInternal;
    for (const NamedPlanner& planner : chase_planners()) {
      const ChaseRun run = timed("chase", ignored, [&] { return run_chase(map, options.rules.request(&planner)); });
      table += row(map, run);
      if (!options.json.empty()) all.push_back(chase_json(map, run));
      if (!run.is_caught())
        note(fmt::format("taut: {}: {}: {}", title_of(file), run.request.planner_name(), run.why_not()));
      best = std::min(best, run.exit_code());
    }
    code = std::max(code, best);
  }
  finish();
  write_file(options.json, options.json.empty() ? "" : all.dump() + "\n");
  if (options.json != "-") print(table);
  return code;
}

// ---- taut chase generate

struct GenerateOptions {
  ChaseRecipe recipe;
  std::string file = "-";
  CommonOptions common;
};

void set_size(ChaseRecipe& recipe, const std::string& text) {
  const std::size_t by = text.find('x');
  const double x = number_of(text.substr(0, by)), y = by == std::string::npos ? x : number_of(text.substr(by + 1));
  for (const double side : {x, y})
    if (side < 3 || side > ChaseMap::kLongestSide || side != static_cast<int>(side))
      throw CLI::ValidationError(fmt::format("--size: '{}' is not XxY or N, of 3 to {}", text, ChaseMap::kLongestSide));
  recipe.x_size = static_cast<int>(x);
  recipe.y_size = static_cast<int>(y);
}

void add_generate_options(CLI::App& app, GenerateOptions& options) {
  app.add_option_function<std::string>(
         "--size", [&options](const std::string& text) { set_size(options.recipe, text); },
         "Cells in x and y, or one number for both (default: 200)")
      ->type_name("XxY")
      ->group("Map");
  app.add_option("--duration", options.recipe.seconds, "Seconds of the target's trajectory (default: 400)")
      ->type_name("N")
      ->check(CLI::Range(1, 1'000'000))
      ->group("Map");
  app.add_flag("--costly", options.recipe.costly,
               "Hills of cost 1 to 100, in a building costs that rise towards walls; else every free cell costs 1")
      ->group("Map");
  const auto build = [&options] { options.recipe.ground = ChaseGround::building; };
  app.add_flag_callback("--building", build, "One building of corridors and rooms instead of a town")->group("Map");
  app.add_option("--inflation", options.recipe.inflation,
                 "In a costly building a cell costs 1 + 10 for each cell of wall so near in x and y (default: 12)")
      ->type_name("CELLS")
      ->check(CLI::Range(1, 100))
      ->group("Map");
  app.add_option_function<std::string>(
         "--buildings",
         [&options](const std::string& text) {
           options.recipe.buildings = number_of(text);
           if (options.recipe.buildings < 0 || options.recipe.buildings > 0.6)
             throw CLI::ValidationError("--buildings: '" + text + "' is not a share of 0 to 0.6");
         },
         "About this share of the map under buildings, 0 to 0.6 (default: 0.2)")
      ->type_name("SHARE")
      ->group("Map");
  app.add_option("-o,--output", options.file, "Write to this file instead of standard output")
      ->type_name("FILE")
      ->group("Map");
}

int run_generate(const GenerateOptions& options) {
  require_writable(options.file);
  begin_stage("generate");
  ChaseRecipe recipe = options.recipe;
  recipe.seed = options.common.seed;
  const std::string text = chase_map_text(generate_chase_map(recipe));
  finish();
  write_file(options.file, text);
  return kFound;
}

}  // namespace

std::vector<Command> chase_commands(CLI::App& app) {
  Command chase =
      command<ChaseOptions>(app, "chase", "Catch a moving target on a cost map at least cost", add_options, run);
  CLI::App& group = *chase.app;
  return {command<CompareOptions>(group, "compare", "Let all planners chase on the same maps", add_compare_options,
                                  run_compare),
          command<GenerateOptions>(group, "generate", "Make a town with a target walking in it, from a seed",
                                   add_generate_options, run_generate),
          std::move(chase)};
}

}  // namespace taut::cli
