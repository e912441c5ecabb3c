// Who sees whom among cells. Private.
#pragma once

#include <optional>

#include <taut/geometry/cell_plan.h>

namespace taut::detail {

/// What FreeSpace::sees() says, from the pieces along the leg alone.
bool sees_among_cells(const CellPlan& plan, Point p, Point q, std::optional<Point> towards);

}  // namespace taut::detail
