#include <taut/search/detail/index_builder.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

#include <taut/search/detail/index_image.h>
#include <taut/search/detail/taut_legs.h>

namespace taut::detail {

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

/// No shortest path between two vertices is longer: twice the longest one from one vertex of each component.
double longest_way(const HubGraph& graph) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  std::vector<double> at(graph.size(), kFar);
  std::priority_queue<std::pair<double, std::uint32_t>, std::vector<std::pair<double, std::uint32_t>>, std::greater<>>
      open;
  double longest = 0;
  for (std::uint32_t root = 0; root < graph.size(); ++root) {
    if (at[root] != kFar) continue;
    open.emplace(at[root] = 0, root);
    while (!open.empty()) {
      const auto [length, v] = open.top();
      open.pop();
      if (length != at[v]) continue;
      longest = std::max(longest, length);
      for (std::uint32_t e = graph.first[v]; e < graph.first[v + 1]; ++e)
        if (const double further = length + graph.edges[e].length; further < at[graph.edges[e].to])
          open.emplace(at[graph.edges[e].to] = further, graph.edges[e].to);
    }
  }
  return 2 * longest;
}

constexpr std::size_t kSamples = 16;
constexpr std::size_t kLabelBytes = 12, kSightBytes = 10, kUpBytes = 28;

/// How many bends may have labels in so many bytes: n of them have about 1.3 * n^1.5, those of a core more.
std::size_t bends_in(std::size_t bytes, double labels_a_bend) {
  return static_cast<std::size_t>(std::pow(static_cast<double>(bytes) / kLabelBytes / labels_a_bend, 2.0 / 3));
}

class Builder {
 public:
  Builder(const VisibilityGraph& graph, std::size_t memory, const TellProgress& tell)
      : graph_(graph), memory_(memory), tell_(tell), places_(IntegerPlaces::of(tri().points)) {
    hubs_ = hub_graph(graph, TautLegs(graph), places_ ? &*places_ : nullptr);
  }

  std::optional<std::vector<std::byte>> image(std::optional<std::size_t> core_size) {
    if (core_size) return with_core(*core_size);
    if (hubs_.size() <= bends_in(memory_, 1.6))
      if (auto all = with_all_labels()) return all;
    const std::size_t ups = kUpBytes * 4 * hubs_.size();
    std::size_t core = bends_in(memory_ > 2 * ups ? memory_ - ups : memory_ / 2, 3.0);
    for (core = std::min<std::size_t>(core, hubs_.size() / 2); core >= 2; core = core * 3 / 4)
      if (auto part = with_core(core)) return part;
    return {};
  }

 private:
  const Triangulation& tri() const { return graph_.space().triangulation(); }

  /// With sights, or where these are too many, without.
  std::optional<std::vector<std::byte>> with_all_labels() const {
    const std::vector<std::uint32_t> bends = bend_places(graph_);
    std::optional<SightLists> sights;
    if (places_) sights = sight_lists(graph_, hubs_, *places_, memory_ / kSightBytes);
    const SightLists* const lists = sights ? &*sights : nullptr;
    HubTree tree(hubs_, lists, bends);
    const auto labels = hub_labels(hubs_, tree, lists, hub_order(hubs_, tree, kSamples), memory_ / kLabelBytes, tell_);
    if (!labels) return {};
    if (auto all = packed(hubs_, *labels, lists, nullptr)) return all;
    return packed(hubs_, *labels, nullptr, nullptr);
  }

  std::optional<std::vector<std::byte>> with_core(std::size_t size) const {
    const BendTurns turns(graph_, places_ ? &*places_ : nullptr);
    const Contraction below = contraction(hubs_, turns, size);
    std::vector<std::uint32_t> edge_of;
    const HubGraph core = core_graph(below, turns, edge_of);
    HubTree tree(core, nullptr, {});
    const auto labels = hub_labels(core, tree, nullptr, hub_order(core, tree, kSamples), memory_ / kLabelBytes, tell_);
    const LabelledCore labelled{below, turns, edge_of};
    return labels ? packed(core, *labels, nullptr, &labelled) : std::nullopt;
  }

  std::optional<std::vector<std::byte>> packed(const HubGraph& graph, const HubLabels& labels, const SightLists* sights,
                                               const LabelledCore* core) const {
    // What a climb to the core adds to labels.
    const double climb = core ? longest_way(hubs_) : 0;
    auto image =
        index_image(graph, labels, sights, core, space_print(tri()), tri().triangles.size(), climb + extent_of(tri()));
    if (image.size() > memory_) return {};
    return image;
  }

  const VisibilityGraph& graph_;
  std::size_t memory_;
  const TellProgress& tell_;
  std::optional<IntegerPlaces> places_;
  HubGraph hubs_;
};

}  // namespace

std::optional<std::vector<std::byte>> index_bytes(const VisibilityGraph& graph, std::size_t memory,
                                                  std::optional<std::size_t> core_size, const TellProgress& tell) {
  return Builder(graph, memory, tell).image(core_size);
}

}  // namespace taut::detail
