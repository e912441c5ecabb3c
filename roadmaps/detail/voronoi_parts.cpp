#include <taut/roadmaps/detail/voronoi_parts.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

#include <taut/geometry/parallel.h>
#include <taut/geometry/segment_distance.h>
#include <taut/roadmaps/detail/voronoi_diagram.h>

namespace taut::detail {

namespace {

using Part = VoronoiSite::Part;
using Gate = VoronoiEdge::Gate;

bool is_point(const Segment& s) { return s.a == s.b; }
Point middle(Point p, Point q) { return {p.x + (q.x - p.x) / 2, p.y + (q.y - p.y) / 2}; }

/// Which vertices lie in free space. No edge passes a site, so one vertex of each connected part decides: the one
/// farthest from all sites, where rounding cannot matter.
class FreeParts {
 public:
  FreeParts(const FreeSpace& space, const VoronoiDiagram& diagram) : part_(diagram.vertices.size()) {
    std::iota(part_.begin(), part_.end(), 0u);
    for (const auto& e : diagram.edges) part_[root(e.from)] = root(e.to);
    const auto room = [&](std::uint32_t v) { return diagram.vertices[v].clearance - diagram.vertices[v].error; };
    std::vector<std::uint32_t> best(part_.size(), kNone);
    for (std::uint32_t v = 0; v < part_.size(); ++v)
      if (auto& b = best[root(v)]; b == kNone || room(v) > room(b)) b = v;
    free_.resize(part_.size());
    for (std::uint32_t v = 0; v < part_.size(); ++v)
      free_[v] = root(v) == v && room(best[v]) > 0 &&
                 space.locate(diagram.vertices[best[v]].at).kind != Location::Kind::outside;
  }

  bool contain(std::uint32_t v) { return free_[root(v)]; }

 private:
  std::uint32_t root(std::uint32_t v) {
    while (part_[v] != v) v = part_[v] = part_[part_[v]];
    return v;
  }

