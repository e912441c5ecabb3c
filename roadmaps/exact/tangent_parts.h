// What TangentGraph keeps, and how a further place joins it.
#pragma once
#include <vector>

#include <taut/roadmaps/exact/tangent_walls.h>
#include <taut/roadmaps/exact/taut_cones.h>
#include <taut/roadmaps/tangent_graph.h>

namespace taut {

/// What a path bends around: a circle, or a corner of openings, or an end of a query (neither bends).
struct TangentSite {
  Point at;
  std::uint32_t vertex = kNone;
  std::uint32_t sector = kNone;  ///< of a corner of openings; of an end that is a vertex
  bool round = false;
  std::vector<Point> walls;  ///< the far ends of the walls that meet in a circle's centre
  TautCones cones{};         ///< of a circle: where its legs can lead
};

/// A free tangent between two tangent points, from the first's side. Its sides are `points`' own when it is left from
/// them.
struct TangentLeg {
  std::uint32_t from = 0, to = 0;  ///< points; the path has from's centre on from_side, to's on to_side
  int from_side = 0, to_side = 0;
  Interval length;
};

/// All points of one circle, ascending around it.
struct TangentRing {
  std::vector<std::uint32_t> points;
  std::vector<std::uint8_t> free;  ///< is the arc from points[i] to points[i + 1]?
};

/// The tangents between two sites that are free, both ends as points of their circles.
struct TangentPair {
  TangentPoint from, to;
  Interval length;
};
std::vector<TangentPair> free_tangents(const TangentWalls& walls, double r, const TangentSite& from,
                                       const TangentSite& to);

/// Sorts points (indices into `all`) around their circle.
void sort_around(std::vector<std::uint32_t>& points, const std::vector<TangentPoint>& all, const TangentSite& site);
/// Are two points of one circle the same?
bool same_point(const TangentPoint& a, const TangentPoint& b);

struct TangentParts {
  TangentParts(const FreeSpace& space, double radius);

  double r;
  TangentWalls walls;
  std::vector<TangentSite> sites;
  std::vector<std::uint32_t> site_at;  ///< of each vertex of the triangulation; kNone
  std::vector<TangentPoint> points;
  std::vector<std::uint32_t> site_of;    ///< of each point
  std::vector<TangentRing> rings;        ///< of each site; a corner of openings has one point or none
  std::vector<std::uint32_t> first_leg;  ///< of each point
  std::vector<TangentLeg> legs;          ///< both ways
  std::size_t arcs = 0;

 private:
  void find_sites();
  void find_legs();
  void build_rings();
  void sort_legs();
};

}  // namespace taut
