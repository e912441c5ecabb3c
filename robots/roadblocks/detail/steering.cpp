#include <taut/robots/roadblocks/detail/steering.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <optional>

namespace taut::roadblocks::detail {

namespace {

using Complex = std::complex<double>;

constexpr double kCircle = 2 * std::numbers::pi;
constexpr double kNothing = 1e-9;      // an angle not worth a step
constexpr double kLongestTurn = 4.72;  // three quarters of a circle
constexpr int kRounds = 8;             // of the fixed point below
constexpr double kSettled = 1e-4;      // it has come to rest: what is left is part of the error
constexpr int kSpotBack = 3;           // steps back of a turn on the spot

int whole_steps(double angle) { return static_cast<int>((std::abs(angle) + kNothing) / kTurn); }

double fraction(double angle) {
  const double rest = angle - std::copysign(whole_steps(angle) * kTurn, angle);
  return std::abs(rest) < kNothing ? 0 : rest;
}

/// The shift of one step of arc.
Complex arc_shift(double heading, double turn) {
  const Pose end = stepped({0, 0, heading}, turn / kTurn);
  return {end.x, end.y};
}

Complex spot_shift(double heading, double turn) { return arc_shift(heading, turn) - std::polar(kForward, heading); }

/// Of `n` whole steps: geometric series, since each shift is the one before, turned.
Complex series_shift(double heading, int n, double turn, bool on_the_spot) {
  const auto series = [](Complex first, int terms, double by) {
    return terms == 0 ? Complex(0) : first * (std::polar(1.0, terms * by) - 1.0) / (std::polar(1.0, by) - 1.0);
  };
  if (n == 0) return 0;
  if (!on_the_spot) return series(arc_shift(heading, turn), n, turn);
  const Complex pair =
      spot_shift(heading, turn) + arc_shift(heading + turn, turn) - std::polar(kForward, heading + 2 * turn);
  return series(pair, n / 2, 2 * turn) + (n % 2 == 0 ? Complex(0) : spot_shift(heading + (n - 1) * turn, turn));
}

Complex shift_of(const Turn& turn, double heading) {
  const double step = std::copysign(kTurn, turn.angle), rest = fraction(turn.angle);
  const int n = whole_steps(turn.angle);
  const auto fraction_shift = [&](double from) {
    if (rest == 0) return Complex(0);
    return turn.on_the_spot ? spot_shift(from, rest) : arc_shift(from, rest);
  };
  if (turn.fraction_first) return fraction_shift(heading) + series_shift(heading + rest, n, step, turn.on_the_spot);
  return series_shift(heading, n, step, turn.on_the_spot) + fraction_shift(heading + n * step);
}

enum class Kind : std::uint8_t { left, right, spot };
constexpr Kind kKinds[] = {Kind::left, Kind::right, Kind::spot};

Turn turn_of(Kind kind, double by, bool fraction_first) {
  double angle = std::remainder(by, kCircle);
  if (std::abs(angle) < kNothing) angle = 0;
  if (kind == Kind::left && angle < 0) angle += kCircle;
  if (kind == Kind::right && angle > 0) angle -= kCircle;
  return {angle, kind == Kind::spot, fraction_first};
}

/// The straight's direction has to fit the turns and the turns the direction: a fixed point, found by iteration or not
/// at all.
std::optional<Steering> steering(const Pose& from, const Pose& to, Kind first, Kind last, bool backwards) {
  const Complex between(to.x - from.x, to.y - from.y);
  double heading = std::arg(backwards ? -between : between);
  Steering way;
  Complex straight;
  for (int i = 0; i < kRounds; ++i) {
    way.first = turn_of(first, heading - from.heading, false);
    way.last = turn_of(last, to.heading - heading, true);
    straight = between - shift_of(way.first, from.heading) - shift_of(way.last, heading);
    const double next = std::arg(backwards ? -straight : straight);
    if (std::abs(straight) < kBackward / 2 || std::abs(std::remainder(next - heading, kCircle)) < kSettled) break;
    if (i + 1 < kRounds) heading = next;
  }
  const double along = (straight * std::polar(1.0, -heading)).real();
  const auto units = static_cast<int>(std::lround(along / kBackward));
  if (backwards ? units >= 0 : units < 0) return std::nullopt;
  if (std::max(std::abs(way.first.angle), std::abs(way.last.angle)) > kLongestTurn) return std::nullopt;
  way.ahead = backwards ? 0 : (units + 2) / 3;
  way.back = backwards ? -units : 3 * way.ahead - units;
  way.error = std::abs(straight - units * kBackward * std::polar(1.0, heading));
  return way.error <= kLanding ? std::optional(way) : std::nullopt;
}

}  // namespace

int Turn::steps() const { return (whole_steps(angle) + (fraction(angle) != 0)) * (on_the_spot ? kSpotBack + 1 : 1); }

Point Turn::shift(double heading) const {
  const Complex by = shift_of(*this, heading);
  return {by.real(), by.imag()};
}

void Turn::append_to(std::vector<double>& controls) const {
  const auto step = [&](double control, bool back_first) {
    if (on_the_spot && back_first) controls.insert(controls.end(), kSpotBack, kReverse);
    controls.push_back(control);
    if (on_the_spot && !back_first) controls.insert(controls.end(), kSpotBack, kReverse);
  };
  const double rest = std::clamp(fraction(angle) / kTurn, -1.0, 1.0);
  if (rest != 0 && fraction_first) step(rest, true);
  for (int i = 0; i < whole_steps(angle); ++i) step(std::copysign(1.0, angle), i % 2 == 0);
  if (rest != 0 && !fraction_first) step(rest, true);
}

std::vector<double> Steering::controls() const {
  std::vector<double> all;
  first.append_to(all);
  all.insert(all.end(), static_cast<std::size_t>(ahead), 0.0);
  all.insert(all.end(), static_cast<std::size_t>(back), kReverse);
  last.append_to(all);
  return all;
}

std::vector<Steering> steerings(const Pose& from, const Pose& to) {
  std::vector<Steering> ways;
  for (const bool backwards : {false, true})
    for (const Kind first : kKinds)
      for (const Kind last : kKinds)
        if (const auto way = steering(from, to, first, last, backwards)) ways.push_back(*way);
  std::ranges::stable_sort(ways, {}, &Steering::steps);
  return ways;
}

Pose unstepped(const Pose& to, double control) {
  const double turn = control == kReverse ? 0 : kTurn * control;
  const Pose end = stepped({0, 0, to.heading - turn}, control);
  return {to.x - end.x, to.y - end.y, to.heading - turn};
}

}  // namespace taut::roadblocks::detail
