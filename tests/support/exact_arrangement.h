// Shortest paths among thin walls by an exact rational arrangement: a second opinion that shares no code with the product.
#pragma once
#include <taut/geometry/exact/numbers.h>

#include <optional>
#include <vector>

#include <taut/geometry/point.h>

namespace taut::test {

struct RationalPoint {
  Rational x, y;

  friend bool operator==(const RationalPoint& p, const RationalPoint& q) { return p.x == q.x && p.y == q.y; }
  friend bool operator<(const RationalPoint& p, const RationalPoint& q) { return p.x != q.x ? p.x < q.x : p.y < q.y; }
};

struct RationalWall {
  RationalPoint a, b;
};

/// The length of the shortest path (docs/definitions.md, 2) in the closed box [0, width] x [0, height] between two
/// points in it, among walls of no thickness in it. Walls are not split: what a leg meets, and on which side, is decided
/// at each point where it touches one. Nothing when there is no path. O(n^4) or so.
std::optional<double> arrangement_path(const Rational& width, const Rational& height,
                                       const std::vector<RationalWall>& walls, const RationalPoint& start,
                                       const RationalPoint& goal);

}  // namespace taut::test
