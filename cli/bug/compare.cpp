// taut bug compare: all bugs on the same worlds, beside the shortest path.
#include <taut/cli/bug/compare.h>

#include <fmt/format.h>

#include <algorithm>

#include <taut/cli/bug/journey.h>
#include <taut/cli/messages.h>
#include <taut/cli/progress.h>
#include <taut/cli/report_files.h>
#include <taut/io/results/bug_json.h>

namespace taut::cli {

using bug::Algorithm;
using bug::Journey;

namespace {

struct CompareOptions {
  WorldOptions world;
  std::vector<std::string> files;
  QueryOptions query;
  CommonOptions common;
  ReportOptions report;
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

void add_options(CommandLine& app, CompareOptions& options) {
  app.add_option("FILE", options.files, "Worlds").required();
  add_reading_options(app, options.world);
  add_query_options(app, options.query);
  app.add_option_function(
         "--range", [&options](const std::string& list) { options.ranges = ranges_in(list); },
         "The ranges of tangent, separated by commas (default: 0,inf)")
      .type_name("LIST")
      .group("Query");
  add_turn_option(app, options.bug);
  add_csv_option(app, options.report);
  add_html_option(app, options.report);
  explain_bugs(app);
  app.example("taut bug compare data/maze_25x25.txt --range 0,2,inf --csv bugs.csv");
}

std::size_t followed(const Journey& journey) {
  std::size_t count = 0;
  for (const bug::Obstacle& o : journey.obstacles) count += o.hits;
  return count;
}

/// All bugs in all worlds.
class Comparison {
 public:
  Comparison(const CompareOptions& options, Run& run) : options_(options), run_(run) {}

  void add(const std::string& file) {
    WorldOptions one = options_.world;
    one.file = file;
    const BugWorld world = read_bug_world(one, options_.query, run_);
    add(world, {Algorithm::bug1, options_.bug.turn, 0});
    add(world, {Algorithm::bug2, options_.bug.turn, 0});
    for (const double range : options_.ranges) add(world, {Algorithm::tangent, options_.bug.turn, range});
    add_shortest(world);
    if (exit_code(outcome_of(world)) > exit_code(outcome_)) {
      outcome_ = outcome_of(world);
      reason_ = title_of(world.name) + ": " + reason_of(world);
    }
  }

  /// With the reports.
  Answer answer() const {
    Answer answer{.outcome = outcome_, .reason = reason_, .result = {{"journeys", rows_}}, .line = table_};
    add_reports(answer, options_.report, "bugs", "robot", lines_);
    return answer;
  }

 private:
  void add(const BugWorld& world, const bug::Options& how) {
    const double before = run_.seconds("search").cpu;
    const Journey journey = checked_journey(world, how, run_);
    const double cpu = run_.seconds("search").cpu - before;
    const auto ratio = ratio_of(journey, world.shortest);
    table_ += fmt::format("{:<24} {:<8} {:>6} {:>8} {:>14} {:>8} {:>14} {:>9} {:>9}\n", title_of(world.name),
                          name(how.algorithm), how.algorithm == Algorithm::tangent ? range_text(how.range) : "",
                          journey.reached ? "found" : "none", journey.path.length.decimals(6),
                          ratio ? fmt::format("{:.3f}", *ratio) : "", fmt::format("{:.6f}", journey.bound.hi),
                          followed(journey), seconds_text(cpu));
    Json row = bug_json(journey, how, world.start, world.goal, world.shortest);
    row["world"] = world.name;
    row["status"] = taut::name(outcome_of(world));
    row["cpu_seconds"] = cpu;
    lines_.push_back(line_of(world, journey, how, cpu));
    rows_.push_back(std::move(row));
    run_.so_far({{"journeys", rows_}}, table_);
  }

  void add_shortest(const BugWorld& world) {
    table_ += fmt::format("{:<24} {:<8} {:>6} {:>8} {:>14}\n", title_of(world.name), "shortest", "",
                          world.shortest ? "found" : "none", world.shortest ? world.shortest->decimals(6) : "");
    Json line{{"world", world.name}, {"robot", "shortest"}, {"found", world.shortest.has_value()}};
    if (world.shortest) line["length"] = world.shortest->value();
    lines_.push_back(std::move(line));
    run_.so_far({{"journeys", rows_}}, table_);
  }

  static Json line_of(const BugWorld& world, const Journey& journey, const bug::Options& how, double cpu) {
    const bool has_range = how.algorithm == Algorithm::tangent;
    return {{"world", world.name},
            {"robot", name(how.algorithm)},
            {"range", has_range ? Json(range_text(how.range)) : Json()},
            {"found", journey.reached},
            {"length", journey.path.length.value()},
            {"ratio", ratio_of(journey, world.shortest)},
            {"bound", journey.bound.hi},
            {"followed", followed(journey)},
            {"cpu_seconds", cpu}};
  }

  const CompareOptions& options_;
  Run& run_;
  std::string table_ = fmt::format("{:<24} {:<8} {:>6} {:>8} {:>14} {:>8} {:>14} {:>9} {:>9}\n", "world", "robot",
                                   "range", "goal", "length", "ratio", "bound", "followed", "cpu");
  Json rows_ = Json::array(), lines_ = Json::array();
  Outcome outcome_ = Outcome::found;
  std::string reason_;
};

int run(const CompareOptions& options, Run& run) {
  promise_reports(options.report, run);
  run.sources(options.files);
  Comparison comparison(options, run);
  const TellProgress show = shown_progress(options.common);
  ProgressCount done("worlds", options.files.size(), show);
  for (const std::string& file : options.files) {
    comparison.add(file);
    done.add();
  }
  return run.end(comparison.answer());
}

}  // namespace

Command bug_compare_command(CommandLine& bug) {
  return command<CompareOptions>(bug, "compare", "All bugs on the same worlds, beside the shortest path", add_options,
                                 run);
}

}  // namespace taut::cli
