// The segment Voronoi diagram of free space's boundary: where a robot is farthest from the walls.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <taut/geometry/free_space.h>
#include <taut/geometry/progress.h>
#include <taut/roadmaps/bezier.h>

namespace taut {

/// What a Voronoi edge keeps its distance from: a piece of FreeSpace::constraints() without its ends, or one of its
/// ends.
struct VoronoiSite {
  enum class Part : std::uint8_t { inside, a, b };

  std::uint32_t constraint = kNone;  ///< of an end: the lowest piece that has it
  Part part = Part::inside;
};

/// A point with two or more nearest sites where edges end.
struct VoronoiVertex {
  Point at;
  double clearance_squared = 0;  ///< of the exact vertex; its root is off by at most `error`
  double error = 0;              ///< the exact vertex is at most this far from `at`: VoronoiRoadmap guarantee 3
};

/// The points with the same two nearest sites, from one vertex to another: a piece of a line or a parabola.
struct VoronoiEdge {
  enum class Kind : std::uint8_t { line, parabola };
  /// Where clearance has its minimum inside the edge: half the distance of the sites.
  enum class Gate : std::uint8_t {
    none,     ///< nowhere: clearance grows from one end to the other
    foot,     ///< at `foot`, on the shortest segment between the sites
    parallel  ///< everywhere: the sites are parallel pieces
  };

  std::uint32_t from = 0;
  std::uint32_t to = 0;
  std::array<std::uint32_t, 2> sites{};  ///< indices into sites(), ascending
  Kind kind = Kind::line;
  Gate gate = Gate::none;
  Point control;      ///< of the quadratic Bezier curve from `from` to `to`; of a line the middle
  double foot = 0.5;  ///< Gate::foot: the parameter of the curve there
  double length = 0;  ///< to about 1e-13 of itself and the errors of both ends
  /// The least on the edge: at a gate the nearest double to the exact value, else the lesser end's
  double clearance = 0;
  /// the edge's gate among all gates by exact clearance, equal ones equal; kNone without a gate
  std::uint32_t rank = kNone;
};

/// The points of a chain of curves, no farther than `tolerance` > 0 from it (or 65536 to a curve); its joints are among
/// them.
std::vector<Point> sampled(const std::vector<Bezier>& chain, double tolerance);

/// A point of an edge, and how a robot gets onto it.
struct VoronoiJunction {
  std::uint32_t edge = 0;
  double parameter = 0;  ///< of the edge's curve, 0 .. 1
  Point at;
};

/// The Voronoi diagram of the constraints of a FreeSpace, restricted to the free inside. Immutable.
///
///  1. Edges are what has two or more nearest sites: the medial axis and the bisectors at reflex corners are kept. Left
///     out are the edges between a piece and its own end (they end on that end, and nothing is gained by following
///     them), and whatever lies in obstacles or outside. An edge that runs into a convex corner is kept up to the
///     corner, a vertex of clearance 0; corners on different sides of a joint are different vertices, so no path slips
///     through.
///  2. Which sites an edge has, which edges meet, and which have length 0 (they are contracted, also where many sites
///     are cocircular, as in grids) is decided exactly, by CGAL's segment Delaunay graph with filtered predicates.
///  3. Vertices are rounded. VoronoiVertex::error is proven where Kantorovich's theorem applies (everywhere but in
///     nearly degenerate corners), infinite elsewhere; max_error() is the largest.
///  4. Clearance never has a minimum at an inner vertex of a way through the diagram, only at a gate: round a vertex at
///     most one edge leads upwards (its nearest points leave at most one gap beyond 180 degrees; a gap of 180 degrees
///     is the foot of a gate). So the clearance of a way is that of its gates and its two ends, and gates are compared
///     exactly (a squared distance of two sites is rational). A foot closer to the end of an edge than the end's error
///     counts as on it: that takes at most error^2 / clearance off.
///  5. Whatever FreeSpace::clearance counts is a wall here, so openings and limits of the world are.
///  6. Same input, same output. Vertices are ordered by position, edges by vertices, then sites.
/// Never compare numbers of vertices or edges with another diagram's. Build: O(n log n) expected, n pieces; 0.3 s for a
/// 100 x 100 maze.
class VoronoiRoadmap {
 public:
  /// Curves are shaped by `jobs` threads, the calling one among them; the diagram is the same for any number. Told are
  /// the sites that are in it.
  explicit VoronoiRoadmap(const FreeSpace& space, unsigned jobs = 1, const TellProgress& tell = {});

  const FreeSpace& space() const;
  const std::vector<VoronoiSite>& sites() const;
  const std::vector<VoronoiVertex>& vertices() const;
  const std::vector<VoronoiEdge>& edges() const;
  double max_error() const;

  std::span<const std::uint32_t> edges_at(std::uint32_t vertex) const;  ///< ascending
  /// The site as a segment; an end is a segment from itself to itself.
  Segment segment(std::uint32_t site) const;

  Bezier curve(const VoronoiEdge& edge) const;
  /// The nearest points of both sites, as seen from the gate: what stands on its two sides. Precondition: it has a
  /// gate.
  std::array<Point, 2> posts(const VoronoiEdge& edge) const;
  /// The lowest rank of a gate with clearance >= c >= 0, exactly; the number of ranks when there is none. O(log n).
  std::uint32_t first_rank(double c) const;
  /// Likewise with a clearance of at least that of a point from a constraint.
  std::uint32_t first_rank(Point p, std::uint32_t constraint) const;

  /// Where p comes to the diagram when it moves straight away from its nearest constraint; its clearance grows on the
  /// way. Usually one point. Of a p on a wall, one for each free side; of a p at an end of pieces, straight off each of
  /// them, and the ends of the edges around that end (O(n) then).
  /// Precondition: p is not outside. The leg is straight, the junction as exact as the edge's vertices.
  std::vector<VoronoiJunction> join(Point p) const;

 private:
  std::uint32_t first_rank_as_far(const Segment& s, const Segment& t) const;

  struct Impl;
  std::shared_ptr<const Impl> impl_;
};

}  // namespace taut
