// Paths along the Voronoi diagram as polygonal paths, like those of every other roadmap.
#pragma once

#include <taut/geometry/world.h>
#include <taut/roadmaps/voronoi.h>
#include <taut/search/graph_search.h>

namespace taut {

/// The points that stand for a goal: its point, or the middles of the room's boxes that are not outside.
std::vector<Point> goal_points(const FreeSpace& space, const Goal& goal);

/// The shortest way along the diagram with that clearance (ClearanceSearch::shortest), arcs as legs that leave them by
/// no more than `tolerance` > 0. A way to a room goes to one of goal_points and ends where it first enters the room;
/// the shortest of those. Legs keep to the side of their arc where its point site is, so they touch no wall. Status
/// `none` is proven: the diagram connects what free space connects. Precondition: from and to.point are not outside.
GraphSearchResult voronoi_search(const VoronoiRoadmap& map, Point from, const Goal& to, double tolerance,
                                 double clearance = 0);

}  // namespace taut
