#include <taut/search/detail/prm_lazy.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace taut::detail {

using Vertex = Roadmap::Vertex;

namespace {

double distance(Point p, Point q) {
  const double dx = p.x - q.x, dy = p.y - q.y;
  return std::sqrt(dx * dx + dy * dy);
}

/// The order of the queue: the least key comes first, among equals the first by vertex and edge.
constexpr auto is_after = [](const auto& a, const auto& b) {
  return std::tie(a.key, a.to, a.edge) > std::tie(b.key, b.to, b.edge);
};

}  // namespace

PrmLazySearch::PrmLazySearch(PrmGrowth& growth, const GraphQuery& query)
    : growth_(growth), query_(query), offsets_(growth.points().size() + 1), edges_(2 * growth.edges().size()) {
  for (const PrmEdge& edge : growth.edges()) {
    ++offsets_[edge.u];
    ++offsets_[edge.v];
  }
  std::partial_sum(offsets_.begin(), offsets_.end(), offsets_.begin());
  for (std::size_t e = growth.edges().size(); e-- > 0;) {
    const auto number = static_cast<std::uint32_t>(e);
    edges_[--offsets_[growth.edges()[e].u]] = number;
    edges_[--offsets_[growth.edges()[e].v]] = number;
  }
}

std::span<const std::uint32_t> PrmLazySearch::edges_at(Vertex v) const {
  return {edges_.data() + offsets_[v], edges_.data() + offsets_[v + 1]};
}

std::optional<GraphSearchResult> PrmLazySearch::search(GraphAlgorithm algorithm) {
  if (!reaches_goal() && query_.direct.empty()) return std::nullopt;
  for (;;) {
    GraphSearchResult result = graph_search(growth_.roadmap(true), query_, algorithm);
    if (result.status != SearchStatus::found) return std::nullopt;
    if (test_legs(result.path)) return result;
  }
}

void PrmLazySearch::push(Vertex to, double length, std::uint32_t edge) {
  double rest = 1e300;
  for (const Terminal& goal : query_.goals) rest = std::min(rest, distance(growth_.points()[to], goal.point));
  open_.push_back({length + rest, length, to, edge});
  std::push_heap(open_.begin(), open_.end(), is_after);
}

/// Tests the edges that lie on candidate paths up to the shortest one, in doubles.
bool PrmLazySearch::reaches_goal() {
  constexpr double kFar = 1e300;
  std::vector<double> last_leg(growth_.points().size(), kFar);
  for (const Terminal& goal : query_.goals)
    for (const Vertex v : goal.vertices) last_leg[v] = std::min(last_leg[v], distance(growth_.points()[v], goal.point));
  std::vector<bool> closed(growth_.points().size());
  for (const Vertex v : query_.start.vertices) push(v, distance(query_.start.point, growth_.points()[v]), kNone);
  double best = kFar;
  while (!open_.empty() && open_.front().key < best) {
    const Open next = open_.front();
    std::pop_heap(open_.begin(), open_.end(), is_after);
    open_.pop_back();
    if (closed[next.to] || (next.edge != kNone && !growth_.test(next.edge))) continue;
    closed[next.to] = true;
    best = std::min(best, next.length + last_leg[next.to]);
    for (const std::uint32_t e : edges_at(next.to)) {
      const PrmEdge& edge = growth_.edges()[e];
      const Vertex to = edge.u == next.to ? edge.v : edge.u;
      if (!closed[to] && edge.state != PrmEdge::State::blocked)
        push(to, next.length + distance(growth_.points()[next.to], growth_.points()[to]), e);
    }
  }
  return best < kFar;
}

/// Tests every edge along a path. (Legs of the terminals are no edges; they have been.)
bool PrmLazySearch::test_legs(const Path& path) {
  const std::vector<Point>& points = growth_.points();
  std::vector<Vertex> order(points.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto by_point = [&](Vertex a, Vertex b) { return points[a] < points[b]; };
  std::sort(order.begin(), order.end(), by_point);
  bool all_free = true;
  for (std::size_t i = 0; i + 1 < path.points.size(); ++i) {
    const Point to = path.points[i + 1];
    auto at =
        std::lower_bound(order.begin(), order.end(), path.points[i], [&](Vertex v, Point p) { return points[v] < p; });
    for (; at != order.end() && points[*at] == path.points[i]; ++at)
      for (const std::uint32_t e : edges_at(*at)) {
        const PrmEdge& edge = growth_.edges()[e];
        if (points[edge.u == *at ? edge.v : edge.u] == to) all_free = growth_.test(e) && all_free;
      }
  }
  return all_free;
}

}  // namespace taut::detail
