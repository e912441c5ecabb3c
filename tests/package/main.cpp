// A wall across a room leaves one way, around its free end: 3 legs of an exact length.
#include <cstdio>
#include <optional>

#include <taut/geometry/free_space.h>
#include <taut/geometry/world.h>
#include <taut/search/shortest_path.h>

bool everything_is_at_hand();

int main() {
  taut::WorldParts parts;
  parts.areas.push_back({taut::Polygon{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {}}});
  parts.walls.push_back({{2, 0}, {2, 3}});
  const taut::FreeSpace space{taut::World{parts}};
  const std::optional<taut::Path> path = taut::shortest_path(space, taut::Point{1, 2}, taut::Point{3, 2});
  if (!path || path->points.size() != 3) return 1;
  if (!everything_is_at_hand()) return 1;
  std::printf("%s\n", path->length.decimals(6).c_str());
  return path->length.decimals(6) == "2.828427" ? 0 : 1;
}
