// A planner in two steps: it chooses where to meet the target first, then how to get there.
#pragma once

#include <taut/robots/pursuit/pursuit.h>

namespace taut::pursuit {

/// A way to the meeting that looks cheapest from the start.
///
///  1. Dijkstra's algorithm from the robot gives the cost and the moves of a way of least cost to every cell, of
///     several the one of fewest moves.
///  2. Of the meetings that such a way reaches in time the goal is the one of least cost and waiting there; of equal
///     ones the earliest.
///  3. Dijkstra's algorithm from the goal gives the heuristic.
///  4. A* over (cell, second) with nine moves, waiting included, by cost + weight * heuristic, to the goal's cell at
///     its second or before, where the robot then waits. States that were seen are kept in a hash table, never a layer
///     a second; beyond PlanLimits::most_labels of them the way of step 1 is taken instead.
///
/// The plan keeps what ChasePlan says; it ends where it meets the target first. Never optimal by proof: it waits at the
/// goal instead of the cheapest cell on the way, and the best meeting can be another one. `none` is proven; `stopped`
/// also when no way of least cost is in time although others are. With weight 1 the cost is at most that of step 2,
/// with a greater one at most `weight` times its moves and the waiting. Deterministic unless stopped by time. O(cells
/// log cost) and the states; 16 bytes a cell.
/// Preconditions: chase.from is free; 1 <= weight <= 1000.
ChasePlan entry_plan(const Chase& chase, std::uint32_t weight = 1, const PlanLimits& limits = {},
                     PlanEffort* effort = nullptr);

}  // namespace taut::pursuit
