// Value iteration on cells x 8 headings.
#pragma once

#include <optional>
#include <vector>

#include <taut/robots/roadblocks/value_grid.h>

namespace taut::roadblocks {

/// How a sweep goes over the states.
enum class Sweeping : std::uint8_t {
  at_once,  ///< all states by the values of the sweep before (Jacobi)
  /// by the newest values, rows and columns against their heading, so that a straight way ahead is valued in one sweep
  /// (Gauss-Seidel)
  in_place
};

/// The least cost from each state to a goal state; kNever where there is none.
struct Values {
  std::vector<double> of;  ///< by state
  int sweeps = 0;          ///< the last one, which changed nothing, included
};

/// Sweeps V(s) = min over actions of cost + V(after) until nothing changes.
///
///  1. The result is *the* fixed point in doubles, bit by bit, whatever the sweeping: rounded addition never decreases
///     when an addend grows, so V(s) is the least, over all ways, of their costs added up from the goal backwards.
///     Dijkstra from the goal gives the same bits.
///  2. A sweep over a plane of states is a handful of operations on arrays (Eigen). At most one sweep more than the
///     longest best way has actions.
Values value_iteration(const ValueGrid& grid, Sweeping sweeping = Sweeping::in_place);

/// The best action, the first of equals in the order of kActions; nothing in goal states and where the value is kNever.
std::optional<Action> best_action(const ValueGrid& grid, const Values& values, std::size_t state);

}  // namespace taut::roadblocks