  std::vector<std::uint32_t> part_;
  std::vector<char> free_;
};

std::vector<VoronoiSite> sites_of(const FreeSpace& space, const VoronoiDiagram& diagram) {
  const auto n = static_cast<std::uint32_t>(space.constraints().size());
  std::vector<VoronoiSite> sites(diagram.sites.size());
  for (std::uint32_t i = n; i-- > 0;) {
    sites[i] = {i, Part::inside};
    sites[n + diagram.ends[i][1]] = {i, Part::b};
    sites[n + diagram.ends[i][0]] = {i, Part::a};
  }
  return sites;
}

/// Marks where the shortest segment between a site and a point site crosses the edge, when it does.
void find_foot(VoronoiEdge& e, const Segment& site, Point end, const VoronoiPoint& p, const VoronoiPoint& q) {
  const bool points = is_point(site);
  const Point foot =
      points ? middle(site.a, end) : end;  // where the edge, or its projection on the piece, starts to rise
  const double dx = points ? site.a.y - end.y : site.b.x - site.a.x;
  const double dy = points ? end.x - site.a.x : site.b.y - site.a.y;
  const double length = std::hypot(dx, dy);
  const auto along = [&](Point v) { return ((v.x - foot.x) * dx + (v.y - foot.y) * dy) / length; };
  const double rounding = 8e-16 * (p.clearance + q.clearance + length);
  const double first = along(p.at), last = along(q.at), sign = first < last ? 1 : -1;
  if (sign * first > p.error + rounding || sign * last < -(q.error + rounding)) return;
  e.gate = Gate::foot;
  e.foot = first == last ? 0.5 : std::clamp(first / (first - last), 0.0, 1.0);
}

/// From the lower end: which one the diagram has first depends on addresses, and the other direction rounds otherwise.
VoronoiEdge shaped(const VoronoiDiagram& diagram, VoronoiDiagram::Edge raw) {
  if (diagram.vertices[raw.to].at < diagram.vertices[raw.from].at) std::swap(raw.from, raw.to);
  const VoronoiPoint &p = diagram.vertices[raw.from], &q = diagram.vertices[raw.to];
  const Segment &s = diagram.sites[raw.sites[0]], &t = diagram.sites[raw.sites[1]];  // pieces come before ends
  VoronoiEdge e;
  std::tie(e.from, e.to, e.sites, e.control) = std::tuple(raw.from, raw.to, raw.sites, middle(p.at, q.at));
  if (is_point(t)) {
    find_foot(e, s, t.a, p, q);
    if (!is_point(s)) e.kind = VoronoiEdge::Kind::parabola, e.control = parabola_control(t.a, s, p.at, q.at);
  } else if (parallel(s, t)) {
    e.gate = Gate::parallel;
  }
  e.length = Bezier{p.at, e.control, q.at}.length();
  e.clearance = e.gate != Gate::none ? segment_distance(s, t) / 2 : std::min(p.clearance, q.clearance);
  return e;
}

/// The vertices in use, by position; corners at one point by their lowest site.
std::vector<std::uint32_t> vertex_order(const VoronoiDiagram& diagram, const std::vector<VoronoiEdge>& edges) {
  std::vector<std::array<std::uint32_t, 2>> lowest(diagram.vertices.size(), {kNone, kNone});
  for (const VoronoiEdge& e : edges)
    for (const std::uint32_t v : {e.from, e.to}) lowest[v] = std::min(lowest[v], e.sites);
  std::vector<std::tuple<Point, std::array<std::uint32_t, 2>, std::uint32_t>> keys;
  for (std::uint32_t v = 0; v < lowest.size(); ++v)
    if (lowest[v][0] != kNone) keys.emplace_back(diagram.vertices[v].at, lowest[v], v);
  std::sort(keys.begin(), keys.end());
  std::vector<std::uint32_t> order;
  order.reserve(keys.size());
  for (const auto& key : keys) order.push_back(std::get<2>(key));
  return order;
}

/// Edges by vertices, then sites.
std::vector<VoronoiEdge> renumbered(std::vector<VoronoiEdge> edges, const std::vector<std::uint32_t>& order,
                                    std::size_t vertices) {
  std::vector<std::uint32_t> number(vertices, kNone);
  for (std::uint32_t i = 0; i < order.size(); ++i) number[order[i]] = i;
  std::vector<std::uint32_t> next(order.size() + 1);
  for (VoronoiEdge& e : edges) {
    std::tie(e.from, e.to) = std::tuple(number[e.from], number[e.to]);
    if (e.from > e.to) std::swap(e.from, e.to), e.foot = 1 - e.foot;
    ++next[e.from + 1];
  }
  std::partial_sum(next.begin(), next.end(), next.begin());
  const std::vector<std::uint32_t> starts = next;
  std::vector<VoronoiEdge> sorted(edges.size());
  for (const VoronoiEdge& e : edges) sorted[next[e.from]++] = e;
  const auto key = [](const VoronoiEdge& e) { return std::tuple(e.to, e.sites); };
  for (std::size_t v = 0; v < order.size(); ++v)
    std::sort(sorted.begin() + starts[v], sorted.begin() + starts[v + 1],
              [&](const VoronoiEdge& a, const VoronoiEdge& b) { return key(a) < key(b); });
  return sorted;
}

/// Gates in exact order of clearance. The nearest double orders them but for ties, and most ties are equal exactly.
class Ranking {
 public:
  explicit Ranking(VoronoiParts& parts) : parts_(parts) {
    std::vector<std::uint32_t> gates;
    for (std::uint32_t e = 0; e < parts.edges.size(); ++e)
      if (parts.edges[e].gate != Gate::none) gates.push_back(e);
    sort_by_clearance(gates);
    for (auto first = gates.begin(); first != gates.end();) {
      const auto last = std::find_if(first, gates.end(), [&](std::uint32_t e) { return clear(e) != clear(*first); });
      if (std::any_of(first, last, [&](std::uint32_t e) { return order(*first, e) != 0; }))
        std::stable_sort(first, last, [&](std::uint32_t a, std::uint32_t b) { return order(a, b) < 0; });
      for (; first != last; ++first) give_rank(*first);
    }
  }

