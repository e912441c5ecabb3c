#include <taut/geometry/number_lattice.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <taut/geometry/detail/written_integers.h>
#include <taut/geometry/exact/exact_point.h>
#include <taut/geometry/text.h>
#include <taut/geometry/written.h>

namespace taut {

namespace {

constexpr double kLimit = 0x1p52;

std::vector<Point> points_of(const World& world) {
  std::vector<Point> points;
  for (const Wall& wall : world.walls()) points.insert(points.end(), {wall.a, wall.b});
  for (const auto* areas : {&world.areas(), &world.solids()})
    for (const Area& area : *areas) {
      points.insert(points.end(), area.polygon.outer.begin(), area.polygon.outer.end());
      for (const Ring& hole : area.polygon.holes) points.insert(points.end(), hole.begin(), hole.end());
    }
  return points;
}

constexpr int kMostPlaces = 22;  // of integer_over

/// The number of places after the point, in base 10 or 2, that differences of coordinates need.
class Places {
 public:
  explicit Places(int base) : base_(base) {}

  void add(double v) {
    if (v == std::floor(v) && std::abs(v) < 1e15) return;  // needs none
    if (base_ == 10) {
      // As many places as another number had are told at once.
      if (count_ <= kMostPlaces && !std::isnan(detail::integer_over(v, count_))) return;
      const auto d = written::decimal(v);
      if (!d && v != std::floor(v)) exists_ = false;
      if (d) count_ = std::max(count_, d->places);
      return;
    }
    // With so few digits a number means the double that it is.
    if (count_ <= 6 && std::abs(v) < 0x1p29 && v * (1 << count_) == std::floor(v * (1 << count_))) return;
    if (!written::is_plain(v)) exists_ = false;
    while (exists_ && std::ldexp(v, count_) != std::floor(std::ldexp(v, count_)))
      if (++count_ > 1100) exists_ = false;
  }

  std::optional<NumberLattice> lattice(const Box& box) const {
    const double size = std::max(box.max.x - box.min.x, box.max.y - box.min.y);
    const double largest = base_ == 10 ? size * std::pow(10, count_) : std::ldexp(size, count_);
    if (!exists_ || !(largest < kLimit)) return std::nullopt;
    return NumberLattice{base_, count_, box.min, largest};
  }

 private:
  int base_;
  int count_ = 0;
  bool exists_ = true;
};

}  // namespace

double NumberLattice::unit() const { return base == 10 ? written::number(1, exponent) : std::ldexp(1.0, -exponent); }

std::optional<NumberLattice> number_lattice(const World& world) {
  Places tenths(10), halves(2);
  for (const Point p : points_of(world))
    for (const double v : {p.x, p.y}) {
      tenths.add(v);
      halves.add(v);
    }
  const auto decimal = tenths.lattice(world.box()), binary = halves.lattice(world.box());
  if (!decimal || !binary) return decimal ? decimal : binary;
  return binary->largest < decimal->largest ? binary : decimal;
}

std::string text(const NumberLattice& lattice) {
  if (lattice.exponent == 0) return "integers";
  const std::string unit = text(lattice.unit());
  if (lattice.base == 2) return "binary fractions, " + (lattice.exponent < 53 ? "1/" + text(1 / lattice.unit()) : unit);
  constexpr const char* kMetric[] = {"", "1 dm", "1 cm", "1 mm"};
  if (lattice.exponent > 3) return "decimals, " + unit;
  return std::string("decimals, ") + kMetric[lattice.exponent] + " if the unit is a metre (" + unit + ")";
}

}  // namespace taut
