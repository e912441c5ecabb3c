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

}  // namespace

double rounding_bound(const FreeSpace& space) { return kRoundings * space.report().displacement; }

bool is_sure(const FreeSpace& space, Point p) {
  const double near = 2 * rounding_bound(space), reach = near + 1e-15 * (std::abs(p.x) + std::abs(p.y));
  if (near == 0) return true;
  return std::ranges::all_of(space.constraints(), [&](const Constraint& c) {
    return is_far(p, c, reach) || written::on_segment(p, c.a, c.b) ||
           segment_distance_interval({p, p}, {c.a, c.b}).lo > near;
  });
}

}  // namespace taut
