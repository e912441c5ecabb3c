// The legs of discs of all radii, each with the radii for which it can be followed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include <taut/roadmaps/tangent_graph.h>

namespace taut {

/// Radii between two doubles, both included.
struct RadiusSpan {
  double from = 0, to = 0;
  /// The leg is free for all of them; else it begins or ends to be somewhere among them, or runs near an opening, and a
  /// radius is asked about exactly when it comes.
  bool certain = false;

  friend bool operator==(const RadiusSpan&, const RadiusSpan&) = default;
};

/// A common tangent of the circles around two corners, by the sides that it has them on (+1 left, -1 right; 0 through a
/// corner of openings).
struct RadiiLeg {
  Point from, to;
  int from_side = 0, to_side = 0;
  std::vector<RadiusSpan> spans{};  ///< ascending; for all other radii (from least_radius() on) the leg is not free
};

struct AllRadiiParts;

/// TangentGraph for every radius at once.
///
///  1. at_radius(r) is TangentGraph(space, r): the same legs, tangent points and arcs, in the same order. What was
///     found once for all radii is not looked for again: which corners may be joined, by which tangents, what is near.
///  2. A tangent that has both circles on one side (outer) is free up to some radius; one that crosses between them
///     (inner) on several spans (docs/all-radii.md). Where a span ends is enclosed by two doubles; between them, and
///     wherever doubles cannot tell, the radius is decided exactly, as TangentGraph decides it.
///  3. Below least_radius(), a small part of the world's size, and above some times that size graphs are built in the
///     plain way.
///  4. Same space, same index. Immutable; to be asked from several threads.
/// Source: spans by bisection with the Lipschitz constant of a tangent's motion (Piyavskii, 1972; Shubert, 1972), ours.
/// Built in O(k (log n + 1 / precision)) for k pairs of corners that legs of some radius may join; at_radius: linear in
/// these legs, but for sorting around circles. bench/all_radii_bench.cpp.
/// Precondition: the space's footprint is Footprint::point().
class AllRadii {
 public:
  /// Told are the corners whose legs are found.
  explicit AllRadii(const FreeSpace& space, const TellProgress& tell = {});
  explicit AllRadii(std::shared_ptr<const AllRadiiParts> parts) : parts_(std::move(parts)) {}

  const FreeSpace& space() const;

  /// Precondition: 0 < r <= World::kLargest.
  TangentGraph at_radius(double r) const;

  double least_radius() const;
  std::size_t corner_count() const;
  std::size_t leg_count() const;  ///< legs that are or may be free for some radius
  std::size_t span_count() const;
  RadiiLeg leg(std::size_t i) const;

  /// What is kept, for files (roadmaps/exact/all_radii_parts.h).
  const AllRadiiParts& parts() const { return *parts_; }

 private:
  std::shared_ptr<const AllRadiiParts> parts_;
};

}  // namespace taut
