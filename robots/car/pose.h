// Where a car is.
#pragma once

namespace taut::car {

/// Where the car is: its centre, and its heading in radians, positive from +x to +y (clockwise in a picture whose rows
/// go down). Not reduced.
struct Pose {
  double x = 0;
  double y = 0;
  double heading = 0;
  friend bool operator==(const Pose&, const Pose&) = default;
};

}  // namespace taut::car
