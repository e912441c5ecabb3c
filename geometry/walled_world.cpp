#include <taut/geometry/walled_world.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <taut/geometry/written.h>

namespace taut {

namespace {

/// A dead end behind the opening, on the side that is not the world's. It widens, so that the door itself is what is
/// narrow.
Ring porch(const Segment& door, const Box& box) {
  const double depth = std::max(std::abs(door.b.x - door.a.x), std::abs(door.b.y - door.a.y));
  const bool vertical = door.a.x == door.b.x;
  const double side = vertical ? door.a.x : door.a.y, low = vertical ? box.min.x : box.min.y;
  const double far = side == low ? side - depth : side + depth;
  const auto [p, q] = std::minmax(door.a, door.b);
  return vertical ? Ring{p, q, {far, q.y + depth}, {far, p.y - depth}}
                  : Ring{p, q, {q.x + depth, far}, {p.x - depth, far}};
}

bool is_on_a_side(const Segment& door, const Box& b) {
  const auto both = [&](double u, double v, double low, double high) { return u == v && (u == low || u == high); };
  return both(door.a.x, door.b.x, b.min.x, b.max.x) || both(door.a.y, door.b.y, b.min.y, b.max.y);
}

}  // namespace

World walled_world(const World& world, const std::vector<Point>& ends) {
  if (world.boundary() == Boundary::walled) return world;
  WorldParts parts;
  parts.source = world.source();
  parts.areas = world.areas();
  parts.boundary = Boundary::walled;
  parts.walls = world.walls();
  parts.solids = world.solids();
  parts.start = world.start();
  parts.goal = world.goal();
  for (const Segment& door : world.openings()) {
    const auto stands_on_it = [&](Point p) { return written::on_segment(p, door.a, door.b); };
    if (is_on_a_side(door, world.box()) && std::any_of(ends.begin(), ends.end(), stands_on_it))
      parts.areas.push_back({Polygon{porch(door, world.box()), {}}, 0});
  }
  return World(std::move(parts));
}

}  // namespace taut
