#include <taut/search/query_ends.h>

#include <fmt/format.h>

#include <cmath>

#include <taut/geometry/nearest_free.h>

namespace taut {

namespace {

/// `0.03 inside the wall from (1, 2) to (4, 2)`
std::string place_of(const World& world, Point p, const std::optional<FreePlace>& nearest) {
  const NearObstacle near = nearest_obstacle(world, p);
  const std::string depth = nearest ? fmt::format("{:.6g} ", nearest->distance) : "";
  if (!is_in_world(world, p)) return fmt::format("lies {}outside the world", depth);
  if (near.distance < 0) return fmt::format("lies {}inside {}", depth, text(near));
  return fmt::format("is {}too near for the robot to {}", depth, text(near));
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
  if (space.holds(p)) return;
  throw InputError(world.source(), 0, blocked_text(world, p, role, nearest_free(space, p)));
}

void require_free(const DiscPlaces& places, Point p, std::string_view role) {
  const World& world = places.space().world();
  if (!places.is_free(p)) throw InputError(world.source(), 0, blocked_text(world, p, role, places.nearest(p)));
}

std::string blocked_text(const World& world, Point p, std::string_view role, const std::optional<FreePlace>& nearest) {
  return fmt::format("{} ({}, {}) {}; {}", role, p.x, p.y, place_of(world, p, nearest),
                     nearest ? fmt::format("nearest free point ({}, {})", nearest->point.x, nearest->point.y)
                             : "the robot fits nowhere");
}

}  // namespace taut
