#include <taut/search/index.h>

#include <utility>

#include <fmt/format.h>

#include <taut/geometry/errors.h>
#include <taut/search/detail/index_builder.h>
#include <taut/search/detail/index_parts.h>

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
  if (const auto places = IntegerPlaces::of(tri.points)) {
    integers.emplace(graph.space(), *places);
    if (has_sights()) rays = ray_places(graph, *places);
  }
  bends.resize(graph.roadmap().vertex_count());
  for (std::uint32_t v = 0; v < bends.size(); ++v) {
    if (integers) bends[v].at = integers->at(tri.sectors[graph.sector(v)].vertex);
    bends[v].begin = image.begin()[v];
    bends[v].end = image.begin()[v + 1];
    while (bend_of_block.size() * kBlock < bends[v].end) bend_of_block.push_back(v);
  }
}

}  // namespace detail

Index::Index(FreeSpace space, std::size_t memory, const TellProgress& tell) {
  const VisibilityGraph graph(std::move(space), VisibilityKind::reduced, 1, tell);
  auto image = detail::index_bytes(graph, memory, std::nullopt, tell);
  if (!image)
    throw InputError(graph.space().world().source(), 0,
                     fmt::format("needs more than the {} bytes that its index may have", memory));
  const auto kept = std::make_shared<const std::vector<std::byte>>(std::move(*image));
  *this = Index(graph.space(), *kept, kept);
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
