// Distances in steps: up to three cells straight in any of the four directions count one, whatever the heading.
#pragma once

#include <optional>
#include <vector>

#include <taut/robots/micromouse/wall_map.h>

namespace taut::micromouse {

inline constexpr int kUnreached = -1;

/// From a cell, or from several, to all: the fewest steps along passages. The relation is symmetric, so these are also
/// the distances back. Breadth-first over sets of cells, 64 cells an operation: O(steps * cells / 64).
class StepField {
 public:
  StepField(const Passages& passages, const std::vector<Cell>& from);

  int operator()(Cell cell) const { return steps_[static_cast<std::size_t>(cell.y * width_ + cell.x)]; }
  bool reached(Cell cell) const { return (*this)(cell) != kUnreached; }

 private:
  int width_;
  std::vector<int> steps_;
};

/// The fewest steps in which run 2 can end in the goal; at least 1; nothing when there is no way.
std::optional<int> optimum(const Passages& passages, const Task& task);

/// A run 2 of that many steps: the cells at the ends of steps, start and goal included. Among equals: at each step the
/// fewest cells, then north before east, south, west. (Empty when there is no way.)
std::vector<Cell> shortest_route(const Passages& passages, const Task& task);

/// Cells one step away: up to three straight, by open passages.
std::vector<Cell> one_step_from(const Passages& passages, Cell cell);

/// The direction from one cell to another in its row or column; north when they are the same.
Side side_towards(Cell from, Cell to);

/// The action that goes from `pose` straight to `to`, at most three cells away in its row or column: forwards, unless
/// it lies behind. Precondition: it does.
Action action_towards(const MousePose& pose, Cell to);

}  // namespace taut::micromouse
