#include <taut/search/roadmap_distances.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/graph/two_bit_color_map.hpp>

#include <taut/geometry/triangulation.h>
#include <taut/search/boost_graph.h>

namespace taut {

namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// A leg's length, kept until another leg is asked for: Boost.Graph asks two or three times in a row.
struct LegLengths {
  using key_type = RoadmapEdge;
  using value_type = double;
  using reference = double;
  using category = boost::readable_property_map_tag;

  struct Last {
    RoadmapEdge leg;
    double length = 0;
  };

  const Roadmap* roadmap;
  Last* last;

  friend double get(LegLengths map, const RoadmapEdge& leg) {
    if (map.last->leg == leg) return map.last->length;
    const Point p = map.roadmap->point(leg.from), q = map.roadmap->point(leg.to);
    *map.last = {leg, std::hypot(p.x - q.x, p.y - q.y)};
    return map.last->length;
  }
};

}  // namespace

RoadmapDistances roadmap_distances(const Roadmap& roadmap, std::span<const RoadmapSource> sources) {
  using Index = boost::typed_identity_property_map<Roadmap::Vertex>;
  const std::size_t n = roadmap.vertex_count();
  RoadmapDistances result{std::vector<double>(n, kInfinite), std::vector<Roadmap::Vertex>(n, kNone)};
  std::vector<Roadmap::Vertex> begin;
  for (const auto& [v, length] : sources) {
    if (result.length[v] == kInfinite) begin.push_back(v);
    result.length[v] = std::min(result.length[v], length);
  }
  LegLengths::Last last;
  boost::dijkstra_shortest_paths_no_init(
      roadmap, begin.begin(), begin.end(), boost::make_iterator_property_map(result.next.begin(), Index()),
      boost::make_iterator_property_map(result.length.begin(), Index()), LegLengths{&roadmap, &last}, Index(),
      std::less<>(), std::plus<>(), 0.0, boost::dijkstra_visitor<>(), boost::two_bit_color_map<Index>(n));
  return result;
}

}  // namespace taut
