#include <taut/roadmaps/detail/voronoi_geometry.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <taut/geometry/exact/numbers.h>

#include <taut/geometry/written.h>

namespace taut::detail {

namespace {

using Real = long double;

constexpr Real kRealEps = std::numeric_limits<Real>::epsilon();
constexpr double kUnknown = std::numeric_limits<double>::infinity();

struct Vector {
  Real x = 0;
  Real y = 0;
};

/// An equation f = 0 at some point: value, gradient, a bound of the gradient's change near by, and of the value's
/// rounding.
struct Equation {
  Real value = 0;
  Vector gradient;
  Real bend = 0;
  Real rounding = 0;
};

bool is_point(const Segment& s) { return s.a == s.b; }

/// Coordinates are measured so that squares neither overflow nor vanish.
Real norm(Real x, Real y) { return std::sqrt(x * x + y * y); }

Vector from(Point p, Vector v) { return {v.x - p.x, v.y - p.y}; }

Vector direction(const Segment& s) {
  const Vector d{Real(s.b.x) - s.a.x, Real(s.b.y) - s.a.y};
  const Real length = norm(d.x, d.y);
  return {d.x / length, d.y / length};
}

/// A segment with its direction, which is asked for again and again.
struct Site : Segment {
  Site(const Segment& s) : Segment(s), along(is_point(s) ? Vector{} : direction(s)) {}

  Vector along;
};

Equation distance(const Site& s, Vector v) {
  const Vector w = from(s.a, v);
  const Real reach = norm(w.x, w.y);
  if (is_point(s)) return {reach, {w.x / reach, w.y / reach}, 1 / reach, 4 * kRealEps * reach};
  const Vector d = s.along;
  const Real off = d.x * w.y - d.y * w.x, sign = off < 0 ? -1 : 1;
  return {sign * off, {-sign * d.y, sign * d.x}, 0, 8 * kRealEps * reach};
}

Equation equally_far(const Site& s, const Site& t, Vector v) {
  const Equation a = distance(s, v), b = distance(t, v);
  return {a.value - b.value,
          {a.gradient.x - b.gradient.x, a.gradient.y - b.gradient.y},
          a.bend + b.bend,
          a.rounding + b.rounding + kRealEps * (a.value + b.value)};
}

Point shared_end(const Segment& s, const Segment& t) { return s.a == t.a || s.a == t.b ? s.a : s.b; }

bool share_end(const Segment& s, const Segment& t) { return s.a == t.a || s.a == t.b || s.b == t.a || s.b == t.b; }

/// Through a shared end: the perpendicular of a piece and its own end, the bisector of two pieces.
struct Ray {
  Point foot;
  Vector normal;          // from the first site towards the second
  bool straight = false;  // the first site touches a circle around a point of the ray in `foot`, or nearly so

  Equation at(Vector v) const {
    const Vector w = from(foot, v);
    return {normal.x * w.x + normal.y * w.y, normal, 0, 8 * kRealEps * norm(w.x, w.y)};
  }
};

/// The ray two sites are equally far on because they share an end, unless they turn back there: then their distances
/// tell more. Of pieces that go on nearly straight, as where a wall was rounded, the distances tell nothing.
std::optional<Ray> linked(const Segment& s, const Segment& t) {
  if (is_point(s) || !share_end(s, t)) return std::nullopt;
  const Point end = shared_end(s, t);
  const Vector in = direction(s.b == end ? s : Segment{s.b, s.a});
  if (is_point(t)) return Ray{end, in, true};
  const Vector out = direction(t.a == end ? t : Segment{t.b, t.a});
  if (in.x * out.x + in.y * out.y < 0) return std::nullopt;
  const Vector sum{in.x + out.x, in.y + out.y};
  const Real length = norm(sum.x, sum.y);
  return Ray{end, {sum.x / length, sum.y / length}, length > 1.9999L};
}

/// The two equations a vertex satisfies: the first two sites are equally far on `ray`, if any.
struct Conditions {
  std::array<Site, 3> sites;
  std::optional<Ray> ray;
  bool counter_clockwise = true;  // the sites, as seen from the vertex

