// The length of a polygonal chain, exactly: a sum of square roots.
#pragma once

#include <compare>
#include <cstddef>
#include <iosfwd>
#include <span>
#include <string>
#include <vector>

#include <taut/geometry/interval.h>
#include <taut/geometry/point.h>

namespace taut {

/// The Euclidean distance of p and q, enclosed; at most 2 ulp wide.
Interval distance_interval(Point p, Point q);

/// A sum of Euclidean distances between points with double coordinates, kept as the list of its terms.
///
///  1. interval() encloses the exact value; its width grows by about one ulp a term.
///  2. Comparison is exact: intervals first; where they overlap equal terms cancel, terms whose square roots are
///     rational multiples of each other are gathered (sqrt(a) / sqrt(b) is rational iff a * b is a square), and since
///     square roots of different classes are linearly independent over the rationals, the sums are equal iff every
///     class cancels; otherwise more digits (MPFR, doubled until it is decided) always separate them.
///  3. value() is the double nearest to the exact value, decimals(n) the nearest number with n >= 0 places; both round
///     ties to even (0.5 to no places is 0, 1.5 is 2, as printf does). Double-double first, MPFR on demand.
///
/// Precondition: coordinates are finite; the bounds hold from the least subnormal up to sums of 1e140.
class Length {
 public:
  Length() = default;
  /// Of the chain through these points, in order.
  explicit Length(std::span<const Point> chain);

  void add(Point p, Point q);
  Length& operator+=(const Length& other);

  const Interval& interval() const { return interval_; }
  double value() const;
  std::string decimals(int places) const;
  std::size_t terms() const { return legs_.size(); }

  friend std::strong_ordering operator<=>(const Length& a, const Length& b);
  friend bool operator==(const Length& a, const Length& b) { return (a <=> b) == 0; }

 private:
  std::vector<Segment> legs_;
  Interval interval_;
};

/// Compares the sums of the legs of a and b, exactly. What Length does, without building one.
std::strong_ordering compare_lengths(std::span<const Segment> a, std::span<const Segment> b);

}  // namespace taut
