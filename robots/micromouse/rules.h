// The rules of the micromouse contest: what a robot is told, what it senses, what it may do.
#pragma once

#include <vector>

#include <taut/geometry/grid_maze.h>

namespace taut::micromouse {

inline constexpr int kMaxSteps = 1000;        ///< for both runs together
inline constexpr int kLongestMove = 3;        ///< cells a step, forwards or backwards
inline constexpr int kExplorationShare = 30;  ///< a step of run 1 counts as this part of a step of run 2

/// What a robot is told before it starts. Both runs begin at `start`, heading north. The border is closed.
struct Task {
  int width = 0;
  int height = 0;
  Cell start{0, 0};
  std::vector<Cell> goal;  ///< sorted; never empty
  int max_steps = kMaxSteps;

  bool contains(Cell c) const { return c.x >= 0 && c.y >= 0 && c.x < width && c.y < height; }
  bool in_goal(Cell c) const;
  friend bool operator==(const Task&, const Task&) = default;
};

/// The task a maze sets: its own goal room, the room in the middle when it names none.
/// Throws InputError when the border has an opening, when start or goal lie outside, or when a side is longer than 256.
Task task_of(const GridMaze& maze, int max_steps = kMaxSteps);

/// Where the robot stands and looks.
struct MousePose {
  Cell cell{};
  Side heading = Side::north;
  friend bool operator==(const MousePose&, const MousePose&) = default;
};

/// The direction after `quarters` clockwise quarter turns (negative: counter-clockwise).
constexpr Side turned(Side side, int quarters) {
  return static_cast<Side>((static_cast<unsigned>(side) + static_cast<unsigned>(quarters)) & 3U);
}
constexpr Side opposite(Side side) { return turned(side, 2); }

/// The cell `count` cells further in a direction.
Cell ahead(Cell cell, Side side, int count = 1);

/// What the sensors give: the number of open cells up to the next wall to the left, ahead and to the right. None looks
/// back.
struct SensorReading {
  int left = 0;
  int front = 0;
  int right = 0;
  friend bool operator==(const SensorReading&, const SensorReading&) = default;

  /// The reading in the direction `rotation` (-90, 0 or 90 degrees) from the heading.
  int at(int rotation) const { return rotation < 0 ? left : rotation > 0 ? right : front; }
};

/// One step: turn, then move cell by cell; or the reset that ends run 1.
/// The trial takes any numbers: a rotation other than -90, 0, 90 turns nothing, a movement beyond 3 cells is cut to 3.
struct Action {
  int rotation = 0;  ///< degrees, clockwise
  int movement = 0;  ///< cells, negative backwards without turning
  bool reset = false;
  friend bool operator==(const Action&, const Action&) = default;
};

inline constexpr Action kReset{0, 0, true};

/// A side of a cell as the name of a wall. The same wall has two names but for the border; canonical() picks one.
struct CellSide {
  Cell cell{};
  Side side = Side::north;
  friend auto operator<=>(const CellSide&, const CellSide&) = default;
};

/// The name by the cell to the south or west; of a border wall in the south or west, by the only cell there is.
CellSide canonical(CellSide wall);

}  // namespace taut::micromouse
