// All places that a disc gets to from one.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <taut/search/passage_index.h>

namespace taut {

struct DiscReach {
  /// Where the centre can get to. Outlines are those of FreeSpace with Footprint::disc(r): arcs are drawn by a 64-gon
  /// around the disc, so places in a rim of Footprint::kDiscExcess of the radius are left out. Which polygons are
  /// reached is exact: some hang together by ways that the 64-gon is too large for.
  std::vector<Polygon> places;
  double area = 0;        ///< of them
  double whole_area = 0;  ///< of all places in the world, reached or not
  /// Narrower than 2 r, with what is reached on one side and what is not on the other: the widest first. What lies
  /// behind walls alone has no gate.
  std::vector<std::uint32_t> gates;
};

/// Nothing when the disc cannot be at the start. Exact as disc_passage is, but for the outlines. O(n log n): the
/// inflated space is built. Precondition: 0 < r <= World::kLargest.
std::optional<DiscReach> disc_reach(const PassageIndex& index, Point start, double r);

/// The gates narrower than 2 r with, on one side, a face that a disc of radius r may get to from the place, and on the
/// other one that it does not: the widest first. O(n).
std::vector<std::uint32_t> closed_gates(const PassageIndex& index, const PassagePlace& start, double r);

}  // namespace taut
