// The Voronoi diagram for other programs, with what roadmap_json.h and roadmap_export.h do not know: arcs and
// clearance.
#pragma once

#include <string>

#include <taut/io/results/json.h>
#include <taut/roadmaps/voronoi.h>

namespace taut {

/// roadmap_json's object (kind, vertices, edges [[u, v], ...] with u <= v, here in the diagram's order and possibly
/// twice the same pair), and:
///  max_error    VoronoiRoadmap::max_error, null when no bound is known
///  clearances   of each vertex
///  arcs         of each edge {kind: "line" | "parabola", control: [x, y] of the quadratic Bezier curve, length,
///               clearance (the least), gate: null or the nearest points [[x, y], [x, y]] of the two walls, sites:
///               [[[x, y], [x, y]], ...] the two pieces of wall, an end as a piece from itself to itself}
/// Numbers read back as the same double. About 250 bytes an edge.
Json voronoi_json(const VoronoiRoadmap& map);

/// roadmap_geojson's collection; each LineString also has `clearance` and `kind`, and each vertex `clearance`. Arcs are
/// sampled: no farther than `tolerance` > 0 from the exact curve, which each of them says in its property `tolerance`.
std::string voronoi_geojson(const VoronoiRoadmap& map, double tolerance);

/// GraphML (written by Boost.Graph): nodes with `x`, `y` and `clearance`, edges with `length` (of the arc) and
/// `clearance` (the least).
std::string voronoi_graphml(const VoronoiRoadmap& map);

}  // namespace taut
