// Where a path may turn among cells. Private.
#pragma once

#include <bit>
#include <cstdint>
#include <optional>

#include <taut/geometry/cell_plan.h>
#include <taut/roadmaps/navmesh.h>

namespace taut::detail {

/// The reflex sector that quadrant i around a corner is a part of, its corners not yet known. There is at most one.
inline std::optional<Navmesh::Bend> cell_bend(const CellPlan& plan, std::uint32_t x, std::uint32_t y, int i) {
  const CellPlan::Around around = plan.around_corner(x, y);
  if (around.closed == 0 || std::popcount(around.sector(i)) < 3) return std::nullopt;
  int right = i, left = i + 1;
  while (!((around.closed >> (right % 4)) & 1)) right += 3;
  while (!((around.closed >> (left % 4)) & 1)) ++left;
  const auto next_corner = [&](int ray) {
    return Point{plan.x(ray == 0 ? x + 1 : ray == 2 ? x - 1 : x), plan.y(ray == 1 ? y + 1 : ray == 3 ? y - 1 : y)};
  };
  return Navmesh::Bend{next_corner(right % 4), next_corner(left % 4), kNone, kNone, kNone};
}

}  // namespace taut::detail
