// The Voronoi diagram with straight legs, for whoever knows only those.
#pragma once

#include <taut/roadmaps/roadmap.h>
#include <taut/roadmaps/voronoi.h>

namespace taut {

/// The diagram as a graph of straight legs: its vertices first, in order, then points on its arcs, edge by edge; no
/// farther than `tolerance` > 0 from it (sampled()). Two edges between the same vertices that are both straight become
/// one. With a clearance > 0, only what keeps it: edges all along, and the vertices that they join. O(V + E + points).
Roadmap voronoi_legs(const VoronoiRoadmap& map, double tolerance, double clearance = 0);

}  // namespace taut
