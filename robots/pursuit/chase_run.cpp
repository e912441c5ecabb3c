#include <taut/robots/pursuit/chase_run.h>

#include <fmt/format.h>

#include <chrono>

#include <taut/robots/pursuit/entry_planner.h>
#include <taut/robots/pursuit/exact_planner.h>
#include <taut/robots/pursuit/heading_pursuer.h>
#include <taut/robots/pursuit/online_pursuer.h>

namespace taut::pursuit {

namespace {

constexpr int kSecondsAhead = 20;

double wall_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

std::span<const NamedPursuer> chase_pursuers() {
  static const std::vector<NamedPursuer> kPursuers = [] {
    std::vector<NamedPursuer> all;
    for (const NamedPlanner& planner : chase_planners()) all.push_back({planner.name, planner.description, &planner});
    all.push_back({"ahead", "heads for where the target will be, planned anew each second, as if time did not count",
                   nullptr, kSecondsAhead});
    all.push_back({"fixed", "likewise for the end of the target's way: why two dimensions are not enough", nullptr,
                   HeadingPursuer::kToTheEnd});
    return all;
  }();
  return kPursuers;
}

const NamedPursuer* chase_pursuer(std::string_view name) {
  for (const NamedPursuer& pursuer : chase_pursuers())
    if (pursuer.name == name) return &pursuer;
  return nullptr;
}

std::string_view ChaseRequest::planner_name() const {
  if (horizon) return "online";
  if (ahead) return *ahead == HeadingPursuer::kToTheEnd ? "fixed" : "ahead";
  return planner->name;
}

PlanLimits ChaseRequest::limits() const {
  PlanLimits limits;
  limits.seconds = plan_seconds;
  limits.jobs = jobs;
  return limits;
}

bool ChaseRun::is_proven(const ChaseMap& map) const {
  return is_caught() && plan.status == SearchStatus::found && result.cost == plan.bound && !map.rounded();
}

std::string ChaseRun::why_not() const {
  if (!fault.empty()) return "a wrong plan: " + fault;
  if (!result.reason.empty()) return result.reason;
  if (!plan.reason.empty() && plan.status != SearchStatus::found) return plan.reason;
  if (request.horizon) return "the target got away; one who knew all of its way could catch it";
  return fmt::format("planning took so long that the target got away ({:.3g} s for the first plan)",
                     result.first_thought);
}

std::optional<double> ChaseRun::ratio() const {
  if (!request.horizon || !is_caught() || plan.status != SearchStatus::found || plan.cost <= 0) return std::nullopt;
  return static_cast<double>(result.cost) / static_cast<double>(plan.cost);
}

namespace {

std::string fault_in(const ChaseRun& run, const Chase& chase) {
  const std::string fault = verify_plan(run.plan, chase);
  return fault.empty() && run.result.end == ChaseEnd::illegal ? run.result.reason : fault;
}

ChaseRun run_heading(const ChaseMap& map, const ChaseRequest& request) {
  ChaseRun run;
  run.request = request;
  const Chase chase = chase_of(map, request.clock);
  HeadingPursuer pursuer(chase, *request.ahead);
  run.result = play(map, {request.clock, request.free_planning, {}},
                    [&](CellIndex at, int now) { return pursuer.next(at, now); });
  run.plans = pursuer.plans();
  run.plan.status = chase.meetings.empty() ? SearchStatus::none : SearchStatus::stopped;
  run.plan.reason = chase.meetings.empty()
                        ? reason_of_failure(chase)
                        : "the target got away; heading for where it will be is no plan to be there in time";
  if (run.result.end == ChaseEnd::illegal) run.fault = run.result.reason;
  return run;
}

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
  PlanLimits limits;
  limits.jobs = request.jobs;
  run.plan = exact_plan(chase, limits);
  run.fault = fault_in(run, chase);
  return run;
}

}  // namespace

ChaseRun run_chase(const ChaseMap& map, const ChaseRequest& request,
                   const std::function<void(const ChasePlan&)>& better) {
  if (request.horizon) return run_online(map, request);
  if (request.ahead) return run_heading(map, request);
  ChaseRun run;
  run.request = request;
  const auto plan = [&](const Chase& chase, PlanLimits limits, PlanEffort*) {
    if (run.plans == 0) limits.better = better;
    PlanEffort* const effort = run.plans++ == 0 ? &run.effort : nullptr;
    return request.planner == chase_planner("weighted") ? entry_plan(chase, request.weight, limits, effort)
                                                        : request.planner->plan(chase, limits, effort);
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
    run.plan.status = SearchStatus::none;
    run.plan.reason = reason_of_failure(chase);
  }
  run.fault = fault_in(run, chase);
  return run;
}

std::string_view name(Clock clock) { return clock == Clock::zero ? "zero" : "one"; }

}  // namespace taut::pursuit
