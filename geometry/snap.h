// What nearly touches: seen, and joined.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <taut/geometry/point.h>
#include <taut/geometry/world.h>

namespace taut {

/// An end of a wall, or a corner of a ring, that is near to another wall or side, but they do not touch.
struct NearContact {
  Point end;
  Segment wall;         ///< the other one, the nearest
  double distance = 0;  ///< to the nearest double
  int line = 0;         ///< of the end's wall in the input; 0: unknown
  int wall_line = 0;
};

/// What is to be joined.
struct Snap {
  enum class What {
    rounding,   ///< what lies within rounding where a computed number is involved: the rule of readers
    nothing,    ///< not even that
    within,     ///< what is no farther apart than `tolerance`
    automatic,  ///< what is no farther apart than auto_tolerance, and what lies within rounding
  };
  What what = What::rounding;
  double tolerance = 0;  ///< > 0, of `within`
};

/// What joining did.
struct SnapReport {
  double tolerance = 0;                ///< nothing moved farther
  std::size_t joined = 0;              ///< contacts: ends that became one, ends that a wall now passes through
  double displacement = 0;             ///< the largest distance that an end moved, or a wall bent
  std::vector<NearContact> remaining;  ///< what was, or came to be, within the tolerance and does not touch; none of
                                       ///< `rounding`
};

/// Joins the walls and rings of a world.
///
///  1. Ends become one point, an end of them; a wall or side near to an end bends to pass through it: it becomes
///     several walls. So what crosses or overlaps at an angle that rounding made becomes the same segment.
///  2. No end moves, and no wall or side bends, farther than the tolerance: that wins over joining. The two ends of
///     one wall are never made one by their own nearness.
///  3. Walls whose thickness covers the distance touch already; they stay as they are.
///  4. Start, goal and `ends` do not move. Where one is within rounding of a wall or side, with a computed number
///     among theirs, that bends to pass through it.
///  5. `uncertainty` of the result: how far from where it was meant a place may lie; the greater of the displacement
///     and, where there is a computed number, rounding_tolerance.
///  6. Same input, same output. O((n + k) log n) for n walls and sides with k pairs whose boxes are near. A world of
///     written numbers is passed through by Snap::What::rounding in O(n).
/// A grid that the world came from is forgotten when something was joined. Coordinates need not be valid: what no World
/// can have is passed through.
struct SnappedParts {
  WorldParts parts;
  SnapReport report;
};
SnappedParts snapped(WorldParts parts, const Snap& snap, std::span<const Point> ends = {});

/// The same as a World. With Snap::What::rounding, what would be accepted as it is is not refused for having been
/// joined: then it stays as it is. Throws InputError as World does; of Snap::What::within also when contacts remain.
struct Snapped {
  World world;
  SnapReport report;
};
Snapped snapped_world(const WorldParts& parts, const Snap& snap = {}, std::span<const Point> ends = {});
/// Likewise, and without a copy where there is nothing to join.
Snapped snapped_world(WorldParts&& parts, const Snap& snap = {}, std::span<const Point> ends = {});

/// What is no farther apart than `tolerance` is joined; 0: nothing is. What remains is listed, not refused.
Snapped snapped(const World& world, double tolerance);
Snapped snapped(const World& world, const Snap& snap, std::span<const Point> ends = {});

/// The greater of 2^-40 of the extent (the longer side of the box around walls and rings) and 8 units in the last place
/// of the largest coordinate.
double rounding_tolerance(const WorldParts& parts);

/// Of all distances above rounding_tolerance between an end and a wall or side that it does not touch, in order, the
/// greatest ratio from one to the next, the first below 10^-3 of the extent: that first one. 0 when no ratio is at
/// least 10. Distances below 10^-7 of the extent count as that much: the smallest of many are far apart by chance.
double auto_tolerance(const WorldParts& parts);

/// All ends nearer to another wall than a tenth of the shorter of the two, and than 10^-6 of the extent or, where that
/// is more, one unit of the lattice of decimals if it is at most 10^-4 of the extent; but not touching. In the order of
/// `end`; of two ends near to each other one is listed. O((n + k) log n); an axis-parallel world on a lattice has none,
/// in O(n).
std::vector<NearContact> near_contacts(const World& world);

/// `3 ends joined to other walls, moved by at most 0.0008`; empty when nothing was.
std::string text(const SnapReport& report);
/// `2 ends nearly touch another wall, at most 0.0008 apart: (1, 2) and (0, 0)-(4, 8)`, the example being of the largest
/// distance; empty when there is none.
std::string text(const std::vector<NearContact>& contacts);

}  // namespace taut
