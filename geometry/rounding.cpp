#include <taut/geometry/rounding.h>

#include <algorithm>
#include <cmath>

#include <taut/geometry/segment_distance.h>
#include <taut/geometry/written.h>

namespace taut {

namespace {

constexpr double kRoundings = 34;  // the union, the corners of grown obstacles, and 32 rounds of splitting

bool is_far(Point p, const Constraint& c, double reach) {
  const auto [left, right] = std::minmax(c.a.x, c.b.x);
  const auto [low, high] = std::minmax(c.a.y, c.b.y);
  return p.x < left - reach || p.x > right + reach || p.y < low - reach || p.y > high + reach;
}

/// Does the piece lie on the side from a to b?
bool is_on(const Constraint& c, Point a, Point b) {
  const auto [left, right] = std::minmax(a.x, b.x);
  return left <= c.a.x && c.a.x <= right && written::on_segment(c.a, a, b) && written::on_segment(c.b, a, b);
}

bool is_on(const Constraint& c, const Ring& ring) {
  for (std::size_t i = 0; i < ring.size(); ++i)
    if (is_on(c, ring[i], ring[(i + 1) % ring.size()])) return true;
  return false;
}

bool is_on(const Constraint& c, const std::vector<Area>& areas) {
  return std::ranges::any_of(areas, [&](const Area& area) {
    return is_on(c, area.polygon.outer) ||
           std::ranges::any_of(area.polygon.holes, [&](const Ring& hole) { return is_on(c, hole); });
  });
}

/// Is the piece where it is written? Obstacles that grew by a robot are not written.
bool is_as_written(const FreeSpace& space, const Constraint& c) {
  if (space.footprint().kind() != Footprint::Kind::point) return false;
  const World& world = space.world();
  const auto is_its_wall = [&](const Wall& wall) { return wall.thickness == 0 && is_on(c, wall.a, wall.b); };
  return std::ranges::any_of(world.walls(), is_its_wall) || is_on(c, world.areas()) || is_on(c, world.solids());
}

}  // namespace

double rounding_bound(const FreeSpace& space) { return kRoundings * space.displacement(); }

double path_bound(const FreeSpace& space) {
  const Footprint& robot = space.footprint();
  return rounding_bound(space) + (robot.kind() == Footprint::Kind::disc ? Footprint::kDiscExcess * robot.radius() : 0);
}

bool is_sure(const FreeSpace& space, Point p) {
  const double near = 2 * rounding_bound(space), reach = near + 1e-15 * (std::abs(p.x) + std::abs(p.y));
  if (near == 0) return true;
  return std::ranges::all_of(space.constraints(), [&](const Constraint& c) {
    return is_far(p, c, reach) || written::on_segment(p, c.a, c.b) ||
           segment_distance_interval({p, p}, {c.a, c.b}).lo > near || is_as_written(space, c);
  });
}

}  // namespace taut
