// Small messy worlds for RapidCheck: walls on a lattice that cross, touch, overlap and repeat; blocks that touch and
// overlap.
#pragma once

#include <string>

#include <fmt/format.h>
#include <rapidcheck.h>

#include "support/small_world.h"

namespace taut::test {

/// Uniform over the whole range from the start; RapidCheck alone begins with small values.
inline int any(int first, int last) { return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(first, last + 1)); }

struct RandomWorld {
  int side = 6;           ///< the area is [0, side] x [0, side]
  int walls = 8;          ///< at most
  int solids = 3;         ///< at most
  double thickness = 0;   ///< of the walls
  bool straight = false;  ///< walls are axis-parallel
};

inline Point any_lattice_point(int side) {
  const int x = any(0, side), y = any(0, side);
  return {double(x), double(y)};
}

/// On a lattice 64 times as fine, not on the rim of [0, side] x [0, side].
inline Point any_fine_point(int side) {
  const int x = any(1, 64 * side - 1), y = any(1, 64 * side - 1);
  return {x / 64.0, y / 64.0};
}

inline Segment any_wall(const RandomWorld& kind) {
  const Point a = any_lattice_point(kind.side);
  Point b = any_lattice_point(kind.side);
  if (kind.straight) (any(0, 1) ? b.x : b.y) = any(0, 1) ? a.x : a.y;
  if (kind.straight && a.x != b.x && a.y != b.y) b.y = a.y;
  return {a, b};
}

inline Ring any_solid(int side) {
  const Point a = any_lattice_point(side), b = any_lattice_point(side), c = any_lattice_point(side);
  const double doubled = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  if (any(0, 1) && doubled != 0) return doubled > 0 ? Ring{a, b, c} : Ring{a, c, b};
  const int x = any(0, side - 1), y = any(0, side - 1);
  const int width = any(1, 2), height = any(1, 2);
  return box_ring(x, y, x + width, y + height);
}

inline SmallWorld any_world(const RandomWorld& kind = {}) {
  SmallWorld world;
  world.area = box_ring(0, 0, kind.side, kind.side);
  world.thickness = kind.thickness;
  for (int n = any(0, kind.walls); n > 0; --n) world.walls.push_back(any_wall(kind));
  for (int n = any(0, kind.solids); n > 0; --n) world.solids.push_back(any_solid(kind.side));
  return world;
}

inline std::string show(Point p) { return fmt::format("{{{}, {}}}", p.x, p.y); }

/// As it can be pasted into a test.
inline std::string show(const SmallWorld& world) {
  std::string walls, solids;
  for (const Segment& s : world.walls) walls += fmt::format("{{{}, {}}}, ", show(s.a), show(s.b));
  for (const Ring& ring : world.solids) {
    std::string corners;
    for (const Point p : ring) corners.append(show(p)).append(", ");
    solids += fmt::format("{{{}}}, ", corners);
  }
  return fmt::format("SmallWorld{{.walls = {{{}}}, .solids = {{{}}}, .area = box_ring(0, 0, {}, {}), .thickness = {}}}",
                     walls, solids, world.area[2].x, world.area[2].y, world.thickness);
}

}  // namespace taut::test
