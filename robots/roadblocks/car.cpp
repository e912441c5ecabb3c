#include <taut/robots/roadblocks/car.h>

#include <algorithm>
#include <cmath>

namespace taut::roadblocks {

namespace {

/// A pose's axes.
struct Frame {
  Frame(Point at, Point ahead) : x(at.x), y(at.y), c(ahead.x), s(ahead.y) {}
  explicit Frame(const Pose& pose) : x(pose.x), y(pose.y), c(std::cos(pose.heading)), s(std::sin(pose.heading)) {}

  Point inwards(Point p) const { return {c * (p.x - x) + s * (p.y - y), c * (p.y - y) - s * (p.x - x)}; }
  Point outwards(Point p) const { return {x + c * p.x - s * p.y, y + s * p.x + c * p.y}; }

  double x, y, c, s;
};

constexpr double kStraight = 1e-7;  // a control below it bends by less than 1e-9

bool turns(double control) { return control >= -1 && control <= 1; }

std::array<Point, 4> rectangle(double half_length, double half_width) {
  return {
      {{half_length, -half_width}, {half_length, half_width}, {-half_length, half_width}, {-half_length, -half_width}}};
}

std::array<Point, 4> square(Cell c) {
  const double x = c.x, y = c.y;
  return {{{x - 0.5, y - 0.5}, {x + 0.5, y - 0.5}, {x + 0.5, y + 0.5}, {x - 0.5, y + 0.5}}};
}

/// Do a rectangle and a square have a point in common? By the four axes that could separate them.
bool overlap(const Frame& car, Cell cell, double half_length, double half_width) {
  const Point centre = car.inwards({static_cast<double>(cell.x), static_cast<double>(cell.y)});
  const double c = std::abs(car.c), s = std::abs(car.s), half = 0.5 * (c + s);
  return std::abs(centre.x) <= half_length + half && std::abs(centre.y) <= half_width + half &&
         std::abs(cell.x - car.x) <= 0.5 + half_length * c + half_width * s &&
         std::abs(cell.y - car.y) <= 0.5 + half_length * s + half_width * c;
}

/// Does a straight move from `a` to `b` enter the box |x| <= half.x, |y| <= half.y?
bool line_enters(Point a, Point b, Point half) {
  double lo = 0, hi = 1;
  const auto clip = [&](double from, double by, double limit) {
    if (by == 0) return std::abs(from) <= limit;
    const double t = (-limit - from) / by, u = (limit - from) / by;
    lo = std::max(lo, std::min(t, u));
    hi = std::min(hi, std::max(t, u));
    return lo <= hi;
  };
  return clip(a.x, b.x - a.x, half.x) && clip(a.y, b.y - a.y, half.y);
}

/// Does the point `p` turned around `centre` by `angle` (below a half turn) cross a side of the box |x| <= half.x, |y|
/// <= half.y?
bool arc_crosses(Point p, Point centre, double angle, Point half) {
  const double dx = p.x - centre.x, dy = p.y - centre.y, square = dx * dx + dy * dy;
  const double ex = std::cos(angle), ey = std::sin(angle);
  // On the arc iff between its ends: the turn from p, and the turn to its end, both in the sense of the angle.
  const auto on_arc = [&](double qx, double qy) {
    const double sense = angle < 0 ? -1 : 1;
    const double endx = ex * dx - ey * dy, endy = ey * dx + ex * dy;
    return sense * (dx * qy - dy * qx) >= 0 && sense * (qx * endy - qy * endx) >= 0 && dx * qx + dy * qy > 0;
  };
  for (const double side : {-1.0, 1.0}) {
    if (const double qx = side * half.x - centre.x, rest = square - qx * qx; rest >= 0)
      for (const double qy : {std::sqrt(rest), -std::sqrt(rest)})
        if (std::abs(centre.y + qy) <= half.y && on_arc(qx, qy)) return true;
    if (const double qy = side * half.y - centre.y, rest = square - qy * qy; rest >= 0)
      for (const double qx : {std::sqrt(rest), -std::sqrt(rest)})
        if (std::abs(centre.x + qx) <= half.x && on_arc(qx, qy)) return true;
  }
  return false;
}

/// The square against the car's whole way, in the car's first frame and in the square's.
bool sweeps(const Pose& from, double control, Cell cell, double slack) {
  const Frame car(from);
  const Point half{kHalfLength + slack, kHalfWidth + slack};
  const double x = cell.x, y = cell.y;
  if (std::abs(control) < kStraight || control == kReverse) {
    const double way = control == kReverse ? -kBackward : kForward;
    for (const Point p : square(cell)) {
      const Point q = car.inwards(p);
      if (line_enters(q, {q.x - way, q.y}, half)) return true;
    }
    for (const Point p : rectangle(half.x, half.y)) {
      const Point q = car.outwards(p);
      if (line_enters({q.x - x, q.y - y}, {q.x - x + way * car.c, q.y - y + way * car.s}, {0.5, 0.5})) return true;
    }
    return false;
  }
  const double angle = kTurn * control, radius = kForward / angle;
  for (const Point p : square(cell))
    if (arc_crosses(car.inwards(p), {0, radius}, -angle, half)) return true;
  const Point centre = car.outwards({0, radius});
  for (const Point p : rectangle(half.x, half.y)) {
    const Point q = car.outwards(p);
    if (arc_crosses({q.x - x, q.y - y}, {centre.x - x, centre.y - y}, angle, {0.5, 0.5})) return true;
  }
  return false;
}

}  // namespace

Pose stepped(const Pose& from, double control) {
  if (control == kReverse)
    return {from.x - kBackward * std::cos(from.heading), from.y - kBackward * std::sin(from.heading), from.heading};
  if (!turns(control)) return from;
  if (std::abs(control) < kStraight)
    return {from.x + kForward * std::cos(from.heading), from.y + kForward * std::sin(from.heading),
            from.heading + kTurn * control};
  // The chord: sin a - sin b without the cancellation that a large radius brings.
  const double turn = kTurn * control, middle = from.heading + turn / 2;
  const double chord = kForward * (std::sin(turn / 2) / (turn / 2));
  return {from.x + chord * std::cos(middle), from.y + chord * std::sin(middle), from.heading + turn};
}

bool covers(const Pose& pose, Point p, double slack) {
  const Point q = Frame(pose).inwards(p);
  return std::abs(q.x) <= kHalfLength + slack && std::abs(q.y) <= kHalfWidth + slack;
}

std::array<Point, 4> corners(const Pose& pose) {
  const Frame frame(pose);
  std::array<Point, 4> points = rectangle(kHalfLength, kHalfWidth);
  for (Point& p : points) p = frame.outwards(p);
  return points;
}

bool touches(const Pose& pose, Cell cell, WallReading reading, double slack) {
  if (reading == WallReading::points)
    return covers(pose, {static_cast<double>(cell.x), static_cast<double>(cell.y)}, slack);
  return overlap(Frame(pose), cell, kHalfLength + slack, kHalfWidth + slack);
}

bool meets(const Pose& from, double control, Cell cell, WallReading reading, double slack) {
  return Step(from, control).meets(cell, reading, slack);
}

Step::Step(const Pose& from, double control) : from_(from), control_(control) {
  const double way = turns(control) ? kForward / 2 : control == kReverse ? -kBackward / 2 : 0;
  const double heading = from.heading + (turns(control) ? kTurn * control / 2 : 0);
  ahead_ = {std::cos(heading), std::sin(heading)};
  middle_ = {from.x + way * ahead_.x, from.y + way * ahead_.y};
}

/// Cheap and sure: the car half-way, wider by more than it moves and turns from there to either end, does not touch the
/// square.
bool Step::is_out_of_reach(Cell cell, double slack) const {
  // 0.075 ahead, 0.025 radians of the sides and the ends, the arc's height, and 0.001 that the middle is beside it.
  constexpr double kAlong = 0.112, kAcross = 0.047;
  return !overlap(Frame(middle_, ahead_), cell, kHalfLength + slack + kAlong, kHalfWidth + slack + kAcross);
}

bool Step::meets(Cell cell, WallReading reading, double slack) const {
  if (reading == WallReading::squares && is_out_of_reach(cell, slack)) return false;
  if (touches(stepped(from_, control_), cell, reading, slack)) return true;
  if (reading == WallReading::points || (control_ != kReverse && !turns(control_))) return false;
  return sweeps(from_, control_, cell, slack);
}

}  // namespace taut::roadblocks
