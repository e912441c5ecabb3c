// A* on a lattice of motion primitives of this very car.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include <taut/robots/car/drive.h>

namespace taut::car {

/// The controls of a way to the goal, and the poses after each of them.
struct Plan {
  std::vector<double> controls;
  std::vector<Pose> poses;
};

/// Does the plan, followed from there, meet the roadblock if it is closed, or pass it by less than kMargin?
bool crosses(const Pose& from, const Plan& plan, const Roadblock& block, WallReading reading);

/// Plans with the closed roadblocks known.
///
///  1. Headings are multiples of 2 pi / 128, which the control kLatticeTurn changes by one each step. Primitives: straight ahead, arcs to both sides, straight
///     back, an arc backwards (straight back and forward arcs by turns, since reversing knows no arc) and the turn on the spot (three steps
///     back, one of arc). Every step's end pose (squares: every step's sweep) is tested with a margin of kMargin, so that another
///     simulator's rounding agrees.
///  2. The cost is the number of steps. Of poses in one bin with one heading only the cheapest goes on. Bins are 1/4 wide at first; only when these give no
///     way, 1/10, with twice as many headings and shorter primitives.
///  3. The heuristic is the way of a disc of radius 1 around obstacles on a raster of 1/4, divided by the step; it may exceed the true distance by 8 %.
///     Where even the disc cannot pass (between centres at most 2 apart in points) there is no way, and none is searched for.
///  4. An absent plan: none exists in the finest lattice.
/// Plans are kept: the same question again costs nothing. Same question, same answer.
class LatticePlanner {
 public:
  LatticePlanner(const Course& course, WallReading reading);  ///< `course` must outlive it
  ~LatticePlanner();
  LatticePlanner(const LatticePlanner&) = delete;
  LatticePlanner& operator=(const LatticePlanner&) = delete;

  /// The controls from `from`, whose heading is taken as the nearest on the lattice. Null when there is no way; valid as long as the planner.
  const Plan* plan(const Pose& from, RoadblockSet closed);

  /// A way that is known: `plan`, found with `shut` closed, from its pose after `steps` steps on. From there plan() searches no other where that is the best for sure,
  /// and gives none that is longer.
  void adopt(const Plan& plan, std::size_t steps, RoadblockSet shut);

  /// About the steps of a plan, without a search (within some percent, mostly less): nothing where the coarse lattice of the estimate knows no way.
  std::optional<double> estimate(const Pose& from, RoadblockSet closed);

  const Course& course() const;
  WallReading reading() const;
  std::size_t expanded() const;  ///< states, in all plans so far
  std::size_t plans() const;     ///< searches so far

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

inline constexpr int kLatticeHeadings = 128;
inline constexpr double kLatticeTurn = 6.283185307179586 / 128 / kTurn;  ///< the control, 0.98
inline constexpr double kMargin = 1e-6;

}  // namespace taut::car
