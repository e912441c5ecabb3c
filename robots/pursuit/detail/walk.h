// Ways without waiting, and the plans they become.
#pragma once

#include <vector>

#include <taut/robots/pursuit/pursuit.h>

namespace taut::pursuit::detail {

inline constexpr Cost kNoCost = std::numeric_limits<Cost>::max() / 4;

/// The plan that follows `way` (neighbours, from chase.from to a meeting's cell) and is at its end `seconds` after
/// chase.now, where a meeting is. All waiting is done at the way's cheapest cell, the first of several; the plan ends
/// where it meets the target first. Precondition: way.size() <= seconds + 1.
ChasePlan plan_along(const Chase& chase, const std::vector<CellIndex>& way, int seconds);

/// A cost per second on the way, moves alone, and the cost of its cheapest cell.
struct WayCost {
  Cost moves = 0;           ///< of all cells but the last
  std::uint32_t least = 0;  ///< of all cells

  /// With waiting, `seconds` in all.
  Cost total(std::size_t steps, int seconds) const { return moves + (seconds - static_cast<Cost>(steps)) * least; }
};
WayCost cost_of(const ChaseMap& map, const std::vector<CellIndex>& way);

}  // namespace taut::pursuit::detail
