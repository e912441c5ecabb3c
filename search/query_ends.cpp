#include <taut/search/query_ends.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <taut/geometry/written.h>

namespace taut {

namespace {

bool in_world(const World& world, Point p) {
  return std::any_of(world.areas().begin(), world.areas().end(), [p](const Area& area) {
    const auto& holes = area.polygon.holes;
    return written::side_of_ring(p, area.polygon.outer) >= 0 &&
           std::none_of(holes.begin(), holes.end(),
                        [p](const Ring& hole) { return written::side_of_ring(p, hole) > 0; });
  });
}

/// The distance to the wall's centre line beyond half its thickness; good enough to name a culprit.
double depth(const Wall& wall, Point p) {
  const double dx = wall.b.x - wall.a.x, dy = wall.b.y - wall.a.y, length = dx * dx + dy * dy;
  const double t = length > 0 ? std::clamp(((p.x - wall.a.x) * dx + (p.y - wall.a.y) * dy) / length, 0.0, 1.0) : 0;
  return std::hypot(p.x - wall.a.x - t * dx, p.y - wall.a.y - t * dy) - wall.thickness / 2;
}

std::string culprit(const World& world, Point p) {
  for (const Area& solid : world.solids())
    if (written::side_of_ring(p, solid.polygon.outer) >= 0)
      return fmt::format("the obstacle at ({}, {}){}", solid.polygon.outer[0].x, solid.polygon.outer[0].y,
                         solid.line > 0 ? fmt::format(", line {}", solid.line) : "");
  const auto nearest = std::min_element(world.walls().begin(), world.walls().end(),
                                        [p](const Wall& a, const Wall& b) { return depth(a, p) < depth(b, p); });
  if (nearest == world.walls().end()) return "an obstacle";
  return fmt::format("the wall ({}, {}) to ({}, {}){}", nearest->a.x, nearest->a.y, nearest->b.x, nearest->b.y,
                     nearest->line > 0 ? fmt::format(", line {}", nearest->line) : "");
}

}  // namespace

void require_free(const FreeSpace& space, Point p, std::string_view role) {
  const World& world = space.world();
  if (!(std::abs(p.x) <= World::kLargest && std::abs(p.y) <= World::kLargest))
    throw InputError(world.source(), 0, fmt::format("{} ({}, {}) is not a point", role, p.x, p.y));
  const auto is_small = [](double v) { return v != 0 && std::abs(v) < World::kSmallest; };
  if (is_small(p.x) || is_small(p.y))
    throw InputError(world.source(), 0,
                     fmt::format("{} ({}, {}) has a coordinate nearer to 0 than {}", role, p.x, p.y, World::kSmallest));
  if (space.locate(p).kind != Location::Kind::outside) return;
  if (!in_world(world, p))
    throw InputError(world.source(), 0, fmt::format("{} ({}, {}) lies outside the world", role, p.x, p.y));
  const char* robot =
      space.footprint().kind() == Footprint::Kind::point ? "lies inside" : "is too near for the robot to";
  throw InputError(world.source(), 0, fmt::format("{} ({}, {}) {} {}", role, p.x, p.y, robot, culprit(world, p)));
}

}  // namespace taut
