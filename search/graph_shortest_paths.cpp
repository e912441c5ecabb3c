#include <taut/search/detail/dijkstra.h>
#include <taut/search/graph_search.h>

namespace taut {

using detail::Labels;

struct GraphShortestPaths::Impl {
  Impl(std::shared_ptr<const Roadmap> map, Terminal from)
      : roadmap(std::move(map)),
        query{.start = std::move(from), .goals = {}, .direct = {}},
        graph(*roadmap, query),
        state(graph) {
    detail::dijkstra(state, [](Roadmap::Vertex) {});
  }

  std::shared_ptr<const Roadmap> roadmap;
  GraphQuery query;
  detail::QueryGraph graph;
  detail::SearchState state;
};

GraphShortestPaths::GraphShortestPaths(std::shared_ptr<const Roadmap> roadmap, Terminal start)
    : impl_(std::make_shared<Impl>(std::move(roadmap), std::move(start))) {}

std::optional<Path> GraphShortestPaths::path_to(const Terminal& goal, bool direct) const {
  const detail::SearchState& state = impl_->state;
  std::optional<Labels::Chain> best;
  if (direct) best = {Labels::kStart, goal.point};
  for (const Roadmap::Vertex v : goal.vertices) {
    const Labels::Chain chain{state.label(v), goal.point};
    if (chain.label != Labels::kNone && (!best || state.labels.compare(chain, *best) < 0)) best = chain;
  }
  if (!best) return std::nullopt;
  std::vector<Point> points = state.labels.points(*best);
  Length length(points);
  return Path{std::move(points), std::move(length)};
}

Roadmap::Vertex GraphShortestPaths::predecessor(Roadmap::Vertex v) const {
  const detail::SearchState& state = impl_->state;
  const Labels::Id parent = state.labels[state.label(v)].parent;
  return parent == Labels::kNone || parent == Labels::kStart ? kNoVertex : state.labels[parent].vertex;
}

bool GraphShortestPaths::reached(Roadmap::Vertex v) const { return impl_->state.label(v) != Labels::kNone; }

}  // namespace taut
