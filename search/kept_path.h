// The shortest path that keeps a clearance, but near ends that do not.
#pragma once

#include <string>
#include <vector>

#include <taut/geometry/interval.h>
#include <taut/search/arc_path.h>
#include <taut/search/passage_index.h>

namespace taut {

/// A path in parts, each of a disc of its own radius, chained from start to goal.
///
/// What it is (docs/definitions.md, "Kept clearance"). A disc of radius c has its places, the points at least c away
/// from every wall.
///  1. Between two places: the shortest path of that disc (arc_search).
///  2. An end that is no place is *left* for one. Straight, with the end's own distance kept: to the nearest place, or,
///     where that is not to be had so or leads nowhere, to the nearest of those around (nearest to eight points c
///     away).
///  3. Else the end lies in a pocket: gates narrower than 2c are around it. Of the places at these gates (nearest to
///     their middles) those count to which the largest disc gets from the end; rho is its radius. The end is left for a
///     place of that disc by rule 2, and from there the shortest path of that disc leads to the nearest of the places
///     that count.
///  4. Of an end that is the goal the same, backwards. Where the straight leg from start to goal keeps the lesser of
///     their distances and is shorter than leaving and entering together, it is the path.
/// So clearance is c between the places, and before and after never less than the end's own or rho; what is nearer to
/// walls than c are the ways between ends and places alone.
struct KeptPath {
  enum class Status {
    found,
    start_blocked,  ///< outside
    goal_blocked,   ///< likewise
    none,           ///< no place of the disc that both ends lead to by the rules above
  };
  Status status = Status::none;
  double clearance = 0;        ///< what was asked for
  std::vector<ArcPath> parts;  ///< radii ascend to `clearance` and descend again; of radius 0: straight from a wall
  std::size_t first = 0;       ///< parts before it leave the start
  std::size_t last = 0;        ///< parts from it on enter the goal; first == last: none keeps the clearance
  Interval length;
  /// Places are the nearest but for rounding: none is nearer by more (DiscPlaces).
  double rounding = 0;
};

/// Lengths of one part are compared by enclosures, as arc_search does. A TangentGraph for each radius among the parts
/// is built: seconds on worlds of 10^5 walls. Precondition: 0 < c <= World::kLargest.
KeptPath kept_path(const PassageIndex& index, Point start, Point goal, double c);

/// Does the path keep what it says? Every part against every wall, exactly (verify_arcs; straight legs from a wall by
/// FreeSpace::sees), chained; radii ascend to the clearance and descend; the parts next to an end keep what the largest
/// disc does that gets from there to a place (PassageIndex::widest). Empty, or why not.
std::string kept_path_fault(const KeptPath& path, const PassageIndex& index, Point start, Point goal);

}  // namespace taut
