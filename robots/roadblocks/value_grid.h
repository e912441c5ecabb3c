// Poses made discrete for value iteration: cells x 8 headings.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include <taut/robots/roadblocks/drive.h>

namespace taut::roadblocks {

namespace detail {
class Obstacles;
}

/// What is done in a state.
enum class Action : std::uint8_t { straight, turn_plus, turn_minus, back };
inline constexpr std::array<Action, 4> kActions{Action::straight, Action::turn_plus, Action::turn_minus, Action::back};

/// States: the car's centre on a cell's centre (with `per_unit` 2 half-way between cells too, and so on), heading k *
/// 45 degrees, k = 0 .. 7.
///
///  1. Actions: straight ahead to the next point, a turn on the spot by 45 degrees or, if asked for, straight back to
///     the next point. An action is there only if the car, driving it from exactly there in its own steps, stays clear
///     of all closed cells by kMargin: walls do not merely cost.
///  2. Straight costs 1, sqrt 2 on a diagonal, and more for what is around the point it comes to: sqrt 2 for each
///     closed cell beside it, 1 for each at a corner of the 3 x 3 cells around. A turn costs `turn`: 64
///     steps of the car are about 9 cells. Straight back takes three times as many steps as ahead, and its
///     length costs so.
///  3. Goal states, of value 0: the car covers the goal with 0.3 to spare.
struct ValueCosts {
  double turn = 9;
  bool backs = false;
};

class ValueGrid {
 public:
  static constexpr int kHeadings = 8;
  static constexpr double kNever = std::numeric_limits<double>::infinity();

  ValueGrid(const Course& course, RoadblockSet closed, WallReading reading, int per_unit = 1, ValueCosts costs = {});

  int columns() const { return columns_; }
  int rows() const { return rows_; }
  int per_unit() const { return per_unit_; }
  std::size_t size() const { return goal_.size(); }  ///< states

  /// i-th column, j-th row, from 0: states of one heading lie together, rows first.
  std::size_t index(int i, int j, int heading) const {
    return (static_cast<std::size_t>(heading) * static_cast<std::size_t>(rows_) + static_cast<std::size_t>(j)) *
               static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(i);
  }
  int heading(std::size_t state) const { return static_cast<int>(state / plane()); }
  Pose pose(std::size_t state) const;

  bool is_goal(std::size_t state) const { return goal_[state] != 0; }
  /// kNever when the action is not there.
  double cost(std::size_t state, Action action) const { return costs_[static_cast<std::size_t>(action)][state]; }
  /// Where an action that is there leads.
  std::size_t after(std::size_t state, Action action) const;
  /// The costs of an action in all states.
  const std::vector<double>& costs(Action action) const { return costs_[static_cast<std::size_t>(action)]; }
  bool backs() const { return backs_; }

  /// Takes an action away, as when a drive shows that it cannot be followed.
  void shut(std::size_t state, Action action) { costs_[static_cast<std::size_t>(action)][state] = kNever; }
  void shut_goal(std::size_t state) { goal_[state] = 0; }

  /// The step in columns and rows of a heading.
  static constexpr std::array<std::array<int, 2>, kHeadings> kSteps{
      {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};

 private:
  void price(const detail::Obstacles& obstacles, const ValueCosts& costs);
  bool stays_inside(std::size_t state, Action action) const;
  std::size_t plane() const { return static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_); }

  int per_unit_, columns_, rows_;
  bool backs_;
  std::vector<std::uint8_t> goal_;
  std::array<std::vector<double>, kActions.size()> costs_;
};

}  // namespace taut::roadblocks
