#include <taut/geometry/footprint.h>

#include <cmath>
#include <numbers>
#include <string>

#include <taut/geometry/errors.h>
#include <taut/geometry/text.h>
#include <taut/geometry/world.h>
#include <taut/geometry/written.h>

namespace taut {

namespace {

double checked_radius(double r) {
  if (!(r >= World::kSmallest && r <= World::kLargest))
    throw InputError({}, 0, "a robot's radius must be from 1e-75 to 1e75, not " + text(r));
  return r;
}

bool is_convex_around_origin(const Ring& ring) {
  if (ring.size() < 3 || written::side_of_ring({0, 0}, ring) <= 0) return false;
  for (std::size_t i = 0; i < ring.size(); ++i)
    if (written::orientation(ring[i], ring[(i + 1) % ring.size()], ring[(i + 2) % ring.size()]) <= 0) return false;
  return true;
}

}  // namespace

Footprint Footprint::disc(double r) {
  Footprint f;
  f.kind_ = Kind::disc;
  f.radius_ = checked_radius(r);
  // One eighth is computed, the rest mirrored, so that the polygon has the disc's symmetry to the bit. The sides at 0,
  // 90, 180 and 270 degrees touch the disc; a factor keeps the rounded corners outside.
  constexpr double kStep = std::numbers::pi / kDiscSides;
  const double outer = r / std::cos(kStep) * (1 + 1e-15);
  for (int i = 0; i < kDiscSides; ++i) {
    const int eighth = kDiscSides / 8, octant = i / eighth, within = i % eighth;
    const double angle = (2 * (octant % 2 ? eighth - 1 - within : within) + 1) * kStep;
    double x = outer * std::cos(angle), y = outer * std::sin(angle);
    if (octant == 1 || octant == 2 || octant == 5 || octant == 6) std::swap(x, y);
    if (octant >= 2 && octant <= 5) x = -x;
    if (octant >= 4) y = -y;
    f.ring_.push_back({x, y});
  }
  return f;
}

Footprint Footprint::square(double r) {
  checked_radius(r);
  Footprint f;
  f.kind_ = Kind::polygon;
  f.radius_ = r;
  f.ring_ = {{-r, -r}, {r, -r}, {r, r}, {-r, r}};
  return f;
}

Footprint Footprint::polygon(Ring ring) {
  for (const Point p : ring)
    if (!(std::abs(p.x) <= World::kLargest && std::abs(p.y) <= World::kLargest))
      throw InputError({}, 0, "a footprint's coordinates must be finite");
  if (!is_convex_around_origin(ring))
    throw InputError(
        {}, 0, "a footprint must be a strictly convex, counter-clockwise polygon around its reference point (0, 0)");
  Footprint f;
  f.kind_ = Kind::polygon;
  f.ring_ = std::move(ring);
  return f;
}

}  // namespace taut
