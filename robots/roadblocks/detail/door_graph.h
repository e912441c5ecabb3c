// What doors are far from each other: the few places between which a drive among roadblocks is decided.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include <taut/robots/roadblocks/detail/pose_distance.h>
#include <taut/robots/roadblocks/doors.h>

namespace taut::roadblocks::detail {

/// A set of doors, bit i for the i-th.
using DoorSet = std::uint32_t;

/// Nodes: of each side of a door the *sight*, a pose that comes to the door and just sees it, and the *beyond*, a
/// pose as far after the door; and the goal. All sides are numbered, door by door.
///
///  1. Legs are estimates of PoseDistance with all doors closed, but for the one that a leg comes to. A leg to a sight
///     that leads through the door itself is none.
///  2. Of the poses where a side is come to, the sight is the one from where the door is passed soonest, the beyond the
///     one from where one is soonest at another door or the goal, both where the car can go on or turn back at all.
///  3. Made once for a course: a table of poses for each side and one for the goal, each of the rooms between doors.
class DoorGraph {
 public:
  /// Doors with less than two sides are left out. Nothing when its tables would need more bytes.
  static std::optional<DoorGraph> within(std::size_t bytes, const Course& course, WallReading reading,
                                         std::vector<Door> doors);

  static constexpr double kFar = PoseDistance::kFar;

  const std::vector<Door>& doors() const { return doors_; }
  DoorSet all() const { return (DoorSet{1} << doors_.size()) - 1; }
  int sides() const { return static_cast<int>(door_of_.size()); }
  DoorSet door_of(int side) const { return DoorSet{1} << door_of_[static_cast<std::size_t>(side)]; }
  int sight(int side) const { return side; }
  int beyond(int side) const { return sides() + side; }
  int goal() const { return 2 * sides(); }
  bool is_sight(int node) const { return node < sides(); }
  bool is_beyond(int node) const { return node >= sides() && node < goal(); }
  int side_of(int node) const { return node % sides(); }  ///< precondition: not the goal

  /// Steps from a pose to each node; kFar where no leg leads. A beyond is reached from where the car stands at its open
  /// door.
  std::vector<double> legs_from(const Pose& pose, DoorSet open) const;

  const std::vector<double>& legs_of(int node) const {
    return legs_[static_cast<std::size_t>(node)];
  }  ///< not the goal

  /// Corrects legs from a pose at a door that is known in part: the car stands at its nearest side, and may back out.
  void stand_at(int door, const Pose& pose, std::vector<double>& legs) const;

  /// What it costs to find out at a side's sight that the door is closed by the first of these blocks that is: the car
  /// goes on until it sees that one, and backs out.
  double trap(int side, RoadblockSet open) const;

  /// What a belief makes of a place: the best way to the goal through doors that are open, or unknown and taken for
  /// open at the price of `penalty` times the odds that they are closed.
  struct Ways {
    std::vector<double> steps;    ///< by node: with penalties; kFar: none
    std::vector<int> next;        ///< the node after it
    std::vector<int> stop;        ///< the first sight of an unknown door on the way; the goal when there is none
    std::vector<double> to_stop;  ///< steps
  };
  /// `penalty` infinite: unknown doors count as closed. Kept, up to a number.
  const Ways& ways(DoorSet open, DoorSet closed, double penalty);

  /// The best node to make for from legs, and the steps to the goal then.
  std::pair<int, double> first(const std::vector<double>& legs, const Ways& ways, DoorSet closed) const;

  /// Steps from legs to each node through these doors, and the node before (-1: none).
  std::pair<std::vector<double>, std::vector<int>> from_here(std::vector<double> legs, DoorSet open) const;

 private:
  DoorGraph() = default;
  bool make_tables(std::size_t bytes, const Course& course, WallReading reading);
  void make_legs();
  void choose_poses();
  void order_blocks(const Course& course);
  /// Of a side's arrivals, with any heading: where the cost is least, and less than kFar.
  template <typename Cost>
  std::optional<Pose> best_arrival(std::size_t side, Cost cost) const;
  double pass(const Pose& pose, std::size_t side) const;   ///< steps through the door from that side
  double leave(const Pose& pose, std::size_t side) const;  ///< steps to the goal or the nearest other door
  double steps(const Pose& pose, std::size_t side) const { return tables_[side].steps_from(pose); }
  Ways made(DoorSet open, DoorSet closed, double penalty) const;
  double price(DoorSet door, DoorSet open, double penalty) const;

  std::vector<Door> doors_;
  std::vector<std::size_t> door_of_;     ///< by side
  std::vector<std::size_t> first_side_;  ///< by door, and one more
  std::vector<StepTable> tables_;        ///< by side, and the goal's
  std::vector<Pose> sights_, beyonds_;
  std::vector<std::vector<std::pair<double, RoadblockSet>>> blocks_;  ///< by side: the door's, by their traps
  std::vector<std::vector<double>> legs_;                             ///< between nodes
  std::map<std::tuple<DoorSet, DoorSet, double>, Ways> kept_;
};

}  // namespace taut::roadblocks::detail
