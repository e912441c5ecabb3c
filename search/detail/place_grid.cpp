#include <taut/search/detail/place_grid.h>

#include <algorithm>
#include <cmath>

#include <taut/geometry/exact/exact_point.h>

namespace taut::detail {

namespace {

using Int = std::int64_t;

constexpr int kMostFiner = 32;
constexpr double kLargest = 0x1p50;  // of coordinates

}  // namespace

PlaceGrid::PlaceGrid(const World& world, std::span<const Point> places) : integers_(world, places) {
  const Box box = world.box();
  double largest = 1;
  for (const double v : {box.min.x, box.min.y, box.max.x, box.max.y}) largest = std::max(largest, std::abs(v));
  const double multiples = largest * to_double(Rational(units()));
  while (finer_ < kMostFiner && multiples * std::ldexp(1, finer_ + 1) < kLargest) ++finer_;
}

Integer PlaceGrid::units() const {
  const auto base = static_cast<unsigned>(integers_.lattice().base),
             exponent = static_cast<unsigned>(integers_.lattice().exponent);
  return power(base, exponent) * integer(scale());
}

std::optional<PlaceGrid::Place> PlaceGrid::exactly(Point p) const {
  const auto place = integers_.place(p);
  if (!place) return std::nullopt;
  return Place{(*place)[0] << finer_, (*place)[1] << finer_};
}

std::int64_t PlaceGrid::down(const Rational& v) const {
  const Rational n = v * units();
  return to_int64(floor_of(n));
}

PlaceGrid::Place PlaceGrid::nearest(Point p) const { return {rounded(p.x), rounded(p.y)}; }

Point PlaceGrid::point(Place p) const {
  const double n = to_double(Rational(units()));
  return {static_cast<double>(p[0]) / n, static_cast<double>(p[1]) / n};
}

std::optional<PlaceGrid::Place> PlaceGrid::on(const Segment& piece, Point foot) const {
  const auto a = exactly(piece.a), b = exactly(piece.b);
  if (!a || !b) return std::nullopt;
  const Int x = ((*b)[0] - (*a)[0]) >> finer_, y = ((*b)[1] - (*a)[1]) >> finer_;
  if (x == 0 || y == 0) {  // every multiple is on it
    const Place p = nearest(foot);
    return x == 0 ? Place{(*a)[0], p[1]} : Place{p[0], (*a)[1]};
  }
  const double ux = piece.b.x - piece.a.x, uy = piece.b.y - piece.a.y;
  const double part = ((foot.x - piece.a.x) * ux + (foot.y - piece.a.y) * uy) / (ux * ux + uy * uy);
  const auto steps = static_cast<Int>(std::llround(std::ldexp(std::clamp(part, 0.0, 1.0), finer_)));
  return Place{(*a)[0] + x * steps, (*a)[1] + y * steps};
}

std::int64_t PlaceGrid::rounded(double v) const {
  const Rational n = meaning(v) * units() * 2 + 1;  // floor((2 v + 1) / 2)
  return to_int64(floor_of(Rational(n / 2)));
}

}  // namespace taut::detail
