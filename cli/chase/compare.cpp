// taut chase compare: all planners on the same maps.
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include <taut/cli/chase/options.h>
#include <taut/cli/command.h>
#include <taut/cli/messages.h>
#include <taut/cli/progress.h>
#include <taut/cli/report_files.h>
#include <taut/cli/run.h>

namespace taut::cli {

using namespace pursuit;

namespace {

struct ChaseCompareOptions {
  std::vector<std::string> files;
  ChaseRuleOptions rules;
  CommonOptions common;
  std::string csv;
  ReportOptions report;  // its page alone: --csv has columns of its own
};

void add_compare_options(CommandLine& app, ChaseCompareOptions& options) {
  app.add_option("MAP", options.files, "Cost maps").required();
  add_chase_rule_options(app, options.rules, options.common.limits);
  app.add_option("--csv", options.csv,
                 "Write the rows as a table: map, planner, caught (1 or 0), time, moves, cost, ...")
      .type_name("FILE")
      .group("Output");
  add_html_option(app, options.report);
  explain_chase_planners(app);
  app.example("taut chase compare data/town_60x40.chase --free-planning --csv chases.csv");
}

/// All planners on all maps: the rows, and what they say of each map.
class Comparison {
 public:
  Comparison(const ChaseRuleOptions& rules, std::size_t maps, Run& run)
      : rules_(rules), run_(run), done_("chases", maps * chase_pursuers().size(), show_) {}

  void add(const std::string& file) {
    const ChaseMap map = run_.stage("read", [&] { return read_chase_file(file); });
    Outcome best = Outcome::unproven;
    for (const NamedPursuer& pursuer : chase_pursuers()) {
      const Outcome one = add(map, pursuer);
      // Caught by anybody, or proven by anybody to be out of reach, is an answer.
      if (one == Outcome::found || best == Outcome::unproven) best = one;
    }
    if (exit_code(best) > exit_code(outcome_)) {
      outcome_ = best;
      reason_ = title_of(map.source()) + ": " + why_not_;
    }
  }

  const std::string& csv() const { return csv_; }

  Answer answer() const {
    return {.outcome = outcome_, .reason = reason_, .result = {{"chases", rows_}}, .line = table_};
  }

 private:
  Outcome add(const ChaseMap& map, const NamedPursuer& pursuer) {
    const double before = run_.seconds("chase").cpu;
    ChaseRequest request = rules_.request(pursuer);
    request.jobs = run_.options().limits.jobs;
    const ChaseRun chase = run_.stage("chase", [&] { return run_chase(map, request); });
    const double cpu = run_.seconds("chase").cpu - before;
    Json json = checked_json(map, chase);
    const Outcome outcome = chase.is_caught()     ? Outcome::found
                            : chase.is_hopeless() ? Outcome::none
                                                  : Outcome::unproven;
    json["file"] = map.source();
    json["status"] = taut::name(outcome);
    json["cpu_seconds"] = cpu;
    rows_.push_back(std::move(json));
    table_ += line_of(map, chase, cpu);
    csv_ += csv_of(map, chase, cpu);
    if (!chase.is_caught()) {
      why_not_ = chase.why_not();
      note(fmt::format("taut: {}: {}: {}", title_of(map.source()), pursuer.name, why_not_));
    }
    run_.so_far({{"chases", rows_}}, table_);
    done_.add();
    return outcome;
  }

  static std::string line_of(const ChaseMap& map, const ChaseRun& chase, double cpu) {
    const ChaseResult& r = chase.result;
    return fmt::format("{:<20} {:<9} {:>6} {:>6} {:>6} {:>12} {:>7} {:>12} {:>12} {:>10}\n", title_of(map.source()),
                       chase.request.planner_name(), chase.is_caught() ? "yes" : "no", r.time, r.moves,
                       map.cost_text(r.cost), chase.is_proven(map) || chase.is_hopeless() ? "yes" : "no",
                       seconds_text(r.first_thought), seconds_text(r.longest_thought), seconds_text(cpu));
  }

  static std::string csv_of(const ChaseMap& map, const ChaseRun& chase, double cpu) {
    const ChaseResult& r = chase.result;
    return fmt::format("{},{},{},{},{},{},{},{:.6f}\n", csv_field(title_of(map.source())), chase.request.planner_name(),
                       chase.is_caught() ? 1 : 0, r.time, r.moves, map.cost_text(r.cost),
                       chase.is_proven(map) || chase.is_hopeless() ? 1 : 0, cpu);
  }

  const ChaseRuleOptions& rules_;
  Run& run_;
  TellProgress show_ = shown_progress(run_.options());
  ProgressCount done_;
  std::string csv_ = "map,planner,caught,time,moves,cost,proven,cpu_seconds\n";
  std::string table_ =
      fmt::format("{:<20} {:<9} {:>6} {:>6} {:>6} {:>12} {:>7} {:>12} {:>12} {:>10}\n", "map", "planner", "caught",
                  "time", "moves", "cost", "proven", "first plan", "slowest", "cpu");
  Json rows_ = Json::array();
  Outcome outcome_ = Outcome::found;
  std::string reason_, why_not_;
};

int run_compare(const ChaseCompareOptions& options, Run& run) {
  run.promise(options.csv);
  promise_reports(options.report, run);
  run.sources(options.files);
  Comparison comparison(options.rules, options.files.size(), run);
  for (const std::string& file : options.files) comparison.add(file);
  Answer answer = comparison.answer();
  if (!options.csv.empty()) answer.files.push_back({options.csv, comparison.csv()});
  add_reports(answer, options.report, "chases", "planner");
  return run.end(std::move(answer));
}

}  // namespace

Command chase_compare_command(CommandLine& chase) {
  return command<ChaseCompareOptions>(chase, "compare", "Let all planners chase on the same maps", add_compare_options,
                                      run_compare);
}

}  // namespace taut::cli
