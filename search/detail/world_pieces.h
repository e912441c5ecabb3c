// What stands in a world, piece by piece. Private.
#pragma once

#include <vector>

#include <taut/geometry/world.h>

namespace taut::detail {

template <class Visit>
void each_side(const std::vector<Area>& areas, Visit visit) {
  const auto ring = [&](const Ring& r) {
    for (std::size_t i = 0; i < r.size(); ++i) visit(r[i], r[(i + 1) % r.size()]);
  };
  for (const Area& area : areas) {
    ring(area.polygon.outer);
    for (const Ring& hole : area.polygon.holes) ring(hole);
  }
}

/// Walls, and the sides of areas and solids, as the world has them.
template <class Visit>
void each_piece(const World& world, Visit visit) {
  for (const Wall& wall : world.walls()) visit(wall.a, wall.b);
  each_side(world.areas(), visit);
  each_side(world.solids(), visit);
}

}  // namespace taut::detail
