// The ways that there are: locally shortest paths, the shortest first.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <taut/roadmaps/gates.h>
#include <taut/search/barrier.h>
#include <taut/search/path.h>
#include <taut/search/search_status.h>

namespace taut {

/// One way around the obstacles.
struct Alternative {
  Path path;                        ///< the shortest of its homotopy class; bends at corners alone
  std::optional<NamedGate> gate{};  ///< the narrowest that every path of the class passes; nothing: it passes none
};

struct Alternatives {
  SearchStatus status = SearchStatus::none;  ///< stopped: the limit came first; `ways` are the shortest nevertheless
  std::vector<Alternative> ways;             ///< the shortest first; of equal lengths by their points
  bool all = false;                          ///< there are no more
  std::size_t expanded = 0;
};

struct AlternativesRequest {
  std::size_t count = 3;                  ///< how many, at most
  std::size_t most_expanded = 1'000'000;  ///< then it stops
};

/// The shortest paths of the `count` shortest homotopy classes of paths from s to g, for a point.
///
///  1. Two paths are of one class when one can be pulled into the other, the ends held fast, not over an obstacle
///     (corridor_of). A class has one shortest path, a taut string. Classes with an equal curve are one here: a string
///     along a free wall, from end to end, may be on either of its sides.
///  2. A class counts when its string touches no corner twice and does not cross itself: ways that wind around an
///     obstacle once more, or go around one and come back, are left out. There are finitely many; from a place to
///     itself there is one.
///  3. Lengths compare exactly (Length), and that each string is taut is checked by pulling it (shortened).
///  4. A disc gets along a class iff it can be at the ends and its diameter is at most the narrowest gate that every
///     path of the class passes. Gates and strings are both shortest, so they cross at most once: these are the gates
///     that the string crosses, a little to the free side of each of its corners. Found in doubles, by a way 2^-20 of
///     the narrowest gate away from corners; widths compare exactly.
/// Method: A* along the taut legs of the reduced visibility graph, without dropping longer ways to a corner; estimated
/// by the distance to the goal. O(E) for the estimate; then about a step for each corner of each way that is no longer
/// than the last one. Precondition: the space is a point's; neither end is outside.
Alternatives alternatives(const Gates& gates, Point s, Point g, const AlternativesRequest& request = {});

/// What room costs: of all ways those that are wider than every way that is as short, or shorter; the shortest first.
/// Up to the width of way i it is the shortest that a disc gets along (its string; the disc's own path goes around
/// corners in arcs), so these widths are all radii at which the way has to change. Exact where the feet of gates are
/// pairs of doubles; else ways that differ by less than 1e-9 of the width in length may stand for each other.
/// Method: the shortest path; all gates no wider than its own become walls; again. A FreeSpace for each way.
/// Preconditions as above. Nothing when there is no path.
std::vector<Alternative> wider_ways(const Gates& gates, Point s, Point g);

}  // namespace taut
