#include <taut/roadmaps/bezier.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace taut {

namespace {

/// The integral of sqrt(s^2 + m^2).
double root_integral(double s, double m) {
  return 0.5 * (s * std::hypot(s, m) + (m > 0 ? m * m * std::asinh(s / m) : 0));
}

Point mixed(Point p, Point q, double t) { return {p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)}; }

}  // namespace

Point foot_on(const Segment& s, Point p) {
  if (s.a == s.b) return s.a;
  const double dx = s.b.x - s.a.x, dy = s.b.y - s.a.y;
  const double t = std::clamp(((p.x - s.a.x) * dx + (p.y - s.a.y) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
  return t == 1 ? s.b : mixed(s.a, s.b, t);
}

Point Bezier::at(double t) const { return mixed(mixed(from, control, t), mixed(control, to, t), t); }

Bezier Bezier::part(double t0, double t1) const {
  return {at(t0), mixed(mixed(from, control, t0), mixed(control, to, t0), t1), at(t1)};
}

double Bezier::length() const {
  const double ax = 2 * (control.x - from.x), ay = 2 * (control.y - from.y);  // the speed at 0, and how it changes
  const double bx = 2 * (to.x - control.x) - ax, by = 2 * (to.y - control.y) - ay;
  const double change = std::hypot(bx, by);
  if (change <= 0.1 * std::min(std::hypot(ax, ay), std::hypot(ax + bx, ay + by))) {
    constexpr std::array<double, 3> node{0, 0.5384693101056831, 0.9061798459386640};  // Gauss-Legendre, 5 points
    constexpr std::array<double, 3> weight{0.5688888888888889, 0.4786286704993665, 0.2369268850561891};
    double sum = 0;
    for (int i = -2; i <= 2; ++i) {
      const double t = 0.5 + (i < 0 ? -0.5 : 0.5) * node[std::abs(i)];
      sum += 0.5 * weight[std::abs(i)] * std::hypot(ax + t * bx, ay + t * by);
    }
    return sum;
  }
  if (change == 0) return 0;
  const double along = (ax * bx + ay * by) / change, off = std::abs(ax * by - ay * bx) / change;
  return (root_integral(along + change, off) - root_integral(along, off)) / change;
}

}  // namespace taut
