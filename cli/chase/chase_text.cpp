#include <taut/cli/chase/chase_text.h>

#include <fmt/format.h>

#include <algorithm>

#include <taut/cli/messages.h>

namespace taut::cli {

using namespace pursuit;

namespace {

std::string cell_text(Cell c) { return fmt::format("({}, {})", c.x, c.y); }

std::string headline(const ChaseMap& map, const ChaseRun& run) {
  if (!run.is_caught()) return (run.is_hopeless() ? "the target cannot be caught: " : "not caught: ") + run.why_not();
  const std::string where = "caught at " + cell_text(map.cell(run.result.track.back().cell));
  if (run.request.horizon && run.plan.status == SearchStatus::found)
    return where + fmt::format("; seeing {} ahead it costs {:.3f} times {} who knows all",
                               count_text(static_cast<std::size_t>(*run.request.horizon), "second"),
                               run.ratio().value_or(1), run.plan.optimal ? "the optimum of one" : "what somebody pays");
  if (run.is_proven(map)) return where + "; nobody does for less (proven)";
  return where + "; not proven optimal" +
         (run.plan.bound > 0 ? ", the least cost is at least " + map.cost_text(run.plan.bound) : "");
}

}  // namespace

std::string chase_text(const ChaseMap& map, const ChaseRun& run) {
  std::string text = fmt::format("{}: {}\n", title_of(map.source()), headline(map, run));
  if (run.is_hopeless()) return text;
  const ChaseResult& r = run.result;
  const std::string cost = map.cost_text(r.cost);
  const std::size_t wide = std::max<std::size_t>(cost.size(), 6);
  return text + fmt::format("caught    time   moves  {:>{}}\n{:>6}  {:>6}  {:>6}  {:>{}}\n", "cost", wide,
                            run.is_caught() ? "yes" : "no", r.time, r.moves, cost, wide);
}

std::string track_text(const ChaseMap& map, const ChaseRun& run) {
  std::string text;
  for (const ChaseStep& step : run.result.track) {
    const Cell c = map.cell(step.cell);
    text += fmt::format("{} {},{}\n", step.second, c.x, c.y);
  }
  return text;
}

PathToWrite track_path(const ChaseMap& map, const ChaseRun& run) {
  PathToWrite path{.name = std::string(run.request.planner_name()), .points = {}};
  std::vector<double> seconds;
  for (const ChaseStep& step : run.result.track) {
    const Cell c = map.cell(step.cell);
    path.points.push_back({static_cast<double>(c.x), static_cast<double>(c.y)});
    seconds.push_back(static_cast<double>(step.second));
  }
  path.columns = {{"second", std::move(seconds)}};
  return path;
}

std::string plan_text(const ChaseMap& map, const ChasePlan& plan) {
  return plan.status == SearchStatus::found
             ? fmt::format("{}: stopped; the best plan so far costs {}, the least cost is at least {}\n",
                           title_of(map.source()), map.cost_text(plan.cost), map.cost_text(plan.bound))
             : "";
}

}  // namespace taut::cli
