// Worlds off every lattice: walls of all angles, solids that are not convex, robots with a size.
#pragma once

#include <cstdint>
#include <random>

#include <taut/geometry/footprint.h>
#include <taut/geometry/world.h>

#include "support/small_world.h"

namespace taut::test {

/// Messy worlds: walls of all angles and thicknesses, discs and squares as robots, on and off lattices.
struct MessyWorld {
  WorldParts parts;
  Footprint footprint;
};

inline MessyWorld messy_world(std::uint64_t seed) {
  std::mt19937_64 engine(seed);
  const auto below = [&](std::uint64_t n) { return engine() % n; };
  const auto unit = [&] { return static_cast<double>(engine() >> 11) * 0x1p-53; };
  const bool lattice = below(2) == 0;
  const auto point = [&] {
    const double x = lattice ? static_cast<double>(below(11)) : unit() * 10,
                 y = lattice ? static_cast<double>(below(11)) : unit() * 10;
    return Point{x, y};
  };
  MessyWorld world;
  world.parts.areas.push_back({Polygon{box_ring(0, 0, 10, 10), {}}, 0});
  for (std::uint64_t n = below(10); n > 0; --n) {
    const Point a = point(), b = below(8) == 0 ? a : point();
    const double thickness = lattice ? 0.25 : unit() / 2;
    world.parts.walls.push_back({a, b, below(4) == 0 ? 0 : thickness, 0});
  }
  for (std::uint64_t n = below(3); n > 0; --n) {
    const Point a = point();
    const double s = 0.5 + unit();
    world.parts.solids.push_back({Polygon{{a, {a.x + s, a.y}, {a.x + s / 2, a.y + s / 2}, {a.x, a.y + s}}, {}}, 0});
  }
  if (below(3) == 0) world.parts.boundary = Boundary::walled;
  const std::uint64_t robot = below(3);
  if (robot == 1) world.footprint = Footprint::disc(0.25);
  if (robot == 2) world.footprint = Footprint::square(0.1 + unit() / 4);
  return world;
}

}  // namespace taut::test
