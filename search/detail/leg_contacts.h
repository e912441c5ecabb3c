// All contacts of a path with a million constraints: an r-tree over the legs, the constraints streamed through it.
// Private.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <taut/geometry/box_index.h>
#include <taut/geometry/free_space.h>

namespace taut::detail {

/// Which constraints the legs of a path meet (see Contact).
struct LegContacts {
  std::vector<std::vector<std::uint32_t>> touching;  ///< for each leg, ascending
  std::vector<std::uint32_t> crossed;                ///< for each leg: the lowest constraint that it crosses, or kNone
};

/// The piece that a path comes nearest to.
struct NearestPiece {
  double distance = 0;               ///< to the nearest double; infinite when there are no constraints
  std::uint32_t constraint = kNone;  ///< the lowest index among equals
};

/// An r-tree over legs. Precondition: at least one leg, finite coordinates. The spans must outlive it.
class LegTree {
 public:
  LegTree(std::span<const Segment> legs, std::span<const Constraint> constraints);

  /// Exact. O(n log k + candidates) for n constraints and k legs.
  LegContacts contacts() const;

  /// Exact choice. Precondition: no leg meets a constraint. Expected O(n log k): constraints come in scattered order,
  /// so the best so far soon rules out all but a few.
  NearestPiece nearest() const;

 private:
  struct Candidate;
  bool closer(const Candidate& x, const Candidate& y) const;

  std::span<const Segment> legs_;
  std::span<const Constraint> constraints_;
  BoxIndex index_;
};

}  // namespace taut::detail
