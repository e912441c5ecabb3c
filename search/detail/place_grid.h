// A finer grid over the lattice of a world. Private.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include <taut/geometry/exact/numbers.h>

#include <taut/geometry/lattice_integers.h>
#include <taut/geometry/point.h>
#include <taut/geometry/world.h>

namespace taut::detail {

/// Multiples of the world's unit / scale, halved as often as leaves coordinates below 2^50, 32 times at most.
class PlaceGrid {
 public:
  using Place = LatticeIntegers::Place;

  /// `places` are on it exactly. Throws InputError as LatticeIntegers does.
  PlaceGrid(const World& world, std::span<const Point> places);

  std::int64_t scale() const { return integers_.scale() << finer_; }

  /// What the point means, where that is on the unhalved grid.
  std::optional<Place> exactly(Point p) const;
  Place nearest(Point p) const;
  Point point(Place p) const;  ///< to rounding
  /// A length that is not negative, rounded down.
  std::int64_t down(const Rational& length) const;
  /// On the piece, whose ends are on the unhalved grid: the nearest of 2^finer parts to `foot`, of a piece along an
  /// axis the nearest multiple.
  std::optional<Place> on(const Segment& piece, Point foot) const;

 private:
  Integer units() const;  // so many make 1
  std::int64_t rounded(double v) const;

  LatticeIntegers integers_;
  int finer_ = 0;
};

}  // namespace taut::detail
