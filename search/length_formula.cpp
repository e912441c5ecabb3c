#include <taut/search/length_formula.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

namespace taut {

namespace {

double turned(const LengthFormula::Turning& leg, double r) { return std::asin(std::min(1.0, leg.k * r / leg.d)); }

/// From one direction to another, to the side, as nearly as possible by `about`.
double angle_between(Point in, Point out, int side, double about) {
  const double angle = side * std::atan2(in.x * out.y - in.y * out.x, in.x * out.x + in.y * out.y);
  constexpr double kAround = 2 * std::numbers::pi;
  return angle + kAround * std::round((about - angle) / kAround);
}

}  // namespace

double LengthFormula::operator()(double r) const {
  double sum = constant + angle * r;
  for (const Turning& leg : legs) {
    const double x = std::min(leg.k * r, leg.d);
    sum += std::sqrt((leg.d - x) * (leg.d + x)) + leg.k * r * turned(leg, r);
  }
  return sum;
}

double LengthFormula::slope(double r) const {
  double sum = angle;
  for (const Turning& leg : legs) sum += leg.k * turned(leg, r);
  return sum;
}

std::pair<LengthFormula, LengthFormula> LengthFormula::apart(const LengthFormula& a, const LengthFormula& b) {
  LengthFormula x{a.constant, a.angle, {}}, y{b.constant, b.angle, {}};
  std::ranges::set_difference(a.legs, b.legs, std::back_inserter(x.legs));
  std::ranges::set_difference(b.legs, a.legs, std::back_inserter(y.legs));
  return {std::move(x), std::move(y)};
}

LengthFormula length_formula(const ArcPath& path) {
  LengthFormula formula;
  std::vector<double> sweeps;
  for (const ArcPiece& piece : pieces(path))
    if (piece.turn != 0) sweeps.push_back(piece.sweep);
  std::vector<ArcBend> stops = path.bends;
  stops.insert(stops.begin(), {path.start, 0});
  stops.push_back({path.goal, 0});
  Point before;
  double turned_before = 0;
  std::size_t arc = 0;
  for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
    const ArcBend &from = stops[i], &to = stops[i + 1];
    const Point along{to.corner.x - from.corner.x, to.corner.y - from.corner.y};
    const LengthFormula::Turning leg{std::hypot(along.x, along.y), double(std::abs(to.turn - from.turn))};
    const double tilt = leg.k == 0 ? 0 : turned(leg, path.radius);
    if (from.turn != 0) formula.angle += angle_between(before, along, from.turn, sweeps[arc++] - turned_before - tilt);
    if (leg.k == 0)
      formula.constant += leg.d;
    else
      formula.legs.push_back(leg);
    before = along;
    turned_before = tilt;
  }
  std::ranges::sort(formula.legs);
  return formula;
}

}  // namespace taut
