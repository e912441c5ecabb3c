// How fast a mouse is: what a speed run is timed by.
#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace taut::micromouse {

/// Along a straight. m/s^2 and m/s, all > 0.
struct Ramp {
  double acceleration = 0;
  double deceleration = 0;
  double top_speed = 0;
  friend bool operator==(const Ramp&, const Ramp&) = default;
};

/// Smooth turns, each one shape that is driven at one speed. In half cells, u a unit ahead and v one to the side:
///  small_90     from the middle of a wall to the middle of the next one of the same cell; quarter circle of radius 1
///  large_90     from the middle of a cell to that of the cell 2 u + 2 v away; quarter circle of radius 2
///  turn_45      from the middle of a cell onto a diagonal, at the wall 2 u + v away; or back from it
///  turn_135     likewise, onto the diagonal that leads back
///  turn_180     from the middle of a cell to that of the neighbour 2 v away, around the post; half circle of radius 1
///  diagonal_90  from one diagonal to the other, across the wall ahead; quarter circle of radius sqrt 2
enum class Turn { small_90, large_90, turn_45, turn_135, turn_180, diagonal_90 };
inline constexpr std::size_t kTurns = 6;
inline constexpr std::array<Turn, kTurns> kAllTurns{Turn::small_90, Turn::large_90, Turn::turn_45,
                                                    Turn::turn_135, Turn::turn_180, Turn::diagonal_90};

/// `small-90` and so on.
std::string_view name(Turn turn);

/// The length of its middle line in half cells.
double length(Turn turn);

/// How a turn is driven.
struct Pace {
  double speed = 0;            ///< m/s, on entering, in the turn and on leaving
  std::optional<double> time;  ///< s; absent: length / speed
  friend bool operator==(const Pace&, const Pace&) = default;
};

/// The default is a mouse of the classic contest in good shape: about 12 m/s^2 sideways (9 in the small turn, where one
/// follows the other), 10 m/s^2 along. data/mouse_speed.json says the same.
struct SpeedModel {
  double cell = 0.18;  ///< m
  Ramp straight{10, 10, 4};
  Ramp diagonal{8, 8, 3};
  std::array<Pace, kTurns> turns{{{0.9, {}}, {1.4, {}}, {1.6, {}}, {0.8, {}}, {1.05, {}}, {1.2, {}}}};
  double pivot_90 = 0.25;   ///< s, on the spot, standing in the middle of a cell
  double pivot_180 = 0.35;  ///< s

  const Pace& pace(Turn turn) const { return turns[static_cast<std::size_t>(turn)]; }
  double seconds(Turn turn) const;
  friend bool operator==(const SpeedModel&, const SpeedModel&) = default;
};

/// The least time in s for a straight of `metres` from speed `from` to speed `to`: up, along at top speed if there is
/// time for it, down. Nothing when it is too short for the change of speed. Precondition: 0 <= from, to <= top speed;
/// metres >= 0.
std::optional<double> straight_seconds(const Ramp& ramp, double from, double to, double metres);

/// The highest speed on the way, when it is driven so.
double peak_speed(const Ramp& ramp, double from, double to, double metres);

}  // namespace taut::micromouse
