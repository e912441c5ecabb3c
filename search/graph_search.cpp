#include <taut/search/graph_search.h>

#include <chrono>

#include <boost/graph/astar_search.hpp>

#include <taut/search/detail/dijkstra.h>
#include <taut/search/detail/goal_distance.h>

namespace taut {

namespace {

using detail::Labels;
using detail::QueryGraph;
using detail::SearchState;
using Vertex = Roadmap::Vertex;

/// A lower bound of the distance to the nearest goal. O(goals).
class Heuristic {
 public:
  explicit Heuristic(const SearchState& state) : state_(&state) {}

  double operator()(Vertex v) const {
    return state_->graph.is_goal(v) ? 0 : detail::goal_distance_below(state_->graph.query(), state_->labels.point(v));
  }

 private:
  const SearchState* state_;
};

struct GoalTaken {};
struct LimitReached {};

/// Counts expansions and ends the search, the only way Boost.Graph can be left early: by an exception.
class Expansions {
 public:
  Expansions(const QueryGraph& graph, const SearchLimits& limits, std::size_t& count)
      : graph_(&graph), limits_(&limits), count_(&count), begin_(Clock::now()) {}

  void operator()(Vertex v) const {
    if (graph_->is_goal(v)) throw GoalTaken{};
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

void astar(SearchState& state, const Expansions& expand) {
  const Heuristic heuristic(state);
  const Vertex start = state.graph.start();
  state.set_key(start, heuristic(start));
  boost::astar_search_no_init(state.graph, start, heuristic, AstarVisitor(expand), boost::dummy_property_map(),
                              detail::EntryMap{&state}, detail::LabelMap{&state},
                              boost::typed_identity_property_map<detail::Leg>(), state.colors, detail::SlotMap{&state},
                              detail::Compare{&state}, detail::Combine{&state}, 0, detail::Entry{});
}

SearchStatus run(SearchState& state, GraphAlgorithm algorithm, const Expansions& expand) {
  try {
    algorithm == GraphAlgorithm::astar ? astar(state, expand) : detail::dijkstra(state, expand);
  } catch (GoalTaken) {
    return SearchStatus::found;
  } catch (LimitReached) {
    return SearchStatus::stopped;
  }
  return SearchStatus::none;
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

GraphSearchResult graph_search(const Roadmap& roadmap, const GraphQuery& query, GraphAlgorithm algorithm,
                               const SearchLimits& limits) {
  GraphSearchResult result;
  const QueryGraph graph(roadmap, query);
  SearchState state(graph);
  result.status = run(state, algorithm, Expansions(graph, limits, result.expanded));
  result.generated = state.reached();
  if (const auto goal = best_goal(state)) {
    result.goal = *goal;
    result.path.points = state.labels.points(state.labels.chain(state.label(graph.goal(*goal))));
    result.path.length = Length(result.path.points);
  }
  return result;
}

}  // namespace taut
