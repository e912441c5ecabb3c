#include <taut/robots/pursuit/detail/meeting_time.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include <taut/geometry/exact/as_double.h>
#include <taut/robots/pursuit/detail/bend_tree.h>

namespace taut::pursuit::detail {

namespace {

Interval enclosure(const Rational& v) { return {as_double(v, Toward::down), as_double(v, Toward::up)}; }

/// Doubles of 0 and more, counted.
std::int64_t number_of(double v) { return std::bit_cast<std::int64_t>(v); }
double double_of(std::int64_t number) { return std::bit_cast<double>(number); }

}  // namespace

MeetingTime::MeetingTime(const LastBend& bend, const TargetLeg& leg, const Rational& speed)
    : bend_(bend),
      leg_(leg),
      speed_(speed),
      slope_(leg.vx * leg.vx + leg.vy * leg.vy - speed * speed),
      wx_(leg.at.x - leg.vx * leg.begins - bend.at.x),
      wy_(leg.at.y - leg.vy * leg.begins - bend.at.y),
      along_(wx_ * leg.vx + wy_ * leg.vy) {}

int MeetingTime::late(const Rational& time) const {
  const Rational square = squared_distance(leg_.place(time), bend_.at), gone = speed_ * time;
  const Interval apart{root_as_double(square, Toward::down), root_as_double(square, Toward::up)};
  if (const auto sure = sign(bend_.length + apart - enclosure(gone))) return *sure;
  std::vector<SignedRoot> sum = bend_.way;
  sum.push_back({square});
  sum.push_back(rational_term(Rational(-gone)));
  return sign_of_sum(sum);
}

double MeetingTime::wait(double time) const {
  const double apart = root_as_double(squared_distance(leg_.place(Rational(time)), bend_.at), Toward::nearest);
  return std::max(0.0, time - (bend_.length.middle() + apart) / to_double(speed_));
}

std::optional<Interval> MeetingTime::first(const Rational& from, const Rational& until) const {
  if (late(from) <= 0) return enclosure(from);
  if (late(until) > 0) return slope_ > 0 ? dip(from, until) : std::nullopt;
  return enclosed([&](const Rational& t) { return t >= until || (t > from && late(t) <= 0); });
}

// Late at both ends; a target faster than the robot may be met in between. late() = 0 squared is the quadratic
// slope t^2 + 2 (along + speed D) t + |w|^2 - D^2 = 0, D the length of the way. The root between its two is the middle.
std::optional<Interval> MeetingTime::dip(const Rational& from, const Rational& until) const {
  if (beyond_middle(from) >= 0 || beyond_middle(until) <= 0) return std::nullopt;
  // At the middle the robot has to be on its way from the bend already, not before it (speed t < D).
  if (linear(Rational(leg_.vx * leg_.vx + leg_.vy * leg_.vy), Rational(speed_ * along_)) > 0) return std::nullopt;
  const int two = discriminant();
  if (two < 0) return std::nullopt;
  if (two == 0) return enclosed([&](const Rational& t) { return beyond_middle(t) >= 0; });
  // A time between both roots: towards the middle, by halves, until one is met.
  Rational below = from, above = until, between = below;
  while (late(between) > 0) {
    between = (below + above) / 2;
    (beyond_middle(between) >= 0 ? above : below) = between;
  }
  return enclosed([&](const Rational& t) { return t >= between || (t > from && late(t) <= 0); });
}

/// The sign of time - middle: of slope t + along + speed D.
int MeetingTime::beyond_middle(const Rational& time) const { return linear(speed_, Rational(slope_ * time + along_)); }

/// The sign of factor D + rest. Precondition: factor >= 0.
int MeetingTime::linear(const Rational& factor, const Rational& rest) const {
  if (const auto sure = sign(enclosure(factor) * bend_.length + enclosure(rest))) return *sure;
  std::vector<SignedRoot> sum;
  for (const SignedRoot& r : bend_.way) sum.push_back({Rational(factor * factor * r.square), r.count});
  sum.push_back(rational_term(rest));
  return sign_of_sum(sum);
}

/// The sign of a quarter of it: |v|^2 D^2 + 2 speed along D + along^2 - slope |w|^2.
int MeetingTime::discriminant() const {
  const Rational square = leg_.vx * leg_.vx + leg_.vy * leg_.vy, twice = 2 * speed_ * along_,
                 rest = along_ * along_ - slope_ * (wx_ * wx_ + wy_ * wy_);
  const Interval d = bend_.length;
  if (const auto sure = sign(enclosure(square) * (d * d) + enclosure(twice) * d + enclosure(rest))) return *sure;
  std::vector<SignedRoot> sum{rational_term(rest)};
  for (const SignedRoot& r : bend_.way) {
    sum.push_back({Rational(twice * twice * r.square), sgn(twice)});
    for (const SignedRoot& q : bend_.way) sum.push_back({Rational(square * square * r.square * q.square)});
  }
  return sign_of_sum(sum);
}

/// The first root, in doubles: where to look first.
double MeetingTime::guess() const {
  const double a = to_double(slope_), d = bend_.length.middle(), half = to_double(along_) + to_double(speed_) * d,
               c = to_double(Rational(wx_ * wx_ + wy_ * wy_)) - d * d;
  const double part = std::sqrt(std::max(0.0, half * half - a * c));
  const double t = half < 0 ? c / (-half + part) : a != 0 ? (-half - part) / a : -c / (2 * half);
  return std::isfinite(t) && t > 0 ? t : 0;
}

/// The least double for which `reached` is true, and the one before unless the root is that double. Precondition:
/// reached is true for the times of 0 and more from the root on.
template <class Reached>
Interval MeetingTime::enclosed(Reached reached) const {
  const auto holds = [&](std::int64_t n) { return reached(Rational(double_of(n))); };
  const std::int64_t last = number_of(std::numeric_limits<double>::max()), start = number_of(guess());
  std::int64_t below = start, above = start;
  for (std::int64_t step = 1; below >= 0 && holds(below); step *= 4) {
    above = below;
    below = below - step;
  }
  below = std::max<std::int64_t>(below, -1);
  for (std::int64_t step = 1; above <= below || !holds(above); step *= 4) {
    below = std::max(above, below);
    above = std::min(last - step, std::max(above, below)) + step;
  }
  while (above - below > 1) {
    const std::int64_t middle = below + (above - below) / 2;
    (holds(middle) ? above : below) = middle;
  }
  const double hi = double_of(above);
  const bool exact = late(Rational(hi)) == 0;
  return {exact || above == 0 ? hi : double_of(above - 1), hi};
}

}  // namespace taut::pursuit::detail
