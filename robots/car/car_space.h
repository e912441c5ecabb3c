// Where a general car can stand and drive, exactly.
#pragma once

#include <memory>

#include <taut/geometry/free_space.h>
#include <taut/robots/car/leg.h>

namespace taut::car {

namespace detail {
class PreparedLeg;
struct NearWall;
class DriveSearch;
}  // namespace detail

/// A car among the walls of a world.
///
///  1. The car is its open rectangle: it may touch walls, not enter them. Walls are the constraints of a point robot's
///     free space (zero-thickness walls, and the outlines of what is solid) that are no openings. The car may stick out
///     of an opening of the world; its reference point stays inside. What stands outside of the world is not seen.
///  2. A leg is free iff the interior of the car meets no wall on the whole way: exact, without sampling. A straight
///     piece sweeps a rectangle. An arc: LegSweep. Signs are decided by doubles with a running error bound; where they
///     are not sure, by rationals, the sides moved inwards by an infinitesimal.
///  3. Near openings legs are refused that stay inside but whose tangents meet beyond the opening's line.
/// Immutable; safe to ask from several threads.
class CarSpace {
 public:
  /// Precondition: the space's footprint is Footprint::point().
  CarSpace(const FreeSpace& space, const CarShape& shape);
  ~CarSpace();
  CarSpace(CarSpace&&) noexcept;
  CarSpace& operator=(CarSpace&&) noexcept;

  const FreeSpace& space() const;
  const CarShape& shape() const;

  /// Can the car stand there? O(log n + walls near).
  bool is_free(const LatticePose& pose) const;
  /// Can it drive this leg? Precondition: it can stand at its beginning, and validate(leg, shape()) is nothing.
  bool is_clear(const Leg& leg) const;

 private:
  friend class detail::DriveSearch;
  struct Impl;

  std::unique_ptr<const Impl> impl_;
};

}  // namespace taut::car
