// Worlds of a few walls and blocks, written in one line.
#pragma once
#include <vector>

#include <taut/geometry/free_space.h>

namespace taut::test {

inline Ring box_ring(double x0, double y0, double x1, double y1) { return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}; }

struct SmallWorld {
  std::vector<Segment> walls{};
  std::vector<Ring> solids{};
  Ring area = box_ring(0, 0, 10, 10);
  double thickness = 0;

  WorldParts parts() const {
    WorldParts result;
    result.areas.push_back({Polygon{area, {}}, 0});
    for (const Segment& s : walls) result.walls.push_back({s.a, s.b, thickness, 0});
    for (const Ring& ring : solids) result.solids.push_back({Polygon{ring, {}}, 0});
    return result;
  }
  /// Of parts().
  World bounded(Boundary boundary) const {
    WorldParts result = parts();
    result.boundary = boundary;
    return World(result);
  }
  FreeSpace space() const { return FreeSpace(World(parts())); }
};

}  // namespace taut::test
