#include <taut/roadmaps/exact/gate_shape.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <initializer_list>

#include <taut/geometry/written.h>

namespace taut {

namespace {

constexpr double kEps = 0x1p-53;

/// a - b, and whether that is exact.
bool exact_difference(double a, double b, double& d) {
  d = a - b;
  const double part = d - a;
  return (a - (d - part)) - (b + part) == 0;
}

Rational dot(const Rational& ux, const Rational& uy, const Rational& vx, const Rational& vy) {
  return ux * vx + uy * vy;
}

/// How far the dot product of two differences of coordinates, those of `from` among them, is off at most (as in
/// written::orientation).
double dot_bound(double ux, double uy, double vx, double vy, Point from) {
  const double reach = std::abs(ux) + std::abs(uy) + std::abs(vx) + std::abs(vy);
  return 9e-16 * reach * (reach + std::abs(from.x) + std::abs(from.y)) + 1e-290;
}

/// Small enough for disc_meets_integer: its largest product stays below 2^118.
bool small_integer(double v) { return std::abs(v) < 0x1p26 && v == std::floor(v); }

bool to_integers(std::initializer_list<double> values, std::int64_t* out, double scale) {
  for (const double v : values) {
    if (!small_integer(v * scale)) return false;
    *out++ = static_cast<std::int64_t>(v * scale);
  }
  return true;
}

/// disc_meets for an exact foot, in integers: all coordinates relative to the gate's end.
bool disc_meets_integer(const std::int64_t* v) {
  __extension__ typedef __int128 Wide;  // NOLINT(modernize-use-using): pedantic compilers take no other
  const std::int64_t qx = v[0], qy = v[1], ax = 2 * v[2] - qx, ay = 2 * v[3] - qy, bx = 2 * v[4] - qx,
                     by = 2 * v[5] - qy;
  const std::int64_t ux = bx - ax, uy = by - ay;
  const Wide reach = Wide(qx) * qx + Wide(qy) * qy;  // (2 radius)^2; a and b are doubled and relative to the centre
  const Wide along = -(Wide(ax) * ux + Wide(ay) * uy), length = Wide(ux) * ux + Wide(uy) * uy;
  if (along <= 0) return Wide(ax) * ax + Wide(ay) * ay <= reach;
  if (along >= length) return Wide(bx) * bx + Wide(by) * by <= reach;
  const Wide cross = Wide(ax) * uy - Wide(ay) * ux;
  return cross * cross <= reach * length;
}

bool disc_meets_rational(const GateShape& shape, const Segment& wall) {
  const ExactPoint foot = exact_foot(shape);
  const ExactPoint end(shape.end), from(wall.a), to(wall.b);
  const Rational mx = (foot.x + end.x) / 2, my = (foot.y + end.y) / 2;
  const Rational hx = foot.x - mx, hy = foot.y - my, reach = dot(hx, hy, hx, hy);
  const Rational ax = from.x - mx, ay = from.y - my, bx = to.x - mx, by = to.y - my;
  const Rational ux = bx - ax, uy = by - ay, along = -dot(ax, ay, ux, uy), length = dot(ux, uy, ux, uy);
  if (along <= 0) return dot(ax, ay, ax, ay) <= reach;
  if (along >= length) return dot(bx, by, bx, by) <= reach;
  const Rational cross = ax * uy - ay * ux;
  return cross * cross <= reach * length;
}

/// disc_meets by doubles; nothing when it is too close to tell.
std::optional<bool> disc_meets_filter(const GateShape& shape, const Segment& wall) {
  const Point foot = nearest_foot(shape), end = shape.end;
  const double mx = end.x + (foot.x - end.x) / 2, my = end.y + (foot.y - end.y) / 2;
  const double ax = wall.a.x - mx, ay = wall.a.y - my, ux = wall.b.x - wall.a.x, uy = wall.b.y - wall.a.y;
  const double length = ux * ux + uy * uy, t = std::clamp(-(ax * ux + ay * uy) / length, 0.0, 1.0);
  const double distance = std::hypot(ax + t * ux, ay + t * uy), radius = std::hypot(foot.x - end.x, foot.y - end.y) / 2;
  double size = 0;
  for (const Point p : {end, foot, wall.a, wall.b}) size = std::max({size, std::abs(p.x), std::abs(p.y)});
  const double slack = 128 * kEps * size + 1e-290;
  if (distance > radius + slack) return false;
  if (distance < radius - slack) return true;
  return std::nullopt;
}

}  // namespace

std::optional<GateShape> gate_to_inside(Point p, const Segment& c) {
  if (dot_sign(c.a, c.b, p) <= 0 || dot_sign(c.b, c.a, p) <= 0) return std::nullopt;
  if (c.a.x == c.b.x) return GateShape{p, {{c.a.x, p.y}, {c.a.x, p.y}}};
  if (c.a.y == c.b.y) return GateShape{p, {{p.x, c.a.y}, {p.x, c.a.y}}};
  return GateShape{p, c};
}

ExactPoint exact_foot(const GateShape& shape) {
  ExactPoint a(shape.facing.a);
  const ExactPoint b(shape.facing.b), end(shape.end);
  if (shape.exact()) return a;
  const Rational ux = b.x - a.x, uy = b.y - a.y;
  const Rational t = dot(ux, uy, end.x - a.x, end.y - a.y) / dot(ux, uy, ux, uy);
  return {a.x + t * ux, a.y + t * uy};
}

Rational squared_width(const GateShape& shape) {
  const ExactPoint foot = exact_foot(shape), end(shape.end);
  const Rational dx = foot.x - end.x, dy = foot.y - end.y;
  return dx * dx + dy * dy;
}

Point nearest_foot(const GateShape& shape) { return shape.exact() ? shape.facing.a : nearest_point(exact_foot(shape)); }

int dot_sign(Point p, Point q, Point x) {
  const double xx = x.x - p.x, xy = x.y - p.y, qx = q.x - p.x, qy = q.y - p.y;
  const double sum = xx * qx + xy * qy, bound = dot_bound(xx, xy, qx, qy, p);
  if (sum > bound) return 1;
  if (-sum > bound) return -1;
  const ExactPoint at(p), u(x), v(q);
  return sgn(dot(u.x - at.x, u.y - at.y, v.x - at.x, v.y - at.y));
}

int foot_orientation(Point a, Point b, const GateShape& shape) {
  if (shape.exact()) return written::orientation(a, b, shape.facing.a);
  const int from = written::orientation(a, b, shape.facing.a), to = written::orientation(a, b, shape.facing.b);
  if (from == to) return from;
  const ExactPoint foot = exact_foot(shape);
  const ExactPoint start(a), end(b);
  return sgn((end.x - start.x) * (foot.y - start.y) - (end.y - start.y) * (foot.x - start.x));
}

int side_of_gate(const GateShape& shape, Point p) {
  if (shape.exact()) return written::orientation(shape.end, shape.facing.a, p);
  const auto [a, b] = shape.facing;
  const double px = p.x - shape.end.x, py = p.y - shape.end.y, ux = b.x - a.x, uy = b.y - a.y;
  const double sum = px * ux + py * uy;
  if (std::abs(sum) > std::max(dot_bound(px, py, ux, uy, shape.end), dot_bound(px, py, ux, uy, a)))
    return sum > 0 ? 1 : -1;
  const ExactPoint end(shape.end), at(p), from(a), to(b);
  return sgn(dot(at.x - end.x, at.y - end.y, to.x - from.x, to.y - from.y));
}

bool disc_meets(const GateShape& shape, const Segment& wall) {
  if (const auto told = disc_meets_filter(shape, wall)) return *told;
  const Point p = shape.end, q = shape.facing.a, a = wall.a, b = wall.b;
  double d[6];
  const auto is_plain = [](Point r) { return written::is_plain(r.x) && written::is_plain(r.y); };
  const bool whole = shape.exact() && is_plain(p) && is_plain(q) && is_plain(a) && is_plain(b) &&
                     exact_difference(q.x, p.x, d[0]) && exact_difference(q.y, p.y, d[1]) &&
                     exact_difference(a.x, p.x, d[2]) && exact_difference(a.y, p.y, d[3]) &&
                     exact_difference(b.x, p.x, d[4]) && exact_difference(b.y, p.y, d[5]);
  std::int64_t v[6];
  if (whole && to_integers({d[0], d[1], d[2], d[3], d[4], d[5]}, v, 0x1p10)) return disc_meets_integer(v);
  return disc_meets_rational(shape, wall);
}

bool nearer_than_gate(const GateShape& shape, bool to_end, const Segment& wall) {
  const Point foot = nearest_foot(shape), centre = to_end ? shape.end : foot;
  const double ax = wall.a.x - centre.x, ay = wall.a.y - centre.y, ux = wall.b.x - wall.a.x, uy = wall.b.y - wall.a.y;
  const double t = std::clamp(-(ax * ux + ay * uy) / (ux * ux + uy * uy), 0.0, 1.0);
  const double distance = std::hypot(ax + t * ux, ay + t * uy);
  const double radius = std::hypot(foot.x - shape.end.x, foot.y - shape.end.y);
  double size = 0;
  for (const Point p : {shape.end, foot, wall.a, wall.b}) size = std::max({size, std::abs(p.x), std::abs(p.y)});
  const double slack = 128 * kEps * size + 1e-290;
  if (distance > radius + slack) return false;
  if (distance < radius - slack) return true;
  const ExactPoint from(wall.a), to(wall.b), q = to_end ? ExactPoint(shape.end) : exact_foot(shape);
  const Rational px = q.x - from.x, py = q.y - from.y, vx = to.x - from.x, vy = to.y - from.y;
  const Rational along = dot(px, py, vx, vy), length = dot(vx, vy, vx, vy), reach = squared_width(shape);
  if (along <= 0) return dot(px, py, px, py) < reach;
  if (along >= length) return dot(px - vx, py - vy, px - vx, py - vy) < reach;
  const Rational cross = px * vy - py * vx;
  return cross * cross < reach * length;
}

bool disc_entered(const GateShape& shape, Point at, const Segment& wall) {
  const Point away = wall.a == at ? wall.b : wall.a;
  if (shape.exact()) return dot_sign(at, at == shape.end ? shape.facing.a : shape.end, away) > 0;
  // The gate stands upright on `facing`: its direction at the end is the one towards the line.
  const int side = written::orientation(shape.facing.a, shape.facing.b, at);
  const ExactPoint a(shape.facing.a), b(shape.facing.b), from(at), to(away);
  const Rational nx = -(b.y - a.y), ny = b.x - a.x;
  return sgn(nx * (to.x - from.x) + ny * (to.y - from.y)) * side < 0;
}

}  // namespace taut
