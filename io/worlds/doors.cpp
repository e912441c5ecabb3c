#include <taut/io/worlds/detail/doors.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <taut/geometry/written.h>

namespace taut::detail {

namespace {

// Where a point of the wall's line lies along it, by its longer axis.
class Axis {
 public:
  explicit Axis(const Wall& wall) : along_x_(std::abs(wall.b.x - wall.a.x) >= std::abs(wall.b.y - wall.a.y)) {}
  double of(Point p) const { return along_x_ ? p.x : p.y; }

 private:
  bool along_x_;
};

bool is_computed(const Segment& s) {
  return std::ranges::any_of(std::array{s.a.x, s.a.y, s.b.x, s.b.y}, [](double v) { return !written::decimal(v); });
}

// Exactly, or no farther beside it than `tolerance`.
bool lies_on_line_of(const Wall& wall, Point p, double tolerance) {
  if (written::orientation(wall.a, wall.b, p) == 0) return true;
  const double dx = wall.b.x - wall.a.x, dy = wall.b.y - wall.a.y;
  return std::abs(dx * (p.y - wall.a.y) - dy * (p.x - wall.a.x)) <= tolerance * std::hypot(dx, dy);
}

bool lies_on_line_of(const Wall& wall, const Segment& door, double tolerance) {
  return wall.a != wall.b && lies_on_line_of(wall, door.a, tolerance) && lies_on_line_of(wall, door.b, tolerance);
}

// `from` moved by half the wall's thickness towards `to`, for the cap; nothing where that leaves no wall.
bool drawn_back(Point& from, Point to, double thickness) {
  const double length = std::hypot(to.x - from.x, to.y - from.y), back = thickness / 2;
  if (thickness == 0) return length > 0;
  if (length <= back) return false;
  from = {from.x + (to.x - from.x) / length * back, from.y + (to.y - from.y) / length * back};
  return true;
}

}  // namespace

bool open_door(std::vector<Wall>& walls, const Segment& door, const Beside& beside) {
  bool opened = false;
  std::vector<Wall> left;
  for (const Wall& wall : walls) {
    const Axis axis(wall);
    Point a = wall.a, b = wall.b, from = door.a, to = door.b;
    if (axis.of(a) > axis.of(b)) std::swap(a, b);
    if (axis.of(from) > axis.of(to)) std::swap(from, to);
    const double tolerance = is_computed({wall.a, wall.b}) || is_computed(door)
                                 ? std::max(beside.rounding, beside.tolerance)
                                 : beside.tolerance;
    const double low = axis.of(a) + tolerance, high = axis.of(b) - tolerance;
    if (!lies_on_line_of(wall, door, tolerance) || axis.of(to) <= low || axis.of(from) >= high) {
      left.push_back(wall);
      continue;
    }
    opened = true;
    if (axis.of(from) > low && drawn_back(from, a, wall.thickness))
      left.push_back({a, from, wall.thickness, wall.line});
    if (axis.of(to) < high && drawn_back(to, b, wall.thickness)) left.push_back({to, b, wall.thickness, wall.line});
  }
  walls = std::move(left);
  return opened;
}

}  // namespace taut::detail
