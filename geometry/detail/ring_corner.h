// What a ring looks like around one of its points.
#pragma once

#include <taut/geometry/point.h>
#include <taut/geometry/written.h>

namespace taut::detail {

/// The rays from p to x and from p to y are the same. x, y != p.
inline bool same_ray(Point p, Point x, Point y) {
  return written::orientation(p, x, y) == 0 && !written::on_segment(p, x, y);
}

/// A ring comes from `before` and leaves to `after`; no spike.
struct Corner {
  Point before;
  Point at;
  Point after;

  /// Is the direction at -> p strictly to the left of the ring? Precondition: it is on neither arm.
  bool left(Point p) const {
    const bool left_of_in = written::orientation(before, at, p) > 0;
    const bool left_of_out = written::orientation(at, after, p) > 0;
    return written::orientation(before, at, after) > 0 ? left_of_in && left_of_out : left_of_in || left_of_out;
  }

  bool on_arm(Point p) const { return same_ray(at, p, before) || same_ray(at, p, after); }
};

/// The corner at p of the ring's side from its vertex `index` on. Precondition: p lies on that side.
inline Corner corner_of(const Ring& r, std::size_t index, Point p) {
  const Point a = r[index], b = r[index + 1 == r.size() ? 0 : index + 1];
  if (p == a) return {r[index == 0 ? r.size() - 1 : index - 1], p, b};
  if (p == b) return {a, p, r[(index + 2) % r.size()]};
  return {a, p, b};
}

}  // namespace taut::detail
