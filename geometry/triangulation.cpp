#include <taut/geometry/triangulation.h>

#include <taut/geometry/written.h>

namespace taut {

bool Triangulation::looks_to(const Sector& sector, Point q) const {
  if (sector.full) return true;
  const Point v = points[sector.vertex];
  const bool after_right = written::orientation(v, points[sector.right], q) >= 0,
             before_left = written::orientation(v, points[sector.left], q) <= 0;
  return sector.reflex ? after_right || before_left : after_right && before_left;
}

}  // namespace taut
