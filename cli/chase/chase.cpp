// taut chase: catching a moving target on a cost map.
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include <taut/cli/chase/options.h>
#include <taut/cli/chase/svg.h>
#include <taut/cli/command.h>
#include <taut/cli/command_line.h>
#include <taut/cli/exit_code.h>
#include <taut/cli/messages.h>
#include <taut/cli/output.h>
#include <taut/cli/report.h>
#include <taut/cli/timing.h>

namespace taut::cli {

using namespace pursuit;

namespace {

std::string planner_list() {
  std::string names;
  for (const NamedPlanner& p : chase_planners()) names += (names.empty() ? "" : ", ") + std::string(p.name);
  return names;
}

const NamedPlanner* planner_of(const std::string& name) {
  const NamedPlanner* found = chase_planner(name);
  if (!found) throw UsageError("--planner: '" + name + "' is not one of " + planner_list());
  return found;
}

struct ChaseOptions {
  std::string file;
  const NamedPlanner* planner = chase_planner("exact");
  bool names_planner = false;
  ChaseRuleOptions rules;
  bool online = false;
  std::optional<int> horizon;
  OutputOptions output;
  std::string animation;
  bool path = false;
  CommonOptions common;
};

void add_options(CommandLine& app, ChaseOptions& options) {
  app.add_option("MAP", options.file, "The cost map to read, sections N C R T M; - is standard input");
  app.add_option_function(
         "--planner",
         [&options](const std::string& text) {
           options.planner = planner_of(text);
           options.names_planner = true;
         },
         "Who plans: exact (default), report, weighted, first")
      .type_name("NAME")
      .group("Rules");
  app.add_flag("--online", options.online,
               "Do not know the target's way: see it second by second, and the horizon ahead")
      .group("Rules");
  app.add_option("--horizon", options.horizon, "Seconds of the target's way that are seen ahead (default: 0)")
      .type_name("S")
      .range(0, 1'000'000)
      .group("Rules");
  add_chase_rule_options(app, options.rules);
  add_output_options(app, options.output);
  add_animate_option(app, options.animation, "Write a moving picture (SVG)");
  app.add_flag("--path", options.path, "Print where the robot is at each second: `SECOND X,Y`").group("Output");
  app.optional_subcommand();
  app.callback([&app, &options] {
    if (app.has_subcommand()) return;
    if (options.file.empty()) throw UsageError("MAP is required");
    if (options.horizon && !options.online) throw UsageError("--horizon needs --online");
    if (options.online && options.names_planner) throw UsageError("--online plans by itself, without --planner");
    settle_animation(app, options.animation, options.output.svg, options.output.json);
  });
}

ChaseRequest request_of(const ChaseOptions& options) {
  ChaseRequest request = options.rules.request(options.planner);
  if (options.online) request.horizon = options.horizon.value_or(0);
  return request;
}

void say_what_it_took(const ChaseRun& run, double read) {
  note(fmt::format("read {}, first move after {}, slowest {}, {}, {} expanded, {} labels{}, peak memory {}",
                   seconds_text(read), seconds_text(run.result.first_thought), seconds_text(run.result.longest_thought),
                   count_text(static_cast<std::size_t>(run.plans), "plan"), run.effort.expanded, run.effort.labels,
                   run.seconds_ahead > 0 ? ", planned " + seconds_text(run.seconds_ahead) + " while moving" : "",
                   peak_memory_text()));
}

/// Says how far the first planning came when the program is stopped, be it by what was thrown out of run().
class LastWords {
 public:
  LastWords(std::shared_ptr<const ChaseMap> map, const ChaseRequest& request, const std::string& json) {
    on_stop([map = std::move(map), best = best_, json, planner = std::string(request.planner_name()),
             clock = std::string(name(request.clock))](const Stop& why) {
      const std::lock_guard lock(best->mutex);
      const bool found = best->plan.status == PlanStatus::found;
      if (found)
        note(fmt::format("the best plan so far costs {}; the least cost is at least {}",
                         map->cost_text(best->plan.cost), map->cost_text(best->plan.bound)));
      using Json = nlohmann::ordered_json;
      const Json answer = {{"file", map->source()},
                           {"status", "stopped"},
                           {"reason", why.reason},
                           {"stage", why.stage},
                           {"planner", planner},
                           {"clock", clock},
                           {"plan_cost", found ? Json(map->cost_value(best->plan.cost)) : Json(nullptr)},
                           {"lower_bound", found ? Json(map->cost_value(best->plan.bound)) : Json(nullptr)}};
      write_file(json, answer.dump() + "\n");
    });
  }
  void hear(const Plan& plan) {
    const std::lock_guard lock(best_->mutex);
    best_->plan = plan;
  }

 private:
  struct Best {
    std::mutex mutex;
    Plan plan{};
  };
  std::shared_ptr<Best> best_ = std::make_shared<Best>();
};

int run(const ChaseOptions& options) {
  for (const std::string& file : {options.output.svg, options.output.json, options.animation}) require_writable(file);
  double read = 0, played = 0;
  const auto kept =
      timed("read", read, [&] { return std::make_shared<const ChaseMap>(read_chase_file(options.file)); });
  const ChaseMap& map = *kept;
  if (map.rounded()) note(fmt::format("taut: {}: costs have more digits than fit and were rounded", map.source()));
  const ChaseRequest request = request_of(options);
  LastWords last_words(kept, request, options.output.json);
  const ChaseRun run =
      timed("chase", played, [&] { return run_chase(map, request, [&](const Plan& plan) { last_words.hear(plan); }); });
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

}  // namespace

std::vector<Command> chase_commands(CommandLine& app) {
  Command chase =
      command<ChaseOptions>(app, "chase", "Catch a moving target on a cost map at least cost", add_options, run);
  return {chase_compare_command(*chase.line), chase_generate_command(*chase.line), chase};
}

}  // namespace taut::cli
