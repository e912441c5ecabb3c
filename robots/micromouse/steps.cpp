#include <taut/robots/micromouse/steps.h>

#include <algorithm>
#include <cstdlib>

#include <taut/geometry/expects.h>
#include <taut/robots/micromouse/detail/boards.h>

namespace taut::micromouse {

using detail::index_of;

StepField::StepField(const Passages& passages, const std::vector<Cell>& from) : width_(passages.width) {
  const std::size_t cells = static_cast<std::size_t>(passages.width) * static_cast<std::size_t>(passages.height);
  steps_.assign(cells, kUnreached);
  CellBits first(passages.words());
  for (const Cell c : from) detail::put(first, index_of(width_, c));
  detail::StepSearch search(static_cast<std::size_t>(width_), passages.words());
  search.start(passages, first);
  do {
    detail::for_each_bit(search.frontier().data(), passages.words(),
                         [&](std::size_t i) { steps_[i] = search.level(); });
  } while (search.advance());
}

std::optional<int> optimum(const Passages& passages, const Task& task) {
  CellBits goal(passages.words());
  for (const Cell c : task.goal) detail::put(goal, index_of(task.width, c));
  detail::StepSearch search(static_cast<std::size_t>(task.width), passages.words());
  search.start(passages, index_of(task.width, task.start));
  do {
    for (std::size_t k = 0; k < goal.size(); ++k)
      if ((goal[k] & search.frontier()[k]) != 0) return std::max(search.level(), 1);
  } while (search.advance());
  return std::nullopt;
}

std::vector<Cell> shortest_route(const Passages& passages, const Task& task) {
  const StepField to_goal(passages, task.goal);
  if (!to_goal.reached(task.start)) return {};
  std::vector<Cell> route{task.start};
  if (task.in_goal(task.start)) route.push_back(task.start);
  while (!task.in_goal(route.back())) {
    const int left = to_goal(route.back());
    const auto next = one_step_from(passages, route.back());
    route.push_back(*std::find_if(next.begin(), next.end(), [&](Cell c) { return to_goal(c) == left - 1; }));
  }
  return route;
}

std::vector<Cell> one_step_from(const Passages& passages, Cell cell) {
  std::vector<Cell> cells;
  std::array<Cell, 4> at{cell, cell, cell, cell};
  std::array<bool, 4> going{true, true, true, true};
  for (int count = 1; count <= kLongestMove; ++count)
    for (const Side side : kSides) {
      const auto k = static_cast<std::size_t>(side);
      going[k] = going[k] && passages.open(at[k], side);
      if (!going[k]) continue;
      at[k] = ahead(at[k], side);
      cells.push_back(at[k]);
    }
  return cells;
}

Side side_towards(Cell from, Cell to) {
  if (to.x != from.x) return to.x > from.x ? Side::east : Side::west;
  return to.y >= from.y ? Side::north : Side::south;
}

Action action_towards(const MousePose& pose, Cell to) {
  TAUT_EXPECTS((pose.cell.x == to.x) != (pose.cell.y == to.y));
  const Side side = side_towards(pose.cell, to);
  const int count = std::abs(to.x - pose.cell.x) + std::abs(to.y - pose.cell.y);
  if (side == opposite(pose.heading)) return {0, -count};
  if (side == pose.heading) return {0, count};
  return {side == turned(pose.heading, 1) ? 90 : -90, count};
}

}  // namespace taut::micromouse
