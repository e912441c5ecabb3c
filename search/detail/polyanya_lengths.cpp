// Lengths compared, and what a path is no shorter than.
#include <taut/search/detail/polyanya_engine.h>

#include <algorithm>
#include <cmath>

#include <taut/geometry/box.h>

namespace taut::detail {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Between two boxes, at least.
double gap(const Box& a, const Box& b) {
  const double dx = std::max({0.0, a.min.x - b.max.x, b.min.x - a.max.x}),
               dy = std::max({0.0, a.min.y - b.max.y, b.min.y - a.max.y});
  return std::sqrt(dx * dx + dy * dy);
}

double cross(Point o, Point a, Point b) { return (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x); }

/// A ray's end on a side, rounded, and how far from the true one it may lie.
struct RayEnd {
  Point point;
  double error = 0;
};

RayEnd end_of_ray(Point origin, Point through, Point a, Point b, double magnitude) {
  const double at_a = cross(origin, through, a), at_b = cross(origin, through, b), all = at_a - at_b;
  if (all == 0) return {a, kInfinity};
  const double t = std::clamp(at_a / all, 0.0, 1.0);
  const double ray = std::abs(through.x - origin.x) + std::abs(through.y - origin.y),
               side = std::abs(b.x - a.x) + std::abs(b.y - a.y);
  // Each cross product is off by at most 8 roundings of ray * magnitude.
  return {{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)}, 0x1p-48 * side * ray * magnitude / std::abs(all)};
}

/// p on the other side of the line a b, when it is to the left of it.
Point mirrored_if_left(Point p, Point a, Point b) {
  const double dx = b.x - a.x, dy = b.y - a.y, turn = dx * (p.y - a.y) - dy * (p.x - a.x);
  if (turn <= 0) return p;
  const double scale = 2 * turn / (dx * dx + dy * dy);
  return {p.x + dy * scale, p.y - dx * scale};
}

}  // namespace

/// Is the way through `before` to `at`, not shorter than that to a known root of the same bend?
bool PolyanyaEngine::is_worse(std::uint32_t before, Point at, double length, double error, std::uint32_t than) {
  const Root& old = roots_[than];
  const double difference = length - old.length, doubt = error + old.error;
  if (difference > doubt) return true;
  if (difference < -doubt) return false;
  return !is_shorter_exactly(before, at, old.before, old.point);
}

bool PolyanyaEngine::is_shorter_exactly(std::uint32_t a, Point end_a, std::uint32_t b, Point end_b) {
  legs_a_.clear();
  legs_b_.clear();
  const auto climb = [this](std::uint32_t& root, Point& end, std::vector<Segment>& legs) {
    legs.push_back({roots_[root].point, end});
    end = roots_[root].point;
    root = roots_[root].before;
  };
  while (a != b) a > b ? climb(a, end_a, legs_a_) : climb(b, end_b, legs_b_);
  legs_a_.push_back({roots_[a].point, end_a});
  legs_b_.push_back({roots_[a].point, end_b});
  return compare_lengths(legs_a_, legs_b_) < 0;
}

void PolyanyaEngine::improve(std::uint32_t root, std::uint32_t goal, Point end) {
  const Root& from = roots_[root];
  const double leg = distance(from.point, end), length = from.length + leg;
  const double error = error_of(from, leg, length);
  Way& way = ways_[nearest_ ? 0 : goal];
  if (way.exists()) {
    const double difference = length - way.length, doubt = error + way.error;
    if (difference > doubt) return;
    if (difference >= -doubt && !is_shorter_exactly(root, end, way.root, way.end)) return;
  } else {
    --unreached_;
  }
  way = {root, goal, end, length, error};
  renew_bound();
}

void PolyanyaEngine::renew_bound() {
  if (unreached_ > 0) return;
  bound_ = 0;
  for (const Way& way : ways_)
    if (way.exists()) bound_ = std::max(bound_, way.length + way.error * 2);
}

/// A lower bound but for rounding.
double PolyanyaEngine::to_goal(Point p) const {
  if (!nearest_) return 0;
  if (goals_.size() == 1) return distance(p, goal_box_.min);
  return gap({p, p}, goal_box_);
}

double PolyanyaEngine::bound_through(const Cone& cone, Point a, Point b, bool right_is_a, bool left_is_b) const {
  const Root& root = roots_[cone.root];
  const Point r = cone.origin;
  const RayEnd right = right_is_a ? RayEnd{a, 0} : end_of_ray(r, cone.right_through, a, b, magnitude_);
  const RayEnd left = left_is_b ? RayEnd{b, 0} : end_of_ray(r, cone.left_through, a, b, magnitude_);
  double error = 2 * (right.error + left.error), rest;
  if (!(error < 0x1p-30 * magnitude_)) {
    error = 0;
    rest = to_goal(r);
  } else if (goals_.size() == 1 && nearest_) {
    const Point goal = mirrored_if_left(goal_box_.min, a, b);
    if (cross(r, right.point, goal) < 0)
      rest = distance(r, right.point) + distance(right.point, goal);
    else if (cross(r, left.point, goal) > 0)
      rest = distance(r, left.point) + distance(left.point, goal);
    else
      rest = distance(r, goal);
  } else {
    const Box part = box_around(right.point, left.point), here{r, r};
    rest = gap(here, part);
    if (nearest_) rest = std::max(gap(here, goal_box_), rest + gap(part, goal_box_));
  }
  const double length = root.length + rest;
  return length - (error + slack_ + root.error + 0x1p-50 * length);
}

}  // namespace taut::detail
