#include <taut/roadmaps/point_sights.h>

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include <taut/geometry/expects.h>
#include <taut/geometry/integer_places.h>
#include <taut/roadmaps/detail/sight.h>

namespace taut {

namespace {

using Place = IntegerPlaces::Place;
using detail::LatticeSight;
using Row = detail::SightRow<LatticeSight, true>;

std::vector<Place> places_of(const std::vector<Point>& points, const IntegerPlaces& lattice) {
  std::vector<Place> places(points.size());
  for (std::size_t v = 0; v < points.size(); ++v) lattice.find(points[v], places[v]);
  return places;
}

std::vector<std::uint32_t> vertices_of_sectors(const VisibilityGraph& graph) {
  std::vector<std::uint32_t> vertices(graph.space().triangulation().sectors.size());
  for (std::uint32_t s = 0; s < vertices.size(); ++s) vertices[s] = graph.vertex_of_sector(s);
  return vertices;
}

std::vector<std::uint32_t> sectors_of(const VisibilityGraph& graph) {
  std::vector<std::uint32_t> sectors(graph.roadmap().vertex_count());
  for (Roadmap::Vertex v = 0; v < sectors.size(); ++v) sectors[v] = graph.sector(v);
  return sectors;
}

}  // namespace

struct PointSights::Impl {
  explicit Impl(const VisibilityGraph& of) : graph(of) {
    const Triangulation& tri = graph.space().triangulation();
    if (graph.kind() == VisibilityKind::reduced) lattice = IntegerPlaces::of(tri.points);
    if (!lattice) return;
    places = places_of(tri.points, *lattice);
    sectors = sectors_of(graph);
    steps = detail::sight_steps(tri, LatticeSight(places), vertices_of_sectors(graph));
  }

  const VisibilityGraph& graph;
  std::optional<IntegerPlaces> lattice;  // the rest is empty where there is none
  std::vector<Place> places;             // by vertex of the triangulation
  std::vector<std::uint32_t> sectors;
  std::vector<detail::SightStep<Place>> steps;
};

PointSights::PointSights(const VisibilityGraph& graph) : impl_(std::make_shared<const Impl>(graph)) {}

struct PointSights::Finder::Impl {
  explicit Impl(std::shared_ptr<const PointSights::Impl> of)
      : sights(std::move(of)),
        row(sights->graph.space().triangulation(), LatticeSight(sights->places), sights->steps, sights->sectors) {}

  std::span<const Roadmap::Vertex> visible_from(Point p) {
    const Triangulation& tri = sights->graph.space().triangulation();
    const Location at = sights->graph.space().locate(p);
    TAUT_EXPECTS(at.kind != Location::Kind::outside);
    Place place{};
    if (at.kind == Location::Kind::vertex || !sights->lattice || !sights->lattice->find(p, place))
      return seen = sights->graph.visible_from(p);
    if (at.kind == Location::Kind::triangle) return row.find(place, std::array{std::pair{at.triangle, 3}});
    const std::uint32_t beyond = tri.neighbours[at.triangle][at.index];
    const std::array here{std::pair{at.triangle, at.index},
                          std::pair{beyond, beyond == kNone ? 3 : tri.mirror(at.triangle, at.index)}};
    return row.find(place, std::span(here).first(beyond != kNone && tri.free[beyond] ? 2 : 1));
  }

  std::shared_ptr<const PointSights::Impl> sights;
  Row row;
  std::vector<Roadmap::Vertex> seen;
};

PointSights::Finder::Finder(const PointSights& sights) : impl_(std::make_unique<Impl>(sights.impl_)) {}
PointSights::Finder::Finder(Finder&&) noexcept = default;
PointSights::Finder::~Finder() = default;

std::span<const Roadmap::Vertex> PointSights::Finder::visible_from(Point p) { return impl_->visible_from(p); }

}  // namespace taut
