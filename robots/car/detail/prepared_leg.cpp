#include <taut/robots/car/detail/prepared_leg.h>

#include <algorithm>
#include <cmath>

#include <taut/geometry/box.h>
#include <taut/geometry/predicates.h>

namespace taut::car::detail {

namespace {

constexpr double kSlack = 1e-9;  // of filters, relative: far above rounding

bool apart(const Box& s, const Box& t) {
  return s.max.x < t.min.x || t.max.x < s.min.x || s.max.y < t.min.y || t.max.y < s.min.y;
}

Point point(const Vec<Approx>& a) { return {a.x.v, a.y.v}; }

double square(Point p) { return p.x * p.x + p.y * p.y; }

double square_to_segment(Point p, Point a, Point b) {
  const double dx = b.x - a.x, dy = b.y - a.y, length = dx * dx + dy * dy;
  const double t = length > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / length, 0.0, 1.0) : 0;
  return square({a.x + t * dx - p.x, a.y + t * dy - p.y});
}

void add_corners(const Rectangle<Approx>& r, std::vector<Point>& corners) {
  for (const double x : {r.low.v, r.high.v})
    for (const double y : {-r.half.v, r.half.v})
      corners.push_back(
          {r.origin.x.v + x * r.along.x.v - y * r.along.y.v, r.origin.y.v + x * r.along.y.v + y * r.along.x.v});
}

}  // namespace

NearWall::NearWall(const Segment& s, Point origin)
    : a(difference<Approx>(origin, s.a)), b(difference<Approx>(origin, s.b)), wall(s) {
  const double slack = a.x.e + a.y.e + b.x.e + b.y.e;
  box = widened(box_around(point(a), point(b)), slack);
}

PreparedLeg::PreparedLeg(const Leg& leg, const CarShape& shape)
    : leg_(leg), length_(curve_of(leg).length()), sweep_(leg, shape) {
  std::vector<Point> corners;
  add_corners(sweep_.before, corners);
  double bulge = 0;
  if (sweep_.sense != 0) {
    add_corners(sweep_.after, corners);
    pivot_ = point(sweep_.arc.pivot);
    const double half = std::atan2(std::abs(sweep_.arc.sine.v), sweep_.arc.cosine.v) / 2;
    inner_ = 1e300;
    for (std::size_t k = 0; k < 4; ++k) {
      const Point c = point(sweep_.arc.first[k]), next = point(sweep_.arc.first[(k + 1) % 4]);
      outer_ = std::max(outer_, square(c));
      inner_ = std::min(inner_, square_to_segment({}, c, next));
      for (const Point p : {c, point(sweep_.arc.last[k])}) corners.push_back({p.x + pivot_.x, p.y + pivot_.y});
    }
    const LegCurve curve = curve_of(leg);
    if (curve.radius < shape.half_width) inner_ = 0;  // the pivot may lie inside the car
    bulge = std::sqrt(outer_) * (1 - std::cos(half));
    outer_ *= 1 + kSlack;
    inner_ *= 1 - kSlack;
  }
  box_ = widened(box_around(corners), bulge + kSlack * (length_ + shape.outer_radius()));
}

bool PreparedLeg::is_outside_ring(const NearWall& wall) const {
  const Point a{wall.a.x.v - pivot_.x, wall.a.y.v - pivot_.y}, b{wall.b.x.v - pivot_.x, wall.b.y.v - pivot_.y};
  if (std::max(square(a), square(b)) > 1e6 * outer_) return false;  // long walls: cancellation
  return (square(a) < inner_ && square(b) < inner_) || square_to_segment({}, a, b) > outer_;
}

bool PreparedLeg::meets(const NearWall& wall, const Leg& at, const CarShape& shape) const {
  if (apart(box_, wall.box)) return false;
  Answer answer = sweep_.has_before ? detail::meets(sweep_.before, wall.a, wall.b) : Answer::no;
  const auto add = [&answer](Answer other) {
    if (answer != Answer::yes && other != Answer::no) answer = other;
  };
  if (sweep_.sense != 0) {
    if (sweep_.has_after) add(detail::meets(sweep_.after, wall.a, wall.b));
    if (answer == Answer::no && !is_outside_ring(wall)) add(detail::meets(sweep_.arc, wall.a, wall.b));
  }
  if (answer != Answer::doubt) return answer == Answer::yes;
  const LegSweep<Infinitesimal> exact(at, shape);
  const auto relative = [&](Point p) { return difference<Infinitesimal>(at.from.at, p); };
  return exact.met_by(relative(wall.wall.a), relative(wall.wall.b)) == Answer::yes;
}

bool PreparedLeg::may_leave(const Segment& opening, bool solid_left, const Leg& at) const {
  const LegGeometry<Rational> geometry(at);
  const Rational way = geometry.gear * geometry.t1;
  const Vec<Rational> from{Rational(at.from.at.x), Rational(at.from.at.y)}, tip = from + way * geometry.u;
  const Vec<Rational> a{Rational(opening.a.x), Rational(opening.a.y)}, d = difference<Rational>(opening.a, opening.b);
  const int side = sgn(cross(d, Vec<Rational>(tip - a)));
  const int solid = solid_left ? 1 : -1;
  return side == solid || orientation(opening.a, opening.b, at.from.at) == solid ||
         orientation(opening.a, opening.b, at.to.at) == solid;
}

}  // namespace taut::car::detail
