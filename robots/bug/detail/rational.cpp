#include <taut/robots/bug/detail/rational.h>

#include <cmath>

namespace taut::bug::detail {

namespace {

int signed_area(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c) {
  return sgn((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
}

/// The sign of p + 2 sqrt(q) - 2 sqrt(r).
int sign_of_roots(const Rational& p, const Rational& q, const Rational& r) {
  if (p < 0) return -sign_of_roots(-p, r, q);
  // p + 2 sqrt(q) >= 0: squared, p^2 + 4 q + 4 p sqrt(q) against 4 r.
  const Rational rest = p * p + 4 * q - 4 * r;
  if (rest >= 0) return rest > 0 || (p > 0 && q > 0) ? 1 : 0;
  return sgn(16 * p * p * q - rest * rest);
}

}  // namespace

Spot::Spot(const ExactPoint& p) : exact(p) {
  const Point q = taut::nearest_point(p);
  if (ExactPoint(q) == p) doubles = q;
}

int orientation(const Spot& a, const Spot& b, Point c) {
  if (a.doubles && b.doubles) return written::orientation(*a.doubles, *b.doubles, c);
  return signed_area(a.exact, b.exact, ExactPoint(c));
}

int orientation(const Spot& a, Point b, Point c) {
  if (a.doubles) return written::orientation(*a.doubles, b, c);
  return signed_area(a.exact, ExactPoint(b), ExactPoint(c));
}

int orientation(Point a, Point b, const Spot& c) {
  if (c.doubles) return written::orientation(a, b, *c.doubles);
  return signed_area(ExactPoint(a), ExactPoint(b), c.exact);
}

bool same_way(const ExactPoint& v, const ExactPoint& a, const ExactPoint& b) {
  return cmp(a.x, v.x) * cmp(b.x, v.x) >= 0 && cmp(a.y, v.y) * cmp(b.y, v.y) >= 0;
}

Rational squared_distance(const ExactPoint& a, const ExactPoint& b) {
  const Rational dx = a.x - b.x, dy = a.y - b.y;
  return dx * dx + dy * dy;
}

ExactPoint crossing(const Spot& p, const Spot& q, Point a, Point b) {
  if (p.doubles && q.doubles) return taut::line_crossing({*p.doubles, *q.doubles}, {a, b});
  const ExactPoint from(a), to(b);
  const Rational dx = q.exact.x - p.exact.x, dy = q.exact.y - p.exact.y, ex = to.x - from.x, ey = to.y - from.y;
  const Rational along = ((from.x - p.exact.x) * ey - (from.y - p.exact.y) * ex) / (dx * ey - dy * ex);
  return {p.exact.x + along * dx, p.exact.y + along * dy};
}

ExactPoint nearest_on(Point a, Point b, const ExactPoint& p) {
  ExactPoint from(a), to(b);
  const Rational dx = to.x - from.x, dy = to.y - from.y, along = dx * (p.x - from.x) + dy * (p.y - from.y);
  const Rational whole = dx * dx + dy * dy;
  if (along <= 0) return from;
  if (along >= whole) return to;
  const Rational part = along / whole;
  return {from.x + part * dx, from.y + part * dy};
}

int compare_roots(const Rational& a, const Rational& b, const Rational& c, const Rational& d) {
  const double left = std::sqrt(to_double(a)) + std::sqrt(to_double(b)),
               right = std::sqrt(to_double(c)) + std::sqrt(to_double(d));
  if (std::abs(left - right) > 1e-14 * (left + right) + 1e-150) return left < right ? -1 : 1;
  return sign_of_roots(a + b - c - d, a * b, c * d);
}

}  // namespace taut::bug::detail
