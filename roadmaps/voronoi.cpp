#include <taut/roadmaps/voronoi.h>

#include <algorithm>
#include <cmath>

#include <taut/geometry/segment_distance.h>
#include <taut/roadmaps/detail/voronoi_parts.h>

namespace taut {

namespace {

Point doubled(Point p) { return {2 * p.x, 2 * p.y}; }

}  // namespace

VoronoiRoadmap::VoronoiRoadmap(const FreeSpace& space, unsigned jobs, const TellProgress& tell)
    : impl_(std::make_shared<const Impl>(Impl{detail::voronoi_parts(space, jobs, tell)})) {}

const FreeSpace& VoronoiRoadmap::space() const { return impl_->space; }
const std::vector<VoronoiSite>& VoronoiRoadmap::sites() const { return impl_->sites; }
const std::vector<VoronoiVertex>& VoronoiRoadmap::vertices() const { return impl_->vertices; }
const std::vector<VoronoiEdge>& VoronoiRoadmap::edges() const { return impl_->edges; }
Segment VoronoiRoadmap::segment(std::uint32_t site) const { return impl_->segment(site); }

std::span<const std::uint32_t> VoronoiRoadmap::edges_at(std::uint32_t v) const { return impl_->at_vertex.row(v); }

double VoronoiRoadmap::max_error() const {
  double result = 0;
  for (const VoronoiVertex& v : impl_->vertices) result = std::max(result, v.error);
  return result;
}

Bezier VoronoiRoadmap::curve(const VoronoiEdge& edge) const {
  return {vertices()[edge.from].at, edge.control, vertices()[edge.to].at};
}

std::vector<Point> sampled(const std::vector<Bezier>& chain, double tolerance) {
  std::vector<Point> points;
  for (const Bezier& c : chain) {
    if (points.empty() || points.back() != c.from) points.push_back(c.from);
    // Between equally spaced parameters a quadratic Bezier curve leaves its chord by |second difference| / (4 n^2).
    const double bend = std::hypot(c.from.x - 2 * c.control.x + c.to.x, c.from.y - 2 * c.control.y + c.to.y);
    const double pieces = std::clamp(std::ceil(std::sqrt(bend / (4 * tolerance))), 1.0, 65536.0);
    for (double i = 1; i < pieces; ++i) points.push_back(c.at(i / pieces));
    if (points.back() != c.to) points.push_back(c.to);
  }
  return points;
}

std::array<Point, 2> VoronoiRoadmap::posts(const VoronoiEdge& edge) const {
  const Point at = impl_->curve(edge).at(edge.foot);
  return {foot_on(segment(edge.sites[0]), at), foot_on(segment(edge.sites[1]), at)};
}

std::uint32_t VoronoiRoadmap::first_rank(double c) const {
  return first_rank_as_far(Segment{{0, 0}, {0, 0}}, {{c, 0}, {c, 0}});
}

std::uint32_t VoronoiRoadmap::first_rank(Point p, std::uint32_t constraint) const {
  const Constraint& piece = space().constraints()[constraint];
  return first_rank_as_far({p, p}, {piece.a, piece.b});
}

/// The sites of a gate are twice as far from each other as from the gate.
std::uint32_t VoronoiRoadmap::first_rank_as_far(const Segment& s, const Segment& t) const {
  const Segment s2{doubled(s.a), doubled(s.b)}, t2{doubled(t.a), doubled(t.b)};
  const auto& ranks = impl_->by_rank;
  const auto narrower = [&](std::uint32_t e) {
    const auto& sites = edges()[e].sites;
    return compare_segment_distances(segment(sites[0]), segment(sites[1]), s2, t2) < 0;
  };
  return static_cast<std::uint32_t>(std::partition_point(ranks.begin(), ranks.end(), narrower) - ranks.begin());
}

}  // namespace taut
