// What TangentGraph keeps, and how a further place joins it.
#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <utility>
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
  TautCones cones{};         ///< of a circle of no size: where its legs can lead
};

/// What is the same for all radii.
struct TangentGround {
  explicit TangentGround(const FreeSpace& space);

  TangentWalls walls;
  std::vector<TangentSite> sites;
  std::vector<std::uint32_t> site_at;  ///< of each vertex of the triangulation; kNone
};

/// A line that a path may follow from one site to another, by the sides that it has their centres on.
struct TangentName {
  std::uint32_t from = 0, to = 0;  ///< sites, from < to
  int from_side = 0, to_side = 0;

  friend bool operator==(const TangentName&, const TangentName&) = default;
};

/// Is there that tangent for circles of radius r, and can the centre follow it? Exact.
bool is_free_tangent(const TangentGround& ground, const TangentName& name, double r);

/// The tangents between two sites that are free, both ends as points of their circles.
struct TangentPair {
  TangentPoint from, to;
  Interval length;
};
/// `filtered`: exactly only what doubles cannot tell (plain_tangent.h); the answers are the same.
std::vector<TangentPair> free_tangents(const TangentWalls& walls, double r, const TangentSite& from,
                                       const TangentSite& to, bool filtered = false);

/// One that is free.
struct FoundTangent {
  TangentName name;
  TangentPair ends;
};
FoundTangent found_tangent(const TangentGround& ground, const TangentName& name, double r);

/// A free tangent between two tangent points, from the first's side. Its sides are `points`' own when it is left from
/// them.
struct TangentLeg {
  std::uint32_t from = 0, to = 0;  ///< points; the path has from's centre on from_side, to's on to_side
  int from_side = 0, to_side = 0;
  Interval length;
};

/// Is point p before q around their circle, counter-clockwise? They lie within 180 degrees; of two opposite ones the
/// first is a left turn from the wall between them.
bool is_before(const TangentPoint& p, const TangentPoint& q, const TangentSite& site);
/// Are two points of one circle the same?
bool same_point(const TangentPoint& a, const TangentPoint& b);

/// Puts the ends of tangents at one site in order.
struct SiteOrder {
  /// Ascending around a circle, equal ones as they come; a corner of openings has one point.
  void put(const TangentSite& site, std::span<const TangentPoint> ends);

  std::vector<std::uint32_t> order;    ///< numbers of ends
  std::vector<std::uint8_t> is_first;  ///< of those in `order`, of its point

 private:
  std::vector<std::pair<double, std::uint32_t>> sines_;
};

struct TangentParts {
  /// Looks for all legs.
  TangentParts(std::shared_ptr<const TangentGround> ground, double radius, const TellProgress& tell = {});
  /// Of all free tangents, ascending by name, and what stands around a site's circle.
  TangentParts(std::shared_ptr<const TangentGround> ground, double radius, const std::vector<FoundTangent>& tangents,
               const std::function<const CircleObstacles&(std::uint32_t)>& around);

  const TangentWalls& walls() const { return ground->walls; }
  const std::vector<TangentSite>& sites() const { return ground->sites; }

  double r;
  std::shared_ptr<const TangentGround> ground;
  std::vector<TangentPoint> points;        ///< site by site, ascending around each circle
  std::vector<std::uint32_t> site_of;      ///< of each point
  std::vector<std::uint32_t> first_point;  ///< of each site; a corner of openings has one point or none
  std::vector<std::uint8_t> arc_is_free;   ///< from each point to the next one of its site
  std::vector<std::uint32_t> first_leg;    ///< of each point
  std::vector<TangentLeg> legs;            ///< both ways
  std::size_t arcs = 0;

 private:
  void put_in_order(const std::vector<FoundTangent>& tangents, std::vector<std::uint32_t>& point_of);
  void find_arcs(const std::function<const CircleObstacles&(std::uint32_t)>& around);
  void sort_legs(const std::vector<FoundTangent>& tangents, const std::vector<std::uint32_t>& point_of);
};

}  // namespace taut
