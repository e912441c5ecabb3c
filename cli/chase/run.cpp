#include <taut/cli/chase/run.h>

#include <fmt/format.h>
#include <sys/resource.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <utility>

#include <taut/cli/exit_code.h>
#include <taut/cli/report.h>
#include <taut/robots/pursuit/exact_planner.h>
#include <taut/robots/pursuit/online_pursuer.h>

namespace taut::cli {

using namespace pursuit;

namespace {

double wall_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

std::string cell_text(Cell c) { return fmt::format("({}, {})", c.x, c.y); }

std::size_t peak_memory_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::size_t>(usage.ru_maxrss) * 1024;
}

std::string headline(const ChaseMap& map, const ChaseRun& run) {
  if (!run.is_caught()) return (run.is_hopeless() ? "the target cannot be caught: " : "not caught: ") + run.why_not();
  const std::string where = "caught at " + cell_text(map.cell(run.result.track.back().cell));
  if (run.request.horizon && run.plan.status == PlanStatus::found)
    return where + fmt::format("; seeing {} ahead it costs {:.3f} times {} who knows all",
                               count_text(static_cast<std::size_t>(*run.request.horizon), "second"),
                               run.ratio().value_or(1), run.plan.optimal ? "the optimum of one" : "what somebody pays");
  if (run.is_proven(map)) return where + "; nobody does for less (proven)";
  return where + "; not proven optimal" +
         (run.plan.bound > 0 ? ", the least cost is at least " + map.cost_text(run.plan.bound) : "");
}

}  // namespace

PlanLimits ChaseRequest::limits() const {
  PlanLimits limits;
  limits.seconds = plan_seconds;
  return limits;
}

bool ChaseRun::is_proven(const ChaseMap& map) const {
  return is_caught() && plan.status == PlanStatus::found && result.cost == plan.bound && !map.rounded();
}

int ChaseRun::exit_code() const {
  if (!fault.empty() || result.end == ChaseEnd::illegal) return kInternal;
  return is_caught() ? kFound : is_hopeless() ? kNone : kStopped;
}

std::string ChaseRun::why_not() const {
  if (!fault.empty()) return "a wrong plan: " + fault;
  if (!result.reason.empty()) return result.reason;
  if (!plan.reason.empty() && plan.status != PlanStatus::found) return plan.reason;
  if (request.horizon) return "the target got away; one who knew all of its way could catch it";
  return fmt::format("planning took so long that the target got away ({} for the first plan)",
                     seconds_text(result.first_thought));
}

std::optional<double> ChaseRun::ratio() const {
  if (!request.horizon || !is_caught() || plan.status != PlanStatus::found || plan.cost <= 0) return std::nullopt;
  return static_cast<double>(result.cost) / static_cast<double>(plan.cost);
}

namespace {

ChaseRun run_online(const ChaseMap& map, const ChaseRequest& request) {
  ChaseRun run;
  run.request = request;
  const ChaseMap ground = map.without_trajectory();
  const Unfolding unfolding(map, request.clock, *request.horizon);
  OnlinePursuer pursuer(ground, request.limits());
  run.result = play(map, {request.clock, request.free_planning, {}},
                    [&](CellIndex at, int now) { return pursuer.next(at, unfolding.at(now)); });
  run.plans = pursuer.plans();
  const Chase chase = chase_of(map, request.clock);
  run.plan = exact_plan(chase);
  run.fault = fault_of(run.plan, chase);
  return run;
}

}  // namespace

ChaseRun run_chase(const ChaseMap& map, const ChaseRequest& request, const std::function<void(const Plan&)>& better) {
  if (request.horizon) return run_online(map, request);
  ChaseRun run;
  run.request = request;
  const auto plan = [&](const Chase& chase, PlanLimits limits, PlanEffort*) {
    if (run.plans == 0) limits.better = better;
    return request.planner->plan(chase, limits, run.plans++ == 0 ? &run.effort : nullptr);
  };
  // Of all planners exact alone does better when it has more time.
  const bool thinks_ahead = !request.free_planning && request.planner->plan == chase_planner("exact")->plan;
  Follower follower(map, request.clock, plan, request.limits(), thinks_ahead ? wall_seconds : nullptr);
  run.result =
      play(map, {request.clock, request.free_planning, [&] { return wall_seconds() - follower.seconds_ahead(); }},
           [&](CellIndex at, int now) { return follower.next(at, now); });
  run.seconds_ahead = follower.seconds_ahead();
  run.plan = follower.first_plan();
  const Chase chase = chase_of(map, request.clock);
  if (run.plans == 0) {  // there was nothing to play for
    run.plan.status = PlanStatus::none;
    run.plan.reason = reason_of_failure(chase);
  }
  run.fault = fault_of(run.plan, chase);
  return run;
}

std::string_view name(Clock clock) { return clock == Clock::zero ? "zero" : "one"; }

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

nlohmann::ordered_json chase_json(const ChaseMap& map, const ChaseRun& run) {
  using Json = nlohmann::ordered_json;
  const ChaseResult& r = run.result;
  Json path = Json::array();
  for (const ChaseStep& step : r.track) path.push_back({step.second, map.cell(step.cell).x, map.cell(step.cell).y});
  Json json = {
      {"file", map.source()},
      {"status", run.is_caught()     ? "found"
                 : run.is_hopeless() ? "none"
                                     : "stopped"},
      {"planner", run.request.planner_name()},
      {"clock", name(run.request.clock)},
      {"free_planning", run.request.free_planning},
      {"caught", run.is_caught()},
      {"time", r.time},
      {"moves", r.moves},
      {"cost", map.cost_value(r.cost)},
      {"proven", run.is_proven(map) || run.is_hopeless()},
      {"lower_bound", run.plan.status == PlanStatus::found ? Json(map.cost_value(run.plan.bound)) : Json(nullptr)},
      {"reason", run.is_caught() ? Json(nullptr) : Json(run.why_not())},
      {"costs_rounded", map.rounded()},
      {"planning",
       {{"first_seconds", r.first_thought},
        {"slowest_seconds", r.longest_thought},
        {"seconds_ahead", run.seconds_ahead},
        {"plans", run.plans},
        {"searches", run.effort.searches},
        {"expanded", run.effort.expanded},
        {"labels", run.effort.labels}}},
      {"peak_memory_bytes", peak_memory_bytes()},
      {"path", std::move(path)}};
  if (run.request.horizon)
    json["online"] = {{"horizon", *run.request.horizon},
                      {"clairvoyant_cost",
                       run.plan.status == PlanStatus::found ? Json(map.cost_value(run.plan.cost)) : Json(nullptr)},
                      {"ratio", run.ratio() ? Json(*run.ratio()) : Json(nullptr)}};
  return json;
}

}  // namespace taut::cli
