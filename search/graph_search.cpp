#include <taut/search/graph_search.h>

#include <chrono>
#include <optional>

#include <boost/graph/astar_search.hpp>

#include <taut/search/detail/dijkstra.h>
#include <taut/search/detail/goal_estimate.h>
#include <taut/search/detail/graph_walks.h>
#include <taut/search/graph_heuristics.h>

namespace taut {

namespace {

using detail::Labels;
using detail::QueryGraph;
using detail::SearchState;
using Vertex = Roadmap::Vertex;

/// What is left from a vertex, rounded down. O(goals).
class Estimate {
 public:
  Estimate(const SearchState& state, GraphHeuristic heuristic) : state_(&state), heuristic_(heuristic) {}

  double operator()(Vertex v) const {
    return state_->graph.is_goal(v)
               ? 0
               : detail::estimate_below(heuristic_, state_->graph.query(), state_->labels.point(v));
  }

 private:
  const SearchState* state_;
  GraphHeuristic heuristic_;
};

struct GoalTaken {
  Vertex goal;
};
struct LimitReached {};

/// Counts expansions and ends the search, the only way Boost.Graph can be left early: by an exception.
class Expansions {
 public:
  Expansions(const QueryGraph& graph, const SearchLimits& limits, std::size_t& count)
      : graph_(&graph), limits_(&limits), count_(&count), begin_(Clock::now()) {}

  void operator()(Vertex v) const {
    if (graph_->is_goal(v)) throw GoalTaken{v};
    if (*count_ >= limits_->expansions || out_of_time()) throw LimitReached{};
    ++*count_;
  }

 private:
  using Clock = std::chrono::steady_clock;

  bool out_of_time() const {
    if (*count_ % 64 != 0 || limits_->seconds >= 1e9) return false;
    return std::chrono::duration<double>(Clock::now() - begin_).count() >= limits_->seconds;
  }

  const QueryGraph* graph_;
  const SearchLimits* limits_;
  std::size_t* count_;
  Clock::time_point begin_;
};

class AstarVisitor : public boost::astar_visitor<> {
 public:
  explicit AstarVisitor(Expansions expand) : expand_(expand) {}
  void examine_vertex(Vertex v, const QueryGraph&) { expand_(v); }

 private:
  Expansions expand_;
};

template <class Compare, class Combine>
void best_first(SearchState& state, GraphHeuristic heuristic, const Expansions& expand) {
  const Estimate estimate(state, heuristic);
  const Vertex start = state.graph.start();
  state.set_key(start, estimate(start));
  boost::astar_search_no_init(state.graph, start, estimate, AstarVisitor(expand), boost::dummy_property_map(),
                              detail::EntryMap{&state}, detail::LabelMap{&state},
                              boost::typed_identity_property_map<detail::Leg>(), state.colors, detail::SlotMap{&state},
                              Compare{&state}, Combine{&state}, 0, detail::Entry{});
}

void search(SearchState& state, GraphMethod method, const Expansions& expand) {
  switch (method.algorithm) {
    case GraphAlgorithm::astar: return best_first<detail::Compare, detail::Combine>(state, method.heuristic, expand);
    case GraphAlgorithm::dijkstra: return detail::dijkstra(state, expand);
    case GraphAlgorithm::bfs: return detail::breadth_first(state, expand);
    case GraphAlgorithm::dfs: return detail::depth_first(state, expand);
    case GraphAlgorithm::greedy:
      return best_first<detail::FirstStays, detail::EstimateAlone>(state, method.heuristic, expand);
  }
}

/// How it ended, and the goal it took.
struct Outcome {
  SearchStatus status = SearchStatus::none;
  std::optional<std::size_t> goal;
};

Outcome run(SearchState& state, GraphMethod method, const Expansions& expand) {
  try {
    search(state, method, expand);
  } catch (const GoalTaken& taken) {
    return {SearchStatus::found, taken.goal - state.graph.goal(0)};
  } catch (LimitReached) {
    return {SearchStatus::stopped, std::nullopt};
  }
  return {};
}

/// The goal with the shortest label, the first among equals; nothing when none has one.
std::optional<std::size_t> best_goal(const SearchState& state) {
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < state.graph.query().goals.size(); ++i) {
    const auto label = [&](std::size_t goal) { return state.label(state.graph.goal(goal)); };
    if (label(i) == Labels::kNone) continue;
    if (!best || state.labels.compare(state.labels.chain(label(i)), state.labels.chain(label(*best))) < 0) best = i;
  }
  return best;
}

}  // namespace

GraphSearchResult graph_search(const Roadmap& roadmap, const GraphQuery& query, GraphMethod method,
                               const SearchLimits& limits) {
  GraphSearchResult result;
  const QueryGraph graph(roadmap, query);
  SearchState state(graph);
  const Outcome outcome = run(state, method, Expansions(graph, limits, result.expanded));
  result.status = outcome.status;
  result.generated = state.reached();
  result.optimal = optimal_everywhere(method);
  const bool by_length = method.algorithm == GraphAlgorithm::astar || method.algorithm == GraphAlgorithm::dijkstra;
  if (const auto goal = by_length || !outcome.goal ? best_goal(state) : outcome.goal) {
    result.goal = *goal;
    result.path.points = state.labels.points(state.labels.chain(state.label(graph.goal(*goal))));
    result.path.length = Length(result.path.points);
  }
  if (result.optimal || method.algorithm != GraphAlgorithm::astar || outcome.status != SearchStatus::found)
    return result;
  GraphHeuristicVerdict verdict = heuristic_verdict(roadmap, query, method.heuristic);
  result.optimal = verdict.consistent;
  result.overestimate = verdict.overestimate;
  return result;
}

}  // namespace taut
