// The searches of TreePlanner, and what they share.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <taut/geometry/draws.h>
#include <taut/robots/roadblocks/detail/disc_distance.h>
#include <taut/robots/roadblocks/lattice_planner.h>
#include <taut/robots/roadblocks/tree_planner.h>

namespace taut::roadblocks::detail {

using taut::Draws;

/// What a car drives before it is stopped.
struct Stretch {
  std::vector<Pose> poses;  ///< after each step
  bool arrived = false;     ///< the last one is at the goal
  bool whole = false;       ///< nothing stopped it
};

/// Where trees grow.
class TreeRoom {
 public:
  TreeRoom(const Course& course, RoadblockSet closed, WallReading reading)
      : obstacles_(course, closed, reading), distance_(obstacles_, course.goal) {}

  const Course& course() const { return obstacles_.course(); }
  const DiscDistance& distance() const { return distance_; }

  bool is_clear(const Pose& from, double control, const Pose& to) const {
    return obstacles_.is_clear(from, control, to, kMargin);
  }
  bool stands_clear(const Pose& pose) const { return obstacles_.is_free(pose, kMargin); }
  bool is_goal(const Pose& pose) const { return at_goal(pose, course(), -0.001); }

  /// Drives until a step is not clear or the goal is reached. Precondition: `from` stands clear.
  Stretch driven(const Pose& from, std::span<const double> controls) const;
  /// Is all of it clear? Then `end` is where it ends.
  bool drives(const Pose& from, std::span<const double> controls, Pose& end) const;

  /// Where a disc fits and from where it gets to the goal, any heading.
  Pose sample(Draws& draws) const;
  /// `far` along the disc's way to the goal, heading along it.
  Pose ahead(const Pose& from, double far) const;

 private:
  Obstacles obstacles_;
  DiscDistance distance_;
};

/// How many may still be drawn.
struct Samples {
  Draws& draws;
  std::size_t most;
  std::size_t& drawn;                       ///< counts on
  std::vector<TreeBranch>* tree = nullptr;  ///< gets what was grown
};

/// The leg that these controls drive.
TreeBranch branch_of(Pose from, std::span<const double> controls, bool from_goal = false);

// Controls to the goal, the last one reaching it; nothing when the samples are used up.
std::optional<std::vector<double>> rrt(const TreeRoom& room, const Pose& from, Samples samples, bool by_field);
std::optional<std::vector<double>> rrt_star(const TreeRoom& room, const Pose& from, Samples samples);
std::optional<std::vector<double>> rrt_connect(const TreeRoom& room, const Pose& from, Samples samples);

}  // namespace taut::roadblocks::detail
