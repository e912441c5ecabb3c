// A* for a general car on a lattice of exact poses.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <taut/robots/car/car_space.h>
#include <taut/search/disc_passage.h>
#include <taut/search/graph_search.h>

namespace taut::car {

/// From where to where.
struct DriveQuery {
  Point start;
  std::optional<int> heading{};       ///< at the start; any when absent
  std::vector<Point> goals{};         ///< the reference point has to get to one of these, exactly
  std::optional<int> goal_heading{};  ///< any when absent
  double weight = 1;                  ///< >= 1, see guarantee 3 of planned_drive
  bool shorten = true;                ///< guarantee 4
  SearchLimits limits{};              ///< of all lattices together
};

struct PlannedDrive {
  SearchStatus status = SearchStatus::stopped;
  std::vector<Leg> legs{};               ///< when found; none when the start is the goal
  LatticePose start{};                   ///< when found: with the heading that was chosen
  double length = 0;                     ///< of the reference point's way, when found
  double lower_bound = 0;                ///< no car that has the inner disc drives less; 0: unknown
  double step = 0;                       ///< of the last lattice searched
  int headings = 0;                      ///< likewise
  std::size_t lattices = 0;              ///< searched
  std::size_t expanded = 0;              ///< poses, in all of them
  std::size_t tested = 0;                ///< legs tested against walls
  std::optional<DiscPassage> barrier{};  ///< when none: why the inner disc does not get through
};

/// A short drive.
///
///  1. found: the legs are drivable and free (CarSpace), each begins where the one before ends, the last ends in a goal
///     exactly. Start and goal need not lie on the lattice: legs lead onto it and off it.
///  2. none is proven, for any car of this size however it turns: not even the disc inside it gets through
///     (disc_passage). stopped: no drive was found, which proves nothing: the limits were reached, or kLattices
///     lattices, each twice as fine as the one before, hold none.
///  3. On its lattice (nodes `step` apart, legs as the header of the planner's lattice lists them) the drive is at most
///     `weight` times as long as the shortest, to 1e-9; of equally long ones it goes forward. The heuristic is the
///     shortest way of the inner disc around the walls, a proven lower bound; with a goal heading also the shortest
///     Reeds-Shepp (Dubins, for a car that cannot reverse) path without walls.
///  4. With `shorten` runs of legs are replaced by shorter ones off the lattice, as exact and as free: the zigzag of a
///     coarse lattice goes. The drive gets no longer.
///  5. Same query, same drive, unless limits.seconds ends it.
/// Throws InputError when the car cannot stand at the start (at any of the headings, when free), the inner disc is in a
/// wall at all goals, or the world is larger than 2^25 steps. Precondition: goals are not empty.
PlannedDrive planned_drive(const CarSpace& space, const DriveQuery& query);

inline constexpr std::size_t kLattices = 3;

}  // namespace taut::car
