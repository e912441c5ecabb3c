#include <taut/search/detail/direction.h>

#include <taut/geometry/exact/numbers.h>

#include <cmath>

#include <taut/geometry/exact/exact_point.h>

namespace taut::detail {

namespace {

template <class Number>
struct Vector {
  Number x, y;
};

template <class Number>
Vector<Number> turned(Number x, Number y, int quarters) {
  switch (quarters) {
    case 0: return {x, y};
    case 1: return {-y, x};
    case 2: return {-x, -y};
    default: return {y, -x};
  }
}

Vector<double> rough(const Direction& d) { return turned(d.to.x - d.from.x, d.to.y - d.from.y, d.quarters); }

Vector<Rational> exact(const Direction& d) {
  const ExactPoint from(d.from), to(d.to);
  return turned(Rational(to.x - from.x), Rational(to.y - from.y), d.quarters);
}

double size(Point p) { return std::abs(p.x) + std::abs(p.y); }
double reach(const Vector<double>& v) { return std::abs(v.x) + std::abs(v.y); }

/// The half of the circle, from the direction of x.
int half(const Direction& d) {
  // The order of doubles is that of what they mean, so the signs are exact.
  const Vector<double> v =
      turned<double>((d.to.x > d.from.x) - (d.to.x < d.from.x), (d.to.y > d.from.y) - (d.to.y < d.from.y), d.quarters);
  return v.y > 0 || (v.y == 0 && v.x > 0) ? 0 : 1;
}

}  // namespace

int turn(const Direction& u, const Direction& v) {
  const Vector<double> a = rough(u), b = rough(v);
  const double det = a.x * b.y - a.y * b.x, far = reach(a) + reach(b);
  const double bound = 2e-15 * far * (far + size(u.from) + size(v.from)) + 1e-290;
  if (det > bound) return 1;
  if (-det > bound) return -1;
  const Vector<Rational> p = exact(u), q = exact(v);
  return sgn(Rational(p.x * q.y - p.y * q.x));
}

bool angle_less(const Direction& u, const Direction& v) {
  const int a = half(u), b = half(v);
  return a != b ? a < b : turn(u, v) > 0;
}

int compare_along(Point a, Point b, Point p, Point q) {
  const double ux = b.x - a.x, uy = b.y - a.y, vx = p.x - q.x, vy = p.y - q.y;
  const double dot = ux * vx + uy * vy, far = std::abs(ux) + std::abs(uy) + std::abs(vx) + std::abs(vy);
  const double bound = 2e-15 * far * (far + size(a) + size(q)) + 1e-290;
  if (dot > bound) return 1;
  if (-dot > bound) return -1;
  if (a.x == b.x && p.y == q.y) return 0;
  if (a.y == b.y && p.x == q.x) return 0;
  const ExactPoint from(a), to(b), one(p), other(q);
  return sgn(Rational((to.x - from.x) * (one.x - other.x) + (to.y - from.y) * (one.y - other.y)));
}

}  // namespace taut::detail