  std::array<Equation, 2> at(Vector v) const {
    return {ray ? ray->at(v) : equally_far(sites[0], sites[1], v), equally_far(sites[0], sites[2], v)};
  }
};

/// A piece and its own end first: a circle that touches both does so in one point, so their distances are one
/// condition. Then pieces that go on straight: the difference of their distances says least.
Conditions conditions(const std::array<Segment, 3>& sites) {
  std::array<int, 3> order{0, 1, 2};
  std::optional<Ray> best;
  int best_score = 0;
  bool counter_clockwise = true;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const auto ray = i != j ? linked(sites[i], sites[j]) : std::nullopt;
      const int score = !ray ? 0 : is_point(sites[j]) ? 3 : ray->straight ? 2 : 1;
      if (score > best_score)
        order = {i, j, 3 - i - j}, best = ray, counter_clockwise = j == (i + 1) % 3, best_score = score;
    }
  return {{sites[order[0]], sites[order[1]], sites[order[2]]}, best, counter_clockwise};
}

struct Step {
  Vector move;
  Real inverse = 0;  // norm of the inverse Jacobian
  Real bend = 0;
  Real rounding = 0;
};

Step newton(const Conditions& c, Vector v) {
  const auto [f, g] = c.at(v);
  const Real det = f.gradient.x * g.gradient.y - f.gradient.y * g.gradient.x;
  const Real size = norm(norm(f.gradient.x, f.gradient.y), norm(g.gradient.x, g.gradient.y));
  return {{-(f.value * g.gradient.y - g.value * f.gradient.y) / det,
           -(g.value * f.gradient.x - f.value * g.gradient.x) / det},
          size / std::abs(det),
          norm(f.bend, g.bend),
          norm(f.rounding, g.rounding)};
}

/// How far the exact point lies from v at most, when one more step would be `step`.
Real kantorovich(const Step& step, Real clearance) {
  const Real reach = norm(step.move.x, step.move.y) + step.inverse * step.rounding;
  if (!(4 * reach < clearance)) return kUnknown;
  const Real bend = 4 * step.bend;  // within 2 * reach < clearance / 2 no distance halves
  return step.inverse * bend * reach <= 0.5L ? 2 * reach : Real(kUnknown);
}

/// Where the third site is as far as the foot of a straight ray. The cells follow each other counter-clockwise, so the
/// ray's side is known.
Vector point_on_ray(const Conditions& c) {
  const Ray& ray = *c.ray;
  const Vector u = c.counter_clockwise ? Vector{-ray.normal.y, ray.normal.x} : Vector{ray.normal.y, -ray.normal.x};
  const Site& t = c.sites[2];
  const Vector w = from(ray.foot, {t.a.x, t.a.y});
  Real reach = (w.x * w.x + w.y * w.y) / (2 * (u.x * w.x + u.y * w.y));
  if (!is_point(t)) {
    const Vector d = t.along;
    const Real off = d.y * w.x - d.x * w.y,
               rise = d.x * u.y - d.y * u.x;  // of the foot from t's line, and along the ray
    reach = std::abs(off) / (1 - (off < 0 ? -rise : rise));
  }
  return {ray.foot.x + reach * u.x, ray.foot.y + reach * u.y};
}

/// Of two points and a piece nearly parallel to the line through them: the centre of one of the two circles there are,
/// of which one lies far off or, parallel, nowhere. A guess by general formulas divides by almost 0 and may be astray.
std::optional<Vector> centre_over_level_points(const std::array<Segment, 3>& sites, Point guess) {
  constexpr Real kLevel = 1e-9L;  // the square of the sine
  constexpr Real kAstray = 1e8L;  // of a guess, in distances of the sites
  const auto piece = std::find_if(sites.begin(), sites.end(), [](const Segment& s) { return !is_point(s); });
  const auto i = static_cast<std::size_t>(piece - sites.begin());
  if (i == 3 || !is_point(sites[(i + 1) % 3]) || !is_point(sites[(i + 2) % 3])) return std::nullopt;
  const Point p = sites[(i + 1) % 3].a, q = sites[(i + 2) % 3].a;
  const Vector d = direction(*piece), e = direction({p, q}), normal{-e.y, e.x};
  const Vector middle{(Real(p.x) + q.x) / 2, (Real(p.y) + q.y) / 2}, w = from(piece->a, middle);
  const Real sine = d.x * normal.x + d.y * normal.y, half = norm(Real(q.x) - p.x, Real(q.y) - p.y) / 2;
  const Real off = d.x * w.y - d.y * w.x, slope = d.x * normal.y - d.y * normal.x;
  if (sine * sine > kLevel || off == 0) return std::nullopt;
  // (off + slope s)^2 = half^2 + s^2, s from the middle along the normal; solved without cancellation.
  const Real b = off * slope, c = off * off - half * half;
  const Real sum = -(b + std::copysign(std::sqrt(std::max(Real(0), b * b + sine * sine * c)), b));
  const Real near = c / sum, far = -sum / (sine * sine);
  const Real guessed = (guess.x - middle.x) * normal.x + (guess.y - middle.y) * normal.y;
  const bool trusts = std::abs(guessed) < kAstray * (half + std::abs(off));
  const Real s = trusts && std::abs(guessed - far) < std::abs(guessed - near) ? far : near;
  return Vector{middle.x + s * normal.x, middle.y + s * normal.y};
}

VoronoiPoint refined(const Conditions& c, Vector v) {
  for (int round = 0; round < 8; ++round) {
    const Vector move = newton(c, v).move;
    if (!std::isfinite(move.x) || !std::isfinite(move.y)) return {{}, 0, kUnknown};
    v = {v.x + move.x, v.y + move.y};
    if (norm(move.x, move.y) <= 4 * kRealEps * (std::abs(v.x) + std::abs(v.y))) break;
  }
  const Real clearance = distance(c.sites[2], v).value;
  const Point at{double(v.x), double(v.y)};
  const Real error = kantorovich(newton(c, v), clearance) + norm(at.x - v.x, at.y - v.y);
  return {at, double(clearance), std::nextafter(double(error), kUnknown)};
}

}  // namespace

