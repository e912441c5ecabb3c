#include <taut/search/graph_heuristics.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <taut/geometry/length.h>
#include <taut/geometry/triangulation.h>
#include <taut/search/detail/goal_estimate.h>
#include <taut/search/roadmap_distances.h>

namespace taut {

namespace {

using Vertex = Roadmap::Vertex;
using Legs = std::vector<Segment>;

double distance(Point p, Point q) { return std::hypot(p.x - q.x, p.y - q.y); }

Segment along_x(Point p, Point q) { return {p, {q.x, p.y}}; }
Segment along_y(Point p, Point q) { return {{p.x, p.y}, {p.x, q.y}}; }

std::strong_ordering compare(const Segment& a, const Segment& b) { return compare_lengths({&a, 1}, {&b, 1}); }

/// Is the norm of the leg its length?
bool is_leg_exact(GraphHeuristic heuristic, Point p, Point q) {
  if (p.x == q.x || p.y == q.y) return true;
  return heuristic == GraphHeuristic::octile && compare(along_x(p, q), along_y(p, q)) == 0;
}

bool are_legs_exact(GraphHeuristic heuristic, const Roadmap& roadmap, const GraphQuery& query) {
  const auto joined = [&](const Terminal& end) {
    return std::all_of(end.vertices.begin(), end.vertices.end(),
                       [&](Vertex v) { return is_leg_exact(heuristic, end.point, roadmap.point(v)); });
  };
  if (!joined(query.start) || !std::all_of(query.goals.begin(), query.goals.end(), joined)) return false;
  for (const std::size_t i : query.direct)
    if (!is_leg_exact(heuristic, query.start.point, query.goals[i].point)) return false;
  for (Vertex v = 0; v < roadmap.vertex_count(); ++v)
    for (const Vertex w : roadmap.neighbours(v))
      if (v < w && !is_leg_exact(heuristic, roadmap.point(v), roadmap.point(w))) return false;
  return true;
}

/// Is manhattan or octile of p and the goal more than the legs are long? Exact.
bool is_above(GraphHeuristic heuristic, Point p, Point goal, Legs legs) {
  const Segment x = along_x(p, goal), y = along_y(p, goal);
  if (heuristic == GraphHeuristic::manhattan) return compare_lengths(Legs{x, y}, legs) > 0;
  // more + sqrt(2) less - less: a leg of coordinates twice the same is sqrt(2) times as long.
  const bool flat = compare(x, y) >= 0;
  const Segment diagonal = flat ? Segment{{p.y, p.y}, {goal.y, goal.y}} : Segment{{p.x, p.x}, {goal.x, goal.x}};
  legs.push_back(flat ? y : x);
  return compare_lengths(Legs{flat ? x : y, diagonal}, legs) > 0;
}

/// The ways to the goals that are known, and where the estimate says more than they are long.
class WitnessSearch {
 public:
  WitnessSearch(GraphHeuristic heuristic, const Roadmap& roadmap, const GraphQuery& query)
      : heuristic_(heuristic), roadmap_(roadmap), query_(query), last_(roadmap.vertex_count(), Last{}) {
    std::vector<RoadmapSource> sources;
    for (std::size_t i = 0; i < query.goals.size(); ++i)
      for (const Vertex v : query.goals[i].vertices) {
        const double length = distance(roadmap.point(v), query.goals[i].point);
        if (length < last_[v].length) last_[v] = {length, i};
        sources.push_back({v, length});
      }
    distances_ = roadmap_distances(roadmap, sources);
  }

  std::optional<GraphOverestimate> find() const {
    std::vector<std::pair<double, Vertex>> excess;  // greatest first; the start counts as a vertex before all others
    const auto add = [&](Vertex place, double cost) {
      if (cost == HUGE_VAL) return;
      const double more = estimate(point(place)) - cost;
      if (more >= -kRounding * cost) excess.emplace_back(-more, place);
    };
    add(0, start_cost().length);
    for (Vertex v = 0; v < roadmap_.vertex_count(); ++v) add(v + 1, distances_.length[v]);
    std::sort(excess.begin(), excess.end());
    for (const auto& candidate : excess) {
      const auto place = candidate.second;
      const Legs legs = way(place);
      const bool above = std::all_of(query_.goals.begin(), query_.goals.end(), [&](const Terminal& goal) {
        return is_above(heuristic_, point(place), goal.point, legs);
      });
      if (above) return GraphOverestimate{point(place), estimate(point(place)), length_of(legs)};
    }
    return std::nullopt;
  }

 private:
  static constexpr double kRounding = 1e-9;  // of sums of many lengths: far more than they round

  /// The last leg of a way, from a vertex to a goal; or the first, from the start, by way of a vertex or straight.
  struct Last {
    double length = HUGE_VAL;
    std::size_t goal = 0;
  };
  struct First {
    double length = HUGE_VAL;
    Vertex vertex = kNone;
    std::size_t goal = 0;
  };

  Point point(Vertex place) const { return place == 0 ? query_.start.point : roadmap_.point(place - 1); }

  double estimate(Point p) const {
    double least = HUGE_VAL;
    for (const Terminal& goal : query_.goals)
      least = std::min(least, detail::estimate_between(heuristic_, p, goal.point));
    return least;
  }

  First start_cost() const {
    First best;
    for (const Vertex v : query_.start.vertices)
      if (const double length = distance(query_.start.point, roadmap_.point(v)) + distances_.length[v];
          length < best.length)
        best = {length, v, 0};
    for (const std::size_t i : query_.direct)
      if (const double length = distance(query_.start.point, query_.goals[i].point); length < best.length)
        best = {length, kNone, i};
    return best;
  }

  Legs way(Vertex place) const {
    Legs legs;
    Vertex v = place - 1;
    if (place == 0) {
      const First first = start_cost();
      if (first.vertex == kNone) return {{query_.start.point, query_.goals[first.goal].point}};
      legs.push_back({query_.start.point, roadmap_.point(first.vertex)});
      v = first.vertex;
    }
    for (; distances_.next[v] != kNone; v = distances_.next[v])
      legs.push_back({roadmap_.point(v), roadmap_.point(distances_.next[v])});
    legs.push_back({roadmap_.point(v), query_.goals[last_[v].goal].point});
    return legs;
  }

  static double length_of(const Legs& legs) {
    Length length;
    for (const Segment& leg : legs) length.add(leg.a, leg.b);
    return length.value();
  }

  GraphHeuristic heuristic_;
  const Roadmap& roadmap_;
  const GraphQuery& query_;
  std::vector<Last> last_;
  RoadmapDistances distances_;
};

}  // namespace

GraphHeuristicVerdict heuristic_verdict(const Roadmap& roadmap, const GraphQuery& query, GraphHeuristic heuristic) {
  if (optimal_everywhere({GraphAlgorithm::astar, heuristic}) || are_legs_exact(heuristic, roadmap, query))
    return {true, std::nullopt};
  return {false, WitnessSearch(heuristic, roadmap, query).find()};
}

}  // namespace taut
