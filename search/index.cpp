#include <taut/search/index.h>

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include <taut/geometry/errors.h>
#include <taut/search/detail/index_parts.h>
#include <taut/search/detail/taut_legs.h>

namespace taut {

namespace detail {

IndexParts::IndexParts(VisibilityGraph ends, std::span<const std::byte> image_bytes,
                       std::shared_ptr<const void> image_keeper)
    : graph(std::move(ends)),
      bytes(image_bytes),
      keeper(std::move(image_keeper)),
      image(bytes, space_print(graph.space().triangulation()), graph.roadmap().vertex_count(),
            graph.space().triangulation().points.size() + 2 * graph.roadmap().vertex_count()) {
  const Triangulation& tri = graph.space().triangulation();
  if (!image.sights_begin().empty()) {
    const auto places = IntegerPlaces::of(tri.points);
    integers.emplace(graph.space(), places.value());
    rays = ray_places(graph, *places);
  }
  bends.resize(graph.roadmap().vertex_count());
  for (std::uint32_t v = 0; v < bends.size(); ++v) {
    if (integers) bends[v].at = integers->at(tri.sectors[graph.sector(v)].vertex);
    bends[v].begin = image.begin()[v];
    bends[v].end = image.begin()[v + 1];
    while (bend_of_block.size() * kBlock < bends[v].end) bend_of_block.push_back(v);
  }
}

namespace {

/// The far ends of each bend's sector.
std::vector<std::uint32_t> bend_places(const VisibilityGraph& graph) {
  const Triangulation& tri = graph.space().triangulation();
  std::vector<std::uint32_t> places;
  for (std::uint32_t v = 0; v < graph.roadmap().vertex_count(); ++v) {
    const Triangulation::Sector& sector = tri.sectors[graph.sector(v)];
    places.insert(places.end(), {sector.vertex, sector.right, sector.left});
  }
  return places;
}

/// No two points of the world are farther from each other.
double extent_of(const Triangulation& tri) {
  if (tri.points.empty()) return 0;
  Box box{tri.points[0], tri.points[0]};
  for (const Point p : tri.points) {
    box.min = {std::min(box.min.x, p.x), std::min(box.min.y, p.y)};
    box.max = {std::max(box.max.x, p.x), std::max(box.max.y, p.y)};
  }
  return std::hypot(box.max.x - box.min.x, box.max.y - box.min.y);
}

constexpr std::size_t kSamples = 16;
constexpr std::size_t kLabelBytes = 12, kSightBytes = 16;

std::vector<std::byte> built(const VisibilityGraph& graph, std::size_t memory) {
  const Triangulation& tri = graph.space().triangulation();
  const std::optional<IntegerPlaces> places = IntegerPlaces::of(tri.points);
  const HubGraph hubs = hub_graph(graph, TautLegs(graph), places ? &*places : nullptr);
  std::optional<SightLists> sights;
  if (places) sights = sight_lists(graph, hubs, *places, memory / 2 / kSightBytes);
  const std::vector<std::uint32_t> bends = bend_places(graph);
  const SightLists* const lists = sights ? &*sights : nullptr;
  HubTree tree(hubs, lists, bends);
  const std::optional<HubLabels> labels =
      hub_labels(hubs, tree, lists, hub_order(hubs, tree, kSamples), memory / kLabelBytes);
  if (!labels) throw InputError(graph.space().world().source(), 0, "has too many bends for an index of this size");
  return index_image(hubs, *labels, lists, space_print(tri), tri.triangles.size(), extent_of(tri));
}

}  // namespace

}  // namespace detail

Index::Index(FreeSpace space, std::size_t memory) {
  const VisibilityGraph graph(std::move(space));
  const auto image = std::make_shared<const std::vector<std::byte>>(detail::built(graph, memory));
  if (image->size() > memory)
    throw InputError(graph.space().world().source(), 0,
                     fmt::format("needs {} bytes for its index, and may have {}", image->size(), memory));
  *this = Index(graph.space(), *image, image);
}

Index::Index(FreeSpace space, std::span<const std::byte> bytes, std::shared_ptr<const void> keeper) {
  const Triangulation& tri = space.triangulation();
  std::vector<Point> points;
  for (const Triangulation::Sector& sector : tri.sectors)
    if (sector.reflex && !sector.full) points.push_back(tri.points[sector.vertex]);
  VisibilityGraph ends(std::move(space), VisibilityKind::reduced, Roadmap(std::move(points), {}));
  parts_ = std::make_shared<const detail::IndexParts>(std::move(ends), bytes, std::move(keeper));
}

const FreeSpace& Index::space() const { return parts_->graph.space(); }
std::size_t Index::bend_count() const { return parts_->bends.size(); }
std::span<const std::byte> Index::bytes() const { return parts_->bytes; }

}  // namespace taut
