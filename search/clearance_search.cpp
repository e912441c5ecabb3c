#include <taut/search/clearance_search.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>
#include <span>
#include <tuple>
#include <utility>

#include <taut/geometry/detail/segment_distance.h>
#include <taut/roadmaps/detail/voronoi_geometry.h>

namespace taut {

namespace {

constexpr double kFar = HUGE_VAL;

detail::Bezier bezier(const VoronoiCurve& c) { return {c.from, c.control, c.to}; }
VoronoiCurve reversed(const VoronoiCurve& c) { return {c.to, c.control, c.from}; }
VoronoiCurve straight(Point p, Point q) { return {p, {p.x + (q.x - p.x) / 2, p.y + (q.y - p.y) / 2}, q}; }

/// A way between two nodes; `rank` is its gate's, kNone when it has none.
struct Arc {
  std::uint32_t from;
  std::uint32_t to;
  std::uint32_t edge;  ///< kNone: a leg
  std::uint32_t rank;
  double length;
  VoronoiCurve curve;
};

/// Where an end of the query cuts an edge.
struct Cut {
  std::uint32_t edge;
  double parameter;
  Point at;
  std::uint32_t node;
};

/// One end of the query, and its exact place among the gates.
struct End {
  Point at;
  Clearance clearance;
  Segment wall;        ///< the nearest
  std::uint32_t rank;  ///< of the first gate at least as wide
};

/// A path and the rank of its narrowest gate, kNone without one.
struct Found {
  ClearancePath path;
  std::uint32_t rank;
};

Segment segment(const Constraint& c) { return {c.a, c.b}; }
Point doubled(Point p) { return {2 * p.x, 2 * p.y}; }

}  // namespace

struct ClearanceSearch::Impl {
  /// A way through the net: arcs as the search came by, last first.
  struct Tree {
    std::vector<std::uint32_t> arc;
    std::vector<double> length;
  };

  Impl(VoronoiRoadmap map_, Point start, Point goal) : map(std::move(map_)) {
    start_node = static_cast<std::uint32_t>(map.vertices().size());
    goal_node = start_node + 1;
    nodes = start_node + 2;
    for (const Point p : {start, goal}) {
      const Clearance c = map.space().clearance(p);
      ends.push_back({p, c, segment(map.space().constraints()[c.constraint]), map.first_rank(p, c.constraint)});
      join(p, static_cast<std::uint32_t>(start_node + ends.size() - 1));
    }
    cut_edges();
    index_arcs();
  }

  void join(Point p, std::uint32_t node) {
    for (const VoronoiJunction& j : map.join(p)) {
      const std::uint32_t at = nodes++;
      cuts.push_back({j.edge, j.parameter, j.at, at});
      arcs.push_back({node, at, kNone, kNone, std::hypot(j.at.x - p.x, j.at.y - p.y), straight(p, j.at)});
    }
  }

  void cut_edges() {
    std::sort(cuts.begin(), cuts.end(), [](const Cut& a, const Cut& b) {
      return std::tie(a.edge, a.parameter, a.node) < std::tie(b.edge, b.parameter, b.node);
    });
    auto cut = cuts.begin();
    for (std::uint32_t e = 0; e < map.edges().size(); ++e) {
      const auto first = cut;
      while (cut != cuts.end() && cut->edge == e) ++cut;
      add_edge(e, {first, cut});
    }
  }

  /// The edge in the pieces the cuts make of it.
  void add_edge(std::uint32_t index, std::span<const Cut> edge_cuts) {
    const VoronoiEdge& e = map.edges()[index];
    if (edge_cuts.empty()) return arcs.push_back({e.from, e.to, index, e.rank, e.length, map.curve(e)});
    double t = 0;
    std::uint32_t node = e.from;
    const auto add = [&](double until, std::uint32_t to) {
      const bool gate = e.gate == VoronoiEdge::Gate::parallel || (t <= e.foot && e.foot <= until);
      const detail::Bezier part = bezier(map.curve(e)).part(t, until);
      arcs.push_back({node, to, index, gate ? e.rank : kNone, part.length(), {part.from, part.control, part.to}});
      std::tie(t, node) = std::tuple(until, to);
    };
    for (const Cut& c : edge_cuts) add(c.parameter, c.node);
    add(1, e.to);
  }

  void index_arcs() {
    offsets.assign(nodes + 1, 0);
    for (const Arc& a : arcs)
      for (const std::uint32_t v : {a.from, a.to}) ++offsets[v + 1];
    for (std::uint32_t v = 0; v < nodes; ++v) offsets[v + 1] += offsets[v];
    arcs_at.resize(2 * arcs.size());
    std::vector<std::uint32_t> next(offsets.begin(), offsets.end() - 1);
    for (std::uint32_t a = 0; a < arcs.size(); ++a)
      for (const std::uint32_t v : {arcs[a].from, arcs[a].to}) arcs_at[next[v]++] = a;
  }

  /// Calls visit(arc, other end) for the arcs at v whose gate is at least as wide as `rank`.
  template <class Visit>
  void each_arc(std::uint32_t v, std::uint32_t rank, Visit visit) const {
    for (std::uint32_t i = offsets[v]; i < offsets[v + 1]; ++i) {
      const Arc& a = arcs[arcs_at[i]];
      if (a.rank >= rank) visit(arcs_at[i], a.from == v ? a.to : a.from);
    }
  }

