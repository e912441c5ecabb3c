// Exact constructions and their rounding, for the few places that need a point that is no input.
#pragma once

#include <taut/geometry/exact/numbers.h>

#include <optional>
#include <span>

#include <taut/geometry/errors.h>
#include <taut/geometry/point.h>

namespace taut {

/// What a number means (written.h), exactly.
Rational meaning(double v);

/// A point with rational coordinates.
struct ExactPoint {
  Rational x;
  Rational y;

  /// What the point means.
  explicit ExactPoint(Point p) : x(meaning(p.x)), y(meaning(p.y)) {}
  ExactPoint(Rational abscissa, Rational ordinate) : x(std::move(abscissa)), y(std::move(ordinate)) {}

  friend bool operator==(const ExactPoint& a, const ExactPoint& b) { return a.x == b.x && a.y == b.y; }
  friend bool operator<(const ExactPoint& a, const ExactPoint& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; }
};

/// Where constructed points are put: on multiples of a power of ten, so fine that coordinates up to `largest` keep 15
/// significant digits. Such a point means what is printed of it.
class DecimalUnit {
 public:
  explicit DecimalUnit(double largest);
  explicit DecimalUnit(const Box& box);

  /// The multiple nearest to q; the nearest double where q is too large to have 15 digits left.
  double nearest(const Rational& q) const;
  Point nearest(const ExactPoint& p) const { return {nearest(p.x), nearest(p.y)}; }
  /// `steps` multiples from a rounded coordinate.
  double step(double from, int steps) const;
  int places() const { return places_; }

 private:
  int places_ = 0;
};

/// Where the lines through s and t meet. Precondition: they are not parallel.
ExactPoint line_crossing(const Segment& s, const Segment& t);

/// The double nearest to q; of two equally near ones the one nearer to zero.
double nearest_double(const Rational& q);

/// Both coordinates rounded to the nearest doubles.
Point nearest_point(const ExactPoint& p);

/// The point that means p, when there is one.
std::optional<Point> exactly(const ExactPoint& p);

/// An upper bound of the distance between an exact point and its rounding.
double displacement(const ExactPoint& exact, Point rounded);

/// A point near `exact`, not to the left of any of `edges` (directed, solid on the left; `exact` lies on all of them):
/// what is solid stays so. The nearest of the 25 multiples of the unit around it that does; failing that, of the 25
/// pairs of doubles; failing that, the first found going out along the middle of the free wedge. Precondition: the
/// edges leave a free wedge at `exact`. Throws TooFine when no double lies in it within a thousandth of the shortest
/// edge.
Point round_outward(const ExactPoint& exact, std::span<const Segment> edges, const DecimalUnit& unit);

/// round_outward, but where no double lies in the wedge: the nearest multiple of the unit. What is solid may shrink
/// there by its displacement.
Point round_outward_or_nearest(const ExactPoint& exact, std::span<const Segment> edges, const DecimalUnit& unit);

}  // namespace taut
