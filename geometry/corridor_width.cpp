#include <taut/geometry/corridor_width.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <taut/geometry/predicates.h>

namespace taut {

namespace {

double ring_length(const Ring& ring) {
  double sum = 0;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
    sum += std::hypot(ring[i].x - ring[j].x, ring[i].y - ring[j].y);
  return sum;
}

}  // namespace

double corridor_width(const FreeSpace& space) {
  const Box& box = space.world().box();
  const double extent = std::max(box.max.x - box.min.x, box.max.y - box.min.y);
  // In parts of the extent, so that no square overflows.
  double area = 0, outline = 0;
  for (Polygon polygon : space.polygons()) {
    polygon.holes.push_back(std::move(polygon.outer));
    for (Ring& ring : polygon.holes) {
      for (Point& p : ring) p = {p.x / extent, p.y / extent};
      area += ring_area(ring);  // twice the area, negative for holes
      outline += ring_length(ring);
    }
  }
  for (const Constraint& c : space.constraints())
    if (c.is_wall()) outline += 2 * std::hypot((c.b.x - c.a.x) / extent, (c.b.y - c.a.y) / extent);
  return extent * (outline > 0 && area > 0 ? std::clamp(area / outline, 1e-4, 0.125) : 0.125);
}

}  // namespace taut