 private:
  /// Stable: `gates` ascend.
  void sort_by_clearance(std::vector<std::uint32_t>& gates) const {
    std::vector<std::pair<double, std::uint32_t>> keys;
    keys.reserve(gates.size());
    for (const std::uint32_t e : gates) keys.emplace_back(clear(e), e);
    std::sort(keys.begin(), keys.end());
    std::transform(keys.begin(), keys.end(), gates.begin(), [](const auto& key) { return key.second; });
  }

  double clear(std::uint32_t e) const { return parts_.edges[e].clearance; }

  int order(std::uint32_t a, std::uint32_t b) const {
    const auto &s = parts_.edges[a].sites, &t = parts_.edges[b].sites;
    if (s == t) return 0;
    return compare_segment_distances(parts_.segment(s[0]), parts_.segment(s[1]), parts_.segment(t[0]),
                                     parts_.segment(t[1]));
  }

  void give_rank(std::uint32_t e) {
    auto& ranks = parts_.by_rank;
    if (ranks.empty() || clear(ranks.back()) != clear(e) || order(ranks.back(), e) != 0) ranks.push_back(e);
    parts_.edges[e].rank = static_cast<std::uint32_t>(ranks.size() - 1);
  }

  VoronoiParts& parts_;
};

/// Row i lists the edges that hold(edge) names i for.
template <class Hold>
EdgeRows rows(const std::vector<VoronoiEdge>& edges, std::size_t count, Hold hold) {
  EdgeRows result{std::vector<std::uint32_t>(count + 1), std::vector<std::uint32_t>(2 * edges.size())};
  for (const VoronoiEdge& e : edges)
    for (const std::uint32_t i : hold(e)) ++result.offsets[i + 1];
  std::partial_sum(result.offsets.begin(), result.offsets.end(), result.offsets.begin());
  std::vector<std::uint32_t> next(result.offsets.begin(), result.offsets.end() - 1);
  for (std::uint32_t e = 0; e < edges.size(); ++e)
    for (const std::uint32_t i : hold(edges[e])) result.edges[next[i]++] = e;
  return result;
}

/// Those in free space, in the order in which the diagram has them.
std::vector<VoronoiEdge> free_edges(const FreeSpace& space, const VoronoiDiagram& diagram, unsigned jobs) {
  FreeParts free(space, diagram);
  std::vector<std::uint32_t> chosen;
  for (std::uint32_t e = 0; e < diagram.edges.size(); ++e)
    if (free.contain(diagram.edges[e].from)) chosen.push_back(e);
  std::vector<VoronoiEdge> edges(chosen.size());
  const std::size_t length = block_length(chosen.size(), jobs, 256);
  each_in_parallel((chosen.size() + length - 1) / length, {jobs}, [&](std::size_t block) {
    for (std::size_t i = block * length; i < std::min(chosen.size(), (block + 1) * length); ++i)
      edges[i] = shaped(diagram, diagram.edges[chosen[i]]);
  });
  return edges;
}

}  // namespace

VoronoiParts voronoi_parts(const FreeSpace& space, unsigned jobs, const TellProgress& tell) {
  const VoronoiDiagram diagram = voronoi_diagram(space.constraints(), tell);
  VoronoiParts parts{space, sites_of(space, diagram), {}, free_edges(space, diagram, jobs), {}, {}, {}};
  const std::vector<std::uint32_t> order = vertex_order(diagram, parts.edges);
  for (const std::uint32_t v : order) {
    const VoronoiPoint& p = diagram.vertices[v];
    parts.vertices.push_back({p.at, p.clearance * p.clearance, p.error});
  }
  parts.edges = renumbered(std::move(parts.edges), order, diagram.vertices.size());
  Ranking{parts};
  parts.at_vertex = rows(parts.edges, order.size(), [](const VoronoiEdge& e) { return std::array{e.from, e.to}; });
  parts.beside_site = rows(parts.edges, parts.sites.size(), [](const VoronoiEdge& e) { return e.sites; });
  return parts;
}

}  // namespace taut::detail
