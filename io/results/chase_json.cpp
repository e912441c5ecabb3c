#include <taut/io/results/chase_json.h>

namespace taut::pursuit {

namespace {

Json step_json(const ChaseMap& map, CellIndex cell, int second) {
  const Cell c = map.cell(cell);
  return {second, c.x, c.y};
}

Json cost_json(const ChaseMap& map, const ChasePlan& plan, Cost cost) {
  return plan.status == SearchStatus::found ? Json(map.cost_value(cost)) : Json(nullptr);
}

Json planning_json(const ChaseRun& run) {
  return {{"first_seconds", run.result.first_thought},
          {"slowest_seconds", run.result.longest_thought},
          {"seconds_ahead", run.seconds_ahead},
          {"plans", run.plans},
          {"searches", run.effort.searches},
          {"expanded", run.effort.expanded},
          {"labels", run.effort.labels}};
}

}  // namespace

Json chase_json(const ChaseMap& map, const ChaseRun& run) {
  const ChaseResult& r = run.result;
  Json path = Json::array();
  for (const ChaseStep& step : r.track) path.push_back(step_json(map, step.cell, step.second));
  Json json{{"planner", run.request.planner_name()},
            {"clock", name(run.request.clock)},
            {"free_planning", run.request.free_planning},
            {"caught", run.is_caught()},
            {"time", r.time},
            {"moves", r.moves},
            {"cost", map.cost_value(r.cost)},
            {"proven", run.is_proven(map) || run.is_hopeless()},
            {"lower_bound", cost_json(map, run.plan, run.plan.bound)},
            {"costs_rounded", map.rounded()},
            {"planning", planning_json(run)},
            {"path", std::move(path)}};
  if (run.request.horizon)
    json["online"] = {{"horizon", *run.request.horizon},
                      {"clairvoyant_cost", cost_json(map, run.plan, run.plan.cost)},
                      {"ratio", run.ratio()}};
  return json;
}

Json chase_plan_json(const ChaseMap& map, const ChaseRequest& request, const ChasePlan& plan) {
  Json path = Json::array();
  if (plan.status == SearchStatus::found)
    for (std::size_t i = 0; i < plan.cells.size(); ++i)
      path.push_back(step_json(map, plan.cells[i], static_cast<int>(i)));
  return {{"planner", request.planner_name()},
          {"clock", name(request.clock)},
          {"free_planning", request.free_planning},
          {"caught", false},
          {"plan_cost", cost_json(map, plan, plan.cost)},
          {"lower_bound", cost_json(map, plan, plan.bound)},
          {"path", std::move(path)}};
}

}  // namespace taut::pursuit
