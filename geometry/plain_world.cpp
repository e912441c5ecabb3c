#include <taut/geometry/plain_world.h>

#include <algorithm>
#include <utility>

namespace taut {

bool is_plain(const World& world, const Footprint& robot) {
  return robot.kind() == Footprint::Kind::point && world.areas().size() == 1 &&
         std::none_of(world.walls().begin(), world.walls().end(), [](const Wall& wall) { return wall.thickness > 0; });
}

World plain_world(const FreeSpace& space) {
  const World& world = space.world();
  if (is_plain(world, space.footprint())) return world;
  WorldParts parts;
  parts.source = world.source();
  parts.boundary = Boundary::walled;
  for (const Polygon& polygon : space.polygons()) parts.areas.push_back({polygon, 0});
  if (space.footprint().kind() == Footprint::Kind::point)
    for (const Wall& wall : world.walls())
      if (wall.thickness == 0) parts.walls.push_back(wall);
  parts.start = world.start();
  parts.goal = world.goal();
  parts.y_down = world.y_down();
  parts.uncertainty = world.uncertainty();
  return World(std::move(parts));
}

}  // namespace taut
