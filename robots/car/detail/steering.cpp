#include <taut/robots/car/detail/steering.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <optional>

namespace taut::car::detail {

namespace {

using Complex = std::complex<double>;

constexpr double kCircle = 2 * std::numbers::pi;
constexpr double kNothing = 1e-9;      // an angle not worth a step
constexpr double kLongestTurn = 4.72;  // three quarters of a circle
constexpr int kRounds = 12;            // of the fixed point below
constexpr int kSpotBack = 3;           // steps back of a turn on the spot

int whole_steps(double angle) { return static_cast<int>((std::abs(angle) + kNothing) / kTurn); }

double fraction(double angle) {
  const double rest = angle - std::copysign(whole_steps(angle) * kTurn, angle);
  return std::abs(rest) < kNothing ? 0 : rest;
}

/// The shift of one step, with what goes before it on the spot.
Complex step_shift(double heading, double turn, bool on_the_spot) {
  if (turn == 0) return 0;
  const Pose end = stepped({0, 0, heading}, turn / kTurn);
  return Complex(end.x, end.y) - (on_the_spot ? std::polar(kForward, heading) : Complex(0));
}

/// Of `n` such steps, each turned by the one before: a geometric series.
Complex series_shift(double heading, int n, double turn, bool on_the_spot) {
  if (n == 0) return 0;
  return step_shift(heading, turn, on_the_spot) * (std::polar(1.0, n * turn) - 1.0) / (std::polar(1.0, turn) - 1.0);
}

Complex shift_of(const Turn& turn, double heading) {
  const double step = std::copysign(kTurn, turn.angle), rest = fraction(turn.angle);
  const int n = whole_steps(turn.angle);
  if (turn.fraction_first)
    return step_shift(heading, rest, turn.on_the_spot) + series_shift(heading + rest, n, step, turn.on_the_spot);
  return series_shift(heading, n, step, turn.on_the_spot) + step_shift(heading + n * step, rest, turn.on_the_spot);
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

/// The straight's direction has to fit the turns and the turns the direction: a fixed point, found by iteration or not at all.
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
    if (std::abs(straight) < kBackward / 2 || std::abs(std::remainder(next - heading, kCircle)) < kNothing) break;
    if (i + 1 < kRounds) heading = next;
  }
  const double along = (straight * std::polar(1.0, -heading)).real();
  const auto units = static_cast<int>(std::lround(along / kBackward));
  if (backwards ? units >= 0 : units < 0) return std::nullopt;
  if (std::max(std::abs(way.first.angle), std::abs(way.last.angle)) > kLongestTurn) return std::nullopt;
  way.ahead = backwards ? 0 : (units + 2) / 3;
  way.back = backwards ? -units : 3 * way.ahead - units;
  way.error = std::abs(straight - std::polar(units * kBackward, heading));
  return way.error <= kLanding ? std::optional(way) : std::nullopt;
}

}  // namespace

int Turn::steps() const { return (whole_steps(angle) + (fraction(angle) != 0)) * (on_the_spot ? kSpotBack + 1 : 1); }

Point Turn::shift(double heading) const {
  const Complex by = shift_of(*this, heading);
  return {by.real(), by.imag()};
}

void Turn::append_to(std::vector<double>& controls) const {
  const auto step = [&](double control) {
    if (on_the_spot) controls.insert(controls.end(), kSpotBack, kReverse);
    controls.push_back(control);
  };
  const double rest = std::clamp(fraction(angle) / kTurn, -1.0, 1.0);
  if (rest != 0 && fraction_first) step(rest);
  for (int i = whole_steps(angle); i > 0; --i) step(std::copysign(1.0, angle));
  if (rest != 0 && !fraction_first) step(rest);
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

}  // namespace taut::car::detail
