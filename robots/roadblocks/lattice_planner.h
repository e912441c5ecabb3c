// A* on a lattice of motion primitives of this very car.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include <taut/robots/roadblocks/drive.h>

namespace taut::roadblocks {

/// The controls of a way to the goal, and the poses after each of them.
struct DrivePlan {
  std::vector<double> controls;
  std::vector<Pose> poses;
};

/// Does the plan, followed from there, meet the roadblock if it is closed, or pass it by less than kMargin?
bool crosses(const Pose& from, const DrivePlan& plan, const Roadblock& block, WallReading reading);

/// Plans with the closed roadblocks known.
///
///  1. A*, headings being multiples of 2 pi / 128 from the start's own, which the control kLatticeTurn changes by one
///     each step. Primitives: straight ahead, arcs to both sides, straight back, an arc backwards (straight back and
///     forward arcs by turns, since reversing knows no arc) and the turn on the spot (three steps back, one of arc).
///     The cost is the number of steps. Of poses in one bin with one heading only the cheapest goes on.
///  2. Every step's end pose (squares: every step's sweep) is tested with the car widened by a margin: 0.02 with bins
///     of 1/4 at first, so that the car can get out of where it got in; only when this gives no way, kMargin (that
///     another simulator's rounding agrees) with bins of 1/10, twice as many headings and shorter primitives.
///  3. The heuristic is the greater of the way of a disc of radius 1 on a raster of 1/4, and 1.05 times the cost by a
///     coarse lattice of poses. Neither is strictly a lower bound: plans are not proven to be
///     the shortest of the lattice; they are mostly within 3 % of it. Where even the disc cannot pass (between centres
///     at most 2 apart in points) there is no way, and none is searched for.
///  4. Plans are then shortened by continuous controls, which brings them below what the lattice
///     has.
///  5. An absent plan is sure (gave_up() is false) only when cells of poses prove that no controls whatever lead to the
///     goal. Else the planner gave up, also where the finest lattice (1/10 and 64 headings) was
///     searched without a rest: it leaves out ways that give the car less play than it needs. Otherwise it is left
///     after 600 000 expansions. Precondition: the car can have come to `from` from the course's start; where that has
///     no way, `from` is not searched in the finest lattice, and once it is proven that some closed roadblocks leave it
///     none, nothing is searched while these are closed.
/// Plans are kept: the same question again costs nothing, nor does one whose answer a kept plan from there is: planned
/// around fewer closed roadblocks, and clear of all. The estimate for a set of closed roadblocks is repaired from one
/// with fewer closed. Same questions, same answers.
class LatticePlanner {
 public:
  LatticePlanner(const Course& course, WallReading reading);  ///< `course` must outlive it
  ~LatticePlanner();
  LatticePlanner(const LatticePlanner&) = delete;
  LatticePlanner& operator=(const LatticePlanner&) = delete;

  /// The controls from `from`, whose heading is taken as the nearest on the lattice. Null when there is no way; valid
  /// as long as the planner.
  const DrivePlan* plan(const Pose& from, RoadblockSet closed);

  /// After plan() gave null for the same: is that unproven?
  bool gave_up(const Pose& from, RoadblockSet closed);

  /// A way that is known: `plan`, found with `shut` closed, from its pose after `steps` steps on. From there plan()
  /// searches no other where that is the best for sure, and gives none that is longer.
  void adopt(const DrivePlan& plan, std::size_t steps, RoadblockSet shut);

  /// About the steps of a plan, without a search (within some percent, mostly less): nothing where the coarse lattice
  /// of the estimate knows no way.
  std::optional<double> estimate(const Pose& from, RoadblockSet closed);

  /// Estimates for sets of closed roadblocks that are kept, 8 sets at least; 160 MB if never said.
  void keep_at_most(std::size_t bytes);

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

}  // namespace taut::roadblocks
