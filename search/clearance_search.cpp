#include <taut/search/clearance_search.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <tuple>
#include <utility>

#include <taut/geometry/segment_distance.h>
#include <taut/roadmaps/bezier.h>
#include <taut/search/detail/clearance_net.h>

namespace taut {

namespace {

using detail::Arc;
using detail::ArcTree;

Bezier reversed(const Bezier& c) { return {c.to, c.control, c.from}; }
Bezier straight(Point p, Point q) { return {p, {p.x + (q.x - p.x) / 2, p.y + (q.y - p.y) / 2}, q}; }

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
  Impl(VoronoiRoadmap diagram, Point start, Point goal) : map(std::move(diagram)) {
    start_node = static_cast<std::uint32_t>(map.vertices().size());
    goal_node = start_node + 1;
    net.nodes = start_node + 2;
    for (const Point p : {start, goal}) {
      const Clearance c = map.space().clearance(p);
      ends.push_back({p, c, segment(map.space().constraints()[c.constraint]), map.first_rank(p, c.constraint)});
      join(p, static_cast<std::uint32_t>(start_node + ends.size() - 1));
    }
    cut_edges();
    net.index();
  }

  void join(Point p, std::uint32_t node) {
    for (const VoronoiJunction& j : map.join(p)) {
      const std::uint32_t at = net.nodes++;
      cuts.push_back({j.edge, j.parameter, j.at, at});
      net.arcs.push_back({node, at, kNone, kNone, std::hypot(j.at.x - p.x, j.at.y - p.y), straight(p, j.at)});
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
    if (edge_cuts.empty()) return net.arcs.push_back({e.from, e.to, index, e.rank, e.length, map.curve(e)});
    double t = 0;
    std::uint32_t node = e.from;
    const auto add = [&](double until, std::uint32_t to) {
      const bool gate = e.gate == VoronoiEdge::Gate::parallel || (t <= e.foot && e.foot <= until);
      const Bezier part = map.curve(e).part(t, until);
      net.arcs.push_back({node, to, index, gate ? e.rank : kNone, part.length(), part});
      std::tie(t, node) = std::tuple(until, to);
    };
    for (const Cut& c : edge_cuts) add(c.parameter, c.node);
    add(1, e.to);
  }

  /// Among gates at least as wide as `rank`.
  std::optional<Found> shortest_from(std::uint32_t rank) const {
    const ArcTree tree = shortest_ways(detail::WideArcs(net, rank), start_node, goal_node);
    if (!tree.reached) return std::nullopt;
    return found(tree);
  }

  Found found(const ArcTree& tree) const {
    ClearancePath result;
    result.expanded = tree.expanded;
    result.length = tree.length[goal_node];
    std::uint32_t narrowest = kNone;
    for (std::uint32_t v = goal_node; v != start_node;) {
      const Arc& a = net.arcs[tree.arc[v]];
      if (a.curve.from != a.curve.to) result.curves.push_back(a.to == v ? a.curve : reversed(a.curve));
      if (a.rank != kNone && (narrowest == kNone || a.rank <= net.arcs[narrowest].rank)) narrowest = tree.arc[v];
      v = a.to == v ? a.from : a.to;
    }
    std::reverse(result.curves.begin(), result.curves.end());
    result.pinch = pinch(narrowest);
    return {std::move(result), narrowest == kNone ? kNone : net.arcs[narrowest].rank};
  }

  Pinch pinch(std::uint32_t arc) const {
    const int last =
        compare_segment_distances({ends[1].at, ends[1].at}, ends[1].wall, {ends[0].at, ends[0].at}, ends[0].wall) < 0;
    const End& end = ends[last];
    if (arc != kNone && compare(map.edges()[net.arcs[arc].edge], end) <= 0)
      return gate(map.edges()[net.arcs[arc].edge]);
    return {last ? Pinch::Where::goal : Pinch::Where::start,
            end.clearance.distance,
            {end.clearance.constraint, kNone},
            {foot_on(end.wall, end.at), end.at}};
  }

  /// The sign of the gate's clearance minus the end's. The sites are twice as far from each other as from the gate.
  int compare(const VoronoiEdge& e, const End& end) const {
    const Point p = doubled(end.at);
    return compare_segment_distances(map.segment(e.sites[0]), map.segment(e.sites[1]), {p, p},
                                     {doubled(end.wall.a), doubled(end.wall.b)});
  }

  Pinch gate(const VoronoiEdge& e) const {
    const auto wall = [&](int i) { return map.sites()[e.sites[i]].constraint; };
    return {Pinch::Where::gate, e.clearance, {wall(0), wall(1)}, map.posts(e)};
  }

  bool ends_keep(double c) const {
    return std::all_of(ends.begin(), ends.end(), [&](const End& e) {
      return compare_segment_distances({e.at, e.at}, e.wall, {{0, 0}, {0, 0}}, {{c, 0}, {c, 0}}) >= 0;
    });
  }

  /// No way is wider than its ends, so a gate as wide as those is wide enough.
  std::uint32_t end_rank() const { return std::min(ends[0].rank, ends[1].rank); }

  VoronoiRoadmap map;
  detail::ClearanceNet net;
  std::uint32_t start_node = 0, goal_node = 0;
  std::vector<End> ends;
  std::vector<Cut> cuts;
};

ClearanceSearch::ClearanceSearch(VoronoiRoadmap roadmap, Point start, Point goal)
    : impl_(std::make_shared<const Impl>(std::move(roadmap), start, goal)) {}

std::optional<ClearancePath> ClearanceSearch::shortest(double c) const {
  if (!impl_->ends_keep(c)) return std::nullopt;
  auto found = impl_->shortest_from(impl_->map.first_rank(c));
  return found ? std::optional(std::move(found->path)) : std::nullopt;
}

std::optional<ClearancePath> ClearanceSearch::widest() const {
  const auto rank = widest_bottleneck(impl_->net, impl_->start_node, impl_->goal_node);
  if (!rank) return std::nullopt;
  return std::move(impl_->shortest_from(std::min(*rank, impl_->end_rank()))->path);
}

std::vector<ClearanceTrade> ClearanceSearch::tradeoff(const std::function<void(const ClearanceTrade&)>& told) const {
  std::vector<ClearanceTrade> result;
  for (std::uint32_t rank = 0; rank <= impl_->end_rank();) {
    auto found = impl_->shortest_from(rank);
    if (!found) break;
    const double clearance = found->path.pinch.clearance;
    result.push_back({clearance, std::move(found->path)});
    if (told) told(result.back());
    if (found->rank >= impl_->end_rank()) break;
    rank = found->rank + 1;
  }
  return result;
}

}  // namespace taut
