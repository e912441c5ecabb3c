#include <taut/cli/mouse/report.h>

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

#include <taut/cli/messages.h>
#include <taut/cli/mouse/table.h>
#include <taut/io/worlds/certificate_file.h>

namespace taut::cli {

namespace {

using micromouse::Finding;
using micromouse::Record;
using micromouse::TrialStatus;

void require_one_standard_output(const MouseReport& report, const CommonOptions& common) {
  int taken = 0;
  for (const std::string* file : {&report.svg, &report.animation, &report.values, &common.json, &report.certificate})
    taken += *file == "-" ? 1 : 0;
  if (taken > 1) throw UsageError("only one output can have standard output");
}

void require(const Finding& finding, const char* what) {
  if (!finding) throw std::logic_error(fmt::format("the {} does not pass its own check: {}", what, finding.reason));
}

void check(const MouseTrial& trial, const GridMaze& maze) {
  require(verify_record(trial.record, maze), "trial");
  if (trial.certificate) require(verify_certificate(*trial.certificate, maze, trial.record), "certificate");
}

// Those that take many trials or a search. What is finished stays if the next is stopped.
void measure(MouseTrial& trial, const GridMazeInput& read, Run& run) {
  micromouse::Yardsticks& y = trial.yardsticks;
  if (micromouse::fit_for_proof_bound(read.maze)) {
    y.with_proof = run.stage("floor", [&] { return micromouse::proof_bound(read.maze); });
    run.so_far(mouse_trial_json(trial), mouse_table(trial, read.name));
  } else {
    note(fmt::format("taut: {}: too large for the floor with proof", read.name));
  }
  y.random_walkers = run.stage("walkers", [&] { return micromouse::benchmark_random_walkers(read.maze); });
  y.walked = true;
}

std::string robot_name(const MouseTrial& trial) { return trial.explorer.empty() ? "robot" : trial.explorer; }

std::vector<std::string> facts_of(const MouseTrial& trial) {
  const Record& record = trial.record;
  return {trial.explorer.empty() ? "a robot of its own" : trial.explorer + " explorer",
          record.score() ? fmt::format("score {:.3f}", *record.score()) : std::string(name(record.status)),
          fmt::format("run 1: {}", record.run1), fmt::format("run 2: {}", record.run2),
          fmt::format("optimum {}{}", trial.yardsticks.optimum, trial.certificate ? ", proven" : "")};
}

// Pictures whatever came of it, the proof where there is one.
std::vector<OutputFile> files_of(const MouseReport& report, const GridMazeInput& read, const MouseTrial& trial,
                                 const std::map<Cell, micromouse::CellMark>& marks) {
  const MousePicture picture{title_of(read.name), facts_of(trial), report.flood, marks};
  std::vector<OutputFile> files;
  if (!report.svg.empty()) files.push_back({report.svg, mouse_svg(read.maze, trial.record, picture)});
  if (!report.animation.empty()) files.push_back({report.animation, mouse_animation(read.maze, trial.record, picture)});
  if (!report.values.empty()) files.push_back({report.values, mouse_values_svg(read.maze, trial.record, picture)});
  if (trial.certificate && !report.certificate.empty())
    files.push_back({report.certificate, certificate_text(certified_run(*trial.certificate, trial.record))});
  return files;
}

// Empty when all that was asked for is there.
std::string what_is_missing(const MouseReport& report, const MouseTrial& trial, const std::string& missing) {
  if (!missing.empty()) return missing;
  if (trial.record.status != TrialStatus::finished)
    return fmt::format("{}: {}", robot_name(trial), name(trial.record.status));
  if (report.certificate.empty() || trial.certificate) return "";
  return "run 1 does not prove a route; no certificate written (--explorer prove explores until it does)";
}

}  // namespace

void MouseReport::promise(Run& run) const {
  for (const std::string& file : {svg, animation, values, certificate}) run.promise(file);
}

int MouseReport::end(Run& run, const GridMazeInput& read, MouseTrial trial, std::string missing, std::string listing,
                     const std::map<Cell, micromouse::CellMark>& marks) const {
  trial.certificate = micromouse::certificate(trial.record);
  trial.insurance = run.stage("insurance", [&] { return micromouse::insurance_of(trial.record, trial.seed); });
  run.stage("check", [&] { check(trial, read.maze); });
  run.so_far(mouse_trial_json(trial), listing.empty() ? mouse_table(trial, read.name) : "");
  if (!quick) measure(trial, read, run);
  missing = what_is_missing(*this, trial, missing);
  if (!missing.empty()) complain(read.name + ": " + missing);
  return run.end({.outcome = missing.empty() ? Outcome::found : Outcome::unproven,
                  .reason = missing,
                  .result = mouse_trial_json(trial),
                  .line = listing.empty() ? mouse_table(trial, read.name) : "",
                  .listing = std::move(listing),
                  .files = files_of(*this, read, trial, marks)});
}

void add_report_options(CommandLine& app, MouseReport& report, const CommonOptions& common) {
  app.add_option("--svg", report.svg, "Write a picture of both runs; - is standard output")
      .type_name("FILE")
      .group("Output");
  add_animate_option(app, report.animation, "Write a film of both runs that plays in a browser (SVG, no script)");
  app.add_flag("--flood", report.flood,
               "Write into the pictures how many steps each cell is from the goal; in the film, "
               "step by step as the map grows")
      .group("Output");
  app.add_option("--values", report.values,
                 "Write a sheet of these numbers before, during and after exploring, unknown walls taken for open")
      .type_name("FILE")
      .group("Output");
  app.add_option("--certificate", report.certificate,
                 "Write the proof that run 2 is optimal, for `taut mouse check`; exit code 4 when run 1 has none")
      .type_name("FILE")
      .group("Output");
  app.add_flag("--quick", report.quick, "Leave out the floor with proof and benchmark 2").group("Output");
  app.callback([&app, &report, &common] {
    settle_animation(app, report.animation, report.svg, common.json);
    require_one_standard_output(report, common);
  });
}

}  // namespace taut::cli
