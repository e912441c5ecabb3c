// The car: how a control moves it and what it touches.
#pragma once

#include <array>
#include <cstdint>

#include <taut/geometry/grid_maze.h>
#include <taut/geometry/point.h>
#include <taut/robots/car/pose.h>

namespace taut::roadblocks {

using car::Pose;

inline constexpr double kHalfLength = 1.5;
inline constexpr double kHalfWidth = 1.0;
inline constexpr double kForward = 0.15;       ///< length of a forward step
inline constexpr double kBackward = 0.05;      ///< length of a reverse step
inline constexpr double kTurn = 0.05;          ///< change of heading at control 1, radians
inline constexpr double kSight = 5.0;          ///< cells at most this far from the centre are seen
inline constexpr double kReverse = -2.0;       ///< the control that goes back
inline constexpr int kLongestDrive = 100'000;  ///< steps

/// The pose after a step. A control in [-1, 1] is an arc of length kForward that turns by kTurn * control; kReverse
/// goes straight back; any other value, NaN included, changes nothing.
Pose stepped(const Pose& from, double control);

/// Is the point in or on the car's rectangle? `slack` widens the rectangle on all sides, a negative one shrinks it.
bool covers(const Pose& pose, Point p, double slack = 0);

/// The corners: front right, front left, rear left, rear right, where left is the side of +90 degrees.
std::array<Point, 4> corners(const Pose& pose);

/// What a closed cell is, and when the car meets it.
enum class WallReading : std::uint8_t {
  points,  ///< the cell's centre point, in or on the rectangle at the end of a step
  squares  ///< the closed unit square around it, touched anywhere on the step: the physical one
};

/// Does the car standing there touch the closed cell? `slack` as in covers().
bool touches(const Pose& pose, Cell cell, WallReading reading, double slack = 0);

/// Does a step from a pose that does not touch the cell end in (points), or pass through or end in (squares) a pose
/// that does? The sweep is found in closed form, not by samples: a car meets a square iff it touches it at the end, one
/// of its corners crosses a side of the square on its arc, or a corner of the square, moved backwards around the same
/// centre, crosses a side of the car. Evaluated in doubles with the rectangle widened by `slack`: with slack 1e-9
/// rounding cannot hide a contact.
bool meets(const Pose& from, double control, Cell cell, WallReading reading, double slack = 0);

/// The same step asked about many cells: most are told to be out of its reach without a root or a sine.
class Step {
 public:
  Step(const Pose& from, double control);
  bool meets(Cell cell, WallReading reading, double slack = 0) const;

 private:
  bool is_out_of_reach(Cell cell, double slack) const;

  Pose from_;
  double control_;
  Point middle_;  ///< about half-way
  Point ahead_;   ///< the heading there
};

}  // namespace taut::roadblocks
