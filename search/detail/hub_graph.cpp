#include <taut/search/detail/hub_graph.h>

#include <array>
#include <bit>
#include <cmath>
#include <numeric>

namespace taut::detail {

namespace {

/// Of a root: any number that has nothing to do with it.
std::uint64_t scattered(std::uint64_t v) {
  v = (v ^ (v >> 30)) * 0xbf58476d1ce4e5b9 + 0x9e3779b97f4a7c15;
  v = (v ^ (v >> 27)) * 0x94d049bb133111eb;
  return v ^ (v >> 31);
}

}  // namespace

/// n * root(d) with as small a d as comes cheap: sums that are equal with different d are told apart here, and found
/// equal by roots.
std::uint64_t root_print(std::int64_t dx, std::int64_t dy) {
  const std::int64_t common = std::gcd(dx, dy);
  if (common == 0) return 0;
  const std::int64_t a = dx / common, b = dy / common;
  auto n = static_cast<std::uint64_t>(std::abs(common)), d = static_cast<std::uint64_t>(a * a + b * b);
  // Other primes' squares divide no sum of the squares of coprime numbers.
  for (const std::uint64_t prime : {5, 13, 17, 29, 37, 41, 53, 61})
    for (; d % (prime * prime) == 0; d /= prime * prime) n *= prime;
  const auto root = static_cast<std::uint64_t>(std::llround(std::sqrt(static_cast<double>(d))));
  if (root * root == d) {
    n *= root;
    d = 1;
  }
  return n * scattered(d);
}

std::uint64_t root_print(Point p, Point q) {
  const twofold::Pair x = twofold::absolute_difference(p.x, q.x), y = twofold::absolute_difference(p.y, q.y);
  std::uint64_t print = 0;
  for (const double part : {x.high, x.low, y.high, y.low})
    print = scattered(print ^ std::bit_cast<std::uint64_t>(part + 0.0));
  return p == q ? 0 : print;
}

void HubGraph::find_backs() {
  std::vector<std::uint32_t> arriving_first(size() + std::size_t{1}, 0), arriving(edges.size()), edge_to(size());
  for (const Edge& edge : edges) ++arriving_first[edge.to + 1];
  for (std::uint32_t v = 0; v < size(); ++v) arriving_first[v + 1] += arriving_first[v];
  std::vector<std::uint32_t> next(arriving_first.begin(), arriving_first.end() - 1), from(edges.size());
  for (std::uint32_t v = 0; v < size(); ++v)
    for (std::uint32_t e = first[v]; e < first[v + 1]; ++e) {
      arriving[next[edges[e].to]++] = e;
      from[e] = v;
    }
  back.resize(edges.size());
  for (std::uint32_t v = 0; v < size(); ++v) {
    for (std::uint32_t e = first[v]; e < first[v + 1]; ++e) edge_to[edges[e].to] = e;
    for (std::uint32_t k = arriving_first[v]; k < arriving_first[v + 1]; ++k)
      back[arriving[k]] = edge_to[from[arriving[k]]];
  }
}

HubGraph hub_graph(const VisibilityGraph& graph, const TautLegs& legs, const IntegerPlaces* places) {
  HubGraph made;
  const Roadmap& roadmap = graph.roadmap();
  made.first.reserve(legs.vertex_count() + 1);
  made.edges.reserve(legs.size());
  made.low.reserve(legs.size());
  made.print.reserve(legs.size());
  std::vector<IntegerPlaces::Place> at(places ? legs.vertex_count() : 0);
  for (std::uint32_t v = 0; v < at.size(); ++v) places->find(roadmap.point(v), at[v]);
  const auto print = [&](std::uint32_t v, std::uint32_t w) {
    return places ? root_print(at[v][0] - at[w][0], at[v][1] - at[w][1])
                  : root_print(roadmap.point(v), roadmap.point(w));
  };
  made.first.push_back(0);
  for (std::uint32_t v = 0; v < legs.vertex_count(); ++v) {
    const TautLegs::Range all = legs.of(v);
    for (std::size_t e = all.first; e < all.last; ++e) {
      const std::uint32_t to = legs[e].to;
      const std::size_t from = legs.of(to).first;
      made.edges.push_back({legs[e].length, to, static_cast<std::uint32_t>(legs.right_of(e).last - from),
                            static_cast<std::uint32_t>(legs.left_of(e).first - from)});
      made.low.push_back(legs.length(e).low);
      made.print.push_back(print(v, to));
    }
    made.first.push_back(static_cast<std::uint32_t>(made.edges.size()));
  }
  made.find_backs();
  made.legs = [&roadmap](const HubGraph& hubs, std::uint32_t e, std::vector<Segment>& out) {
    out.push_back({roadmap.point(hubs.edges[hubs.back[e]].to), roadmap.point(hubs.edges[e].to)});
  };
  return made;
}

}  // namespace taut::detail