const Segment* joint(const std::array<Segment, 3>& sites) {
  for (int i = 0; i < 3; ++i)
    if (is_own_end(sites[i], sites[(i + 1) % 3]) && is_own_end(sites[i], sites[(i + 2) % 3])) return &sites[i];
  return nullptr;
}

bool is_own_end(const Segment& p, const Segment& s) {
  return is_point(p) && !is_point(s) && (p.a == s.a || p.a == s.b);
}

bool go_straight_on(const Segment& s, const Segment& t) {
  if (is_point(s) || is_point(t) || !share_end(s, t)) return false;
  return written::orientation(s.a, s.b, t.a) == 0 && written::orientation(s.a, s.b, t.b) == 0;
}

bool parallel(const Segment& s, const Segment& t) {
  const double sx = s.b.x - s.a.x, sy = s.b.y - s.a.y, tx = t.b.x - t.a.x, ty = t.b.y - t.a.y;
  // Along an axis nothing need be multiplied: a difference is 0 only when it is.
  if ((sx == 0 || sy == 0) && (tx == 0 || ty == 0)) return sx == 0 ? tx == 0 : ty == 0;
  const double left = sx * ty, right = sy * tx;
  if (std::abs(left - right) > 1e-14 * (std::abs(left) + std::abs(right))) return false;
  const Rational ux = Rational(s.b.x) - s.a.x, uy = Rational(s.b.y) - s.a.y;
  return ux * (Rational(t.b.y) - t.a.y) == uy * (Rational(t.b.x) - t.a.x);
}

VoronoiPoint voronoi_point(const std::array<Segment, 3>& sites, Point guess) {
  return voronoi_point(sites, [guess] { return guess; });
}

VoronoiPoint voronoi_point(const std::array<Segment, 3>& sites, const std::function<Point()>& guess) {
  if (const Segment* end = joint(sites)) {
    const bool straight = go_straight_on(sites[end == &sites[0] ? 1 : 0], sites[end == &sites[2] ? 1 : 2]);
    return {end->a, 0, straight ? kUnknown : 0};
  }
  const Conditions c = conditions(sites);
  if (c.ray && c.ray->straight) return refined(c, point_on_ray(c));
  const Point near = guess();
  return refined(c, centre_over_level_points(sites, near).value_or(Vector{near.x, near.y}));
}

Point parabola_control(Point focus, const Segment& directrix, Point p, Point q) {
  const Vector d = direction(directrix);
  const Vector w = from(directrix.a, {focus.x, focus.y});
  const Real off = d.x * w.y - d.y * w.x, height = std::abs(off), sign = off < 0 ? -1 : 1;
  if (height == 0) return {p.x + (q.x - p.x) / 2, p.y + (q.y - p.y) / 2};
  const auto along = [&](Point r) { return d.x * (Real(r.x) - focus.x) + d.y * (Real(r.y) - focus.y); };
  const Real x0 = along(p), x1 = along(q);
  // Over the directrix the parabola is (x^2 + h^2) / 2h high; its tangents meet half-way.
  const Real x = (x0 + x1) / 2, y = (x0 * x1 + height * height) / (2 * height) - height;
  return {double(focus.x + x * d.x - sign * y * d.y), double(focus.y + x * d.y + sign * y * d.x)};
}

}  // namespace taut::detail
