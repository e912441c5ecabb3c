#include <taut/geometry/lattice_integers.h>

#include <cmath>

#include <taut/geometry/detail/written_integers.h>
#include <taut/geometry/errors.h>
#include <taut/geometry/exact/exact_point.h>
#include <taut/geometry/text.h>

namespace taut {

namespace {

Rational in_units(double v, const NumberLattice& lattice) {
  return meaning(v) * power(static_cast<unsigned>(lattice.base), static_cast<unsigned>(lattice.exponent));
}

NumberLattice lattice_of(const World& world) {
  const auto lattice = number_lattice(world);
  if (!lattice)
    throw InputError(world.source(), 0,
                     "its coordinates are no multiples of one unit (`taut check` says what they are); what is exact in "
                     "integers needs that");
  return *lattice;
}

}  // namespace

LatticeIntegers::LatticeIntegers(const World& world, std::span<const Point> places) : lattice_(lattice_of(world)) {
  Integer scale = 1;
  for (const Point p : places)
    for (const double v : {p.x, p.y}) {
      scale = lcm(scale, denominator(in_units(v, lattice_)));
      if (scale > kLargest) break;
    }
  const Box box = world.box();
  if (scale <= kLargest) scale_ = to_int64(scale);
  if (scale > kLargest || !place(box.min) || !place(box.max))
    throw InputError(world.source(), 0,
                     "start, goal and the world together need coordinates of more than 51 bits over one unit");
}

double LatticeIntegers::per_one() const {
  return static_cast<double>(scale_) * std::pow(static_cast<double>(lattice_.base), lattice_.exponent);
}

std::optional<LatticeIntegers::Place> LatticeIntegers::place(Point p) const {
  const auto x = integer(p.x), y = integer(p.y);
  if (!x || !y) return std::nullopt;
  return Place{*x, *y};
}

std::optional<std::int64_t> LatticeIntegers::integer(double v) const {
  const double most = static_cast<double>(kLargest) / static_cast<double>(scale_);
  if (lattice_.base == 10 && lattice_.exponent <= 22) {
    const double n = detail::integer_over(v, lattice_.exponent);
    if (std::abs(n) < most) return static_cast<std::int64_t>(n) * scale_;
  }
  if (lattice_.base == 2 && lattice_.exponent <= 6 && std::abs(v) < 0x1p29) {  // so short a number is the double
    const double n = std::ldexp(v, lattice_.exponent);
    if (n == std::floor(n) && std::abs(n) < most) return static_cast<std::int64_t>(n) * scale_;
  }
  const Rational n = in_units(v, lattice_) * taut::integer(scale_);
  if (denominator(n) != 1 || abs(n) >= kLargest) return std::nullopt;
  return to_int64(numerator(n));
}

}  // namespace taut
