// Driving along the arrows of value iteration.
#pragma once

#include <memory>

#include <taut/robots/roadblocks/replanning_driver.h>
#include <taut/robots/roadblocks/value_iteration.h>

namespace taut::roadblocks {

/// Plans with the closed roadblocks known: values on cells x 8 headings, then from state to state by the best action:
/// turning on the spot (steps -2, -2, -2, +-1) and going straight.
///
///  1. The car drifts off the cells' centres: straight steps are 0.15 long, and turns on the spot are not quite on it.
///     So each straight leg heads for the point where it ends, from where the car is (the control's last fraction makes
///     up for it), and the whole way is simulated and tested before it is driven. An action on which it would touch
///     something is taken away, and values are iterated again: no plan collides.
///  2. Half cells, not whole ones: in a lane whose walls are 3 apart the car has no room on a cell's
///     centre, and tests are exact here. Where they leave no way, quarters (jogs from lane to lane); where these leave
///     none, quarters with straight back (out of a lane where the car cannot turn).
///  3. No plan: `proven_none` only when not even a disc inside the car gets through; the discretisation knows no arcs,
///     so that otherwise it is merely out of its depth.
class ValuePlanner {
 public:
  ValuePlanner(const Course& course, WallReading reading,
               double turn_cost = ValueCosts{}.turn);  ///< `course` must outlive it
  ~ValuePlanner();
  ValuePlanner(const ValuePlanner&) = delete;
  ValuePlanner& operator=(const ValuePlanner&) = delete;

  Attempt plan(const Pose& from, RoadblockSet closed);

  /// What the last plan was made with. Null before any.
  const ValueGrid* grid() const;
  const Values* values() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace taut::roadblocks
