#include <taut/robots/car/leg.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <taut/geometry/errors.h>
#include <taut/geometry/text.h>
#include <taut/robots/car/detail/leg_geometry.h>

namespace taut::car {

namespace {

using detail::LegGeometry;

void require(bool fine, const char* what, double value) {
  if (!fine) throw InputError({}, 0, "the car's " + std::string(what) + " cannot be " + taut::text(value));
}

bool sensible(double v) { return v >= 1e-9 && v <= 1e9; }

/// a - b, rounded up.
double difference_up(double a, double b) {
  const double d = a - b;
  return Rational(d) < Rational(a) - Rational(b) ? std::nextafter(d, std::numeric_limits<double>::infinity()) : d;
}

}  // namespace

double CarShape::inner_radius() const { return std::min({front, back, half_width}); }

double CarShape::outer_radius() const { return std::hypot(std::max(front, back), half_width) * (1 + 1e-15); }

CarShape car_shape(double length, double width, double radius, double rear, bool reverse) {
  require(sensible(length), "length", length);
  require(sensible(width), "width", width);
  require(sensible(radius), "radius", radius);
  require(rear == 0 || (sensible(rear) && rear <= length), "rear", rear);
  return {difference_up(length, rear), rear, width / 2, radius, reverse};
}

double LegCurve::length() const { return before + radius * std::abs(turn) + after; }

std::optional<std::string> validate(const Leg& leg, const CarShape& shape) {
  if (leg.backward && !shape.reverse) return "goes back, which this car cannot";
  const auto is_heading = [](int h) { return h >= 0 && h < kHeadings; };
  if (!is_heading(leg.from.heading) || !is_heading(leg.to.heading)) return "has a heading that is none";
  const detail::Turn turn(leg.from.heading, leg.to.heading);
  if (turn.sine == 0 && turn.cosine < 0) return "turns by 180 degrees";
  const LegGeometry<Rational> geometry(leg);
  if (geometry.sense == 0) {
    if (detail::cross(geometry.to, geometry.u) != 0) return "is straight, but not along its heading";
    return sgn(geometry.t1) < 0 ? std::optional<std::string>("goes against its own direction") : std::nullopt;
  }
  if (sgn(geometry.t1) < 0 || sgn(geometry.t2) < 0) return "goes against its own direction";
  if (geometry.radius < Rational(shape.radius))
    return "bends with radius " + taut::text(to_double(geometry.radius)) + ", below the least one";
  return std::nullopt;
}

LegCurve curve_of(const Leg& leg) {
  const LegGeometry<detail::Approx> geometry(leg);
  if (geometry.sense == 0) return {std::max(geometry.before.v, 0.0), 0, 0, 0};
  const detail::Turn turn(leg.from.heading, leg.to.heading);
  return {geometry.before.v, geometry.radius.v,
          std::atan2(static_cast<double>(turn.sine), static_cast<double>(turn.cosine)), geometry.after.v};
}

std::size_t reversals_of(const std::vector<Leg>& legs) {
  std::size_t count = 0;
  for (std::size_t i = 1; i < legs.size(); ++i) count += legs[i].backward != legs[i - 1].backward ? 1U : 0U;
  return count;
}

Pose pose_on(const Leg& leg, double along) {
  const double start = heading_angle(leg.from.heading), gear = leg.backward ? -1 : 1;
  if (along <= 0) return {leg.from.at.x, leg.from.at.y, start};
  const LegCurve curve = curve_of(leg);
  double left = std::min(along, 1.0) * curve.length();
  Pose pose{leg.from.at.x, leg.from.at.y, start};
  const auto straight = [&](double way) {
    pose.x += gear * way * std::cos(pose.heading);
    pose.y += gear * way * std::sin(pose.heading);
  };
  const double first = std::min(left, curve.before);
  straight(first);
  left -= first;
  if (curve.turn != 0 && left > 0) {
    const double arc = curve.radius * std::abs(curve.turn), part = std::min(left, arc);
    const double bend = curve.turn * (arc > 0 ? part / arc : 0), middle = pose.heading + bend / 2;
    const double chord = 2 * curve.radius * std::sin(std::abs(bend) / 2) * gear;
    pose = {pose.x + chord * std::cos(middle), pose.y + chord * std::sin(middle), pose.heading + bend};
    left -= part;
    if (left > 0) straight(left);
  }
  if (along >= 1) return {leg.to.at.x, leg.to.at.y, pose.heading};
  return pose;
}

}  // namespace taut::car
