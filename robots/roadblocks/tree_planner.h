// Trees grown by random samples: RRT, RRT* and RRT-Connect for this very car.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include <taut/robots/roadblocks/replanning_driver.h>

namespace taut::roadblocks {

///  rrt          a node is a pose that controls of the car reach, and it grows towards a sample
///               only if one of the poses it can reach is nearer to the sample than itself (reachability-guided:
///               Shkolnik, Walter, Tedrake, 2009). 1 sample in 20 is the goal
///  rrt_field    the same; every second sample lies 3 ahead of a node along the way of a disc to the goal
///  rrt_star     RRT* (Karaman, Frazzoli, 2011): new nodes choose the cheapest parent among the near ones, and near
///               ones are hung onto new nodes when that is cheaper
///  rrt_connect  RRT-Connect (Kuffner, LaValle, 2000): one tree from the car, one to the goal, which grows by driving
///               backwards in *time*
enum class TreeKind : std::uint8_t { rrt, rrt_field, rrt_star, rrt_connect };

/// A leg of a grown tree: where the car's centre is, step by step, between a node and its parent.
struct TreeBranch {
  std::vector<Point> way;
  bool from_goal = false;  ///< of the tree that rrt_connect grows from the goal
};

/// Plans with the closed roadblocks known.
///
///  1. A plan is a list of controls whose every step was simulated and tested (with a margin of kMargin, as
///     LatticePlanner does). Nothing lands by assumption: where a tree joins two poses (rrt_star, rrt_connect) it does
///     so by turn, straight, turn in whole steps, which hits the heading and misses the position by at most 0.05. What
///     follows is then simulated from where the car really is, and the joint is refused if anything on it is not clear.
///  2. The tree to the goal of rrt_connect consists of poses from which the known controls, driven forwards, lead to
///     the goal. It is not the forward tree mirrored: this car goes back straight only, and slower.
///  3. The cost is the number of steps. rrt_star draws 6000 samples; where these give no plan it grows without joints,
///     as rrt does and as far, until there is one, and draws 2000 more with joints; the others stop at the first plan.
///     No plan is called the shortest: rrt_star converges to the best of its kinds of joints at most.
///  4. `proven_none` only when not even a disc inside the car gets to the goal.
/// The draws go on from plan to plan: same seed and same questions, same answers.
class TreePlanner {
 public:
  TreePlanner(const Course& course, WallReading reading, TreeKind kind,
              std::uint64_t seed);  ///< `course` must outlive it
  ~TreePlanner();
  TreePlanner(const TreePlanner&) = delete;
  TreePlanner& operator=(const TreePlanner&) = delete;

  /// `tree`, when given, gets the branches that were grown for it, also where they led nowhere.
  Attempt plan(const Pose& from, RoadblockSet closed, std::vector<TreeBranch>* tree = nullptr);

  std::size_t samples() const;  ///< drawn, in all plans so far

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// What the planner of this seed grew in a drive along its plans (peers.h), all plans together.
std::vector<TreeBranch> trees_of(const Course& course, WallReading reading, TreeKind kind, std::uint64_t seed,
                                 const Drive& drive);

/// Samples a plan at most.
std::size_t most_samples(TreeKind kind);

}  // namespace taut::roadblocks