  /// Dijkstra among gates at least as wide as `rank`.
  std::optional<Found> shortest_from(std::uint32_t rank) const {
    using Open = std::pair<double, std::uint32_t>;
    Tree tree{std::vector<std::uint32_t>(nodes, kNone), std::vector<double>(nodes, kFar)};
    std::priority_queue<Open, std::vector<Open>, std::greater<>> open;
    std::size_t expanded = 0;
    tree.length[start_node] = 0;
    open.push({0, start_node});
    while (!open.empty()) {
      const double length = open.top().first;
      const std::uint32_t v = open.top().second;
      open.pop();
      if (v == goal_node) return found(tree, expanded);
      if (length > tree.length[v]) continue;
      ++expanded;
      each_arc(v, rank, [&](std::uint32_t a, std::uint32_t w) {
        if (length + arcs[a].length >= tree.length[w]) return;
        tree.length[w] = length + arcs[a].length;
        tree.arc[w] = a;
        open.push({tree.length[w], w});
      });
    }
    return std::nullopt;
  }

  /// The widest bottleneck as a rank; kNone when no gate is passed, nothing when not connected.
  std::optional<std::uint32_t> bottleneck() const {
    using Open = std::pair<std::uint32_t, std::uint32_t>;
    std::vector<std::uint32_t> best(nodes, 0);
    std::vector<char> reached(nodes, 0);
    std::priority_queue<Open> open;
    open.push({kNone, start_node});
    while (!open.empty()) {
      const auto [rank, v] = open.top();
      open.pop();
      if (v == goal_node) return rank;
      if (std::exchange(reached[v], 1)) continue;
      each_arc(v, 0, [&, through = rank](std::uint32_t a, std::uint32_t w) {
        const std::uint32_t least = std::min(through, arcs[a].rank);
        if (reached[w] || (least < best[w])) return;
        best[w] = least;
        open.push({least, w});
      });
    }
    return std::nullopt;
  }

  Found found(const Tree& tree, std::size_t expanded) const {
    ClearancePath result;
    result.expanded = expanded;
    result.length = tree.length[goal_node];
    std::uint32_t narrowest = kNone;
    for (std::uint32_t v = goal_node; v != start_node;) {
      const Arc& a = arcs[tree.arc[v]];
      if (a.curve.from != a.curve.to) result.curves.push_back(a.to == v ? a.curve : reversed(a.curve));
      if (a.rank != kNone && (narrowest == kNone || a.rank <= arcs[narrowest].rank)) narrowest = tree.arc[v];
      v = a.to == v ? a.from : a.to;
    }
    std::reverse(result.curves.begin(), result.curves.end());
    result.pinch = pinch(narrowest);
    return {std::move(result), narrowest == kNone ? kNone : arcs[narrowest].rank};
  }

  Pinch pinch(std::uint32_t arc) const {
    const int last = detail::compare_segment_distances({ends[1].at, ends[1].at}, ends[1].wall, {ends[0].at, ends[0].at},
                                                       ends[0].wall) < 0;
    const End& end = ends[last];
    if (arc != kNone && compare(map.edges()[arcs[arc].edge], end) <= 0) return gate(map.edges()[arcs[arc].edge]);
    return {last ? Pinch::Where::goal : Pinch::Where::start,
            end.clearance.distance,
            {end.clearance.constraint, kNone},
            {detail::foot_on(end.wall, end.at), end.at}};
  }

  /// The sign of the gate's clearance minus the end's. The sites are twice as far from each other as from the gate.
  int compare(const VoronoiEdge& e, const End& end) const {
    const Point p = doubled(end.at);
    return detail::compare_segment_distances(map.segment(e.sites[0]), map.segment(e.sites[1]), {p, p},
                                             {doubled(end.wall.a), doubled(end.wall.b)});
  }

  Pinch gate(const VoronoiEdge& e) const {
    const auto wall = [&](int i) { return map.sites()[e.sites[i]].constraint; };
    return {Pinch::Where::gate, e.clearance, {wall(0), wall(1)}, map.posts(e)};
  }

  bool ends_keep(double c) const {
    return std::all_of(ends.begin(), ends.end(), [&](const End& e) {
      return detail::compare_segment_distances({e.at, e.at}, e.wall, {{0, 0}, {0, 0}}, {{c, 0}, {c, 0}}) >= 0;
    });
  }

  /// No way is wider than its ends, so a gate as wide as those is wide enough.
  std::uint32_t end_rank() const { return std::min(ends[0].rank, ends[1].rank); }

  VoronoiRoadmap map;
  std::uint32_t start_node = 0, goal_node = 0, nodes = 0;
  std::vector<End> ends;
  std::vector<Cut> cuts;
  std::vector<Arc> arcs;
  std::vector<std::uint32_t> offsets, arcs_at;
};

ClearanceSearch::ClearanceSearch(VoronoiRoadmap roadmap, Point start, Point goal)
    : impl_(std::make_shared<const Impl>(std::move(roadmap), start, goal)) {}

std::optional<ClearancePath> ClearanceSearch::shortest(double c) const {
  if (!impl_->ends_keep(c)) return std::nullopt;
  auto found = impl_->shortest_from(impl_->map.first_rank(c));
  return found ? std::optional(std::move(found->path)) : std::nullopt;
}

std::optional<ClearancePath> ClearanceSearch::widest() const {
  const auto rank = impl_->bottleneck();
  if (!rank) return std::nullopt;
  return std::move(impl_->shortest_from(std::min(*rank, impl_->end_rank()))->path);
}

std::vector<ClearanceTrade> ClearanceSearch::tradeoff() const {
  std::vector<ClearanceTrade> result;
  for (std::uint32_t rank = 0; rank <= impl_->end_rank();) {
    auto found = impl_->shortest_from(rank);
    if (!found) break;
    const double clearance = found->path.pinch.clearance;
    result.push_back({clearance, std::move(found->path)});
    if (found->rank >= impl_->end_rank()) break;
    rank = found->rank + 1;
  }
  return result;
}

}  // namespace taut
