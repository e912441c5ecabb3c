#include <taut/roadmaps/detail/voronoi_diagram.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <stdexcept>

#include <taut/geometry/segment_distance.h>
#include <taut/roadmaps/detail/voronoi_graph.h>

namespace taut::detail {

namespace {

/// The doubles in their order, numbered from 0.
double nth_double(std::int64_t n) { return n < 0 ? -std::bit_cast<double>(-n) : std::bit_cast<double>(n); }
std::int64_t number_of(double v) {
  return v < 0 ? -std::bit_cast<std::int64_t>(-v) : std::bit_cast<std::int64_t>(std::abs(v));
}

/// 1e200, beyond what a diagram's doubles can tell from infinity.
constexpr auto kFarthest = std::bit_cast<std::int64_t>(1e200);
std::int64_t doubled(std::int64_t step) { return std::min(step, std::int64_t{1} << 61) * 2; }
std::int64_t stepped(std::int64_t n, std::int64_t step) {
  if (step < 0) return n < -kFarthest - step ? -kFarthest : n + step;
  return n > kFarthest - step ? kFarthest : n + step;
}

class Builder {
 public:
  explicit Builder(std::span<const Constraint> pieces) : ends_(ends_of(pieces)), number_(ends_) {
    for (const Constraint& c : pieces) {
      result_.sites.push_back({c.a, c.b});
      result_.ends.push_back({number_.of(c.a), number_.of(c.b)});
      const auto& [a, b] = result_.ends.back();
      pairs_.push_back(std::minmax<std::size_t>({a, b}));
    }
    for (const Point p : ends_) result_.sites.push_back({p, p});
    first_piece_.resize(ends_.size() + 1);
    for (const Pair& pair : pairs_) ++first_piece_[pair.first + 1];
    std::partial_sum(first_piece_.begin(), first_piece_.end(), first_piece_.begin());
    pieces_.resize(pairs_.size());
    std::vector<std::uint32_t> next = first_piece_;
    for (std::uint32_t i = 0; i < pairs_.size(); ++i) pieces_[next[pairs_[i].first]++] = i;
  }

  VoronoiDiagram build(const TellProgress& tell) && {
    insert(tell);
    collect_faces();
    contract();
    keep_edges();
    return std::move(result_);
  }

 private:
  using Pair = std::pair<std::size_t, std::size_t>;

  static std::vector<Point> ends_of(std::span<const Constraint> pieces) {
    std::vector<Point> ends;
    ends.reserve(2 * pieces.size());
    for (const Constraint& c : pieces) ends.insert(ends.end(), {c.a, c.b});
    std::sort(ends.begin(), ends.end());
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    return ends;
  }

  /// Graph::insert_segments, which tells nobody how far it is.
  void insert(const TellProgress& tell) {
    ProgressCount inserted("sites", ends_.size() + pairs_.size(), tell);
    std::vector<Kernel::Point_2> points;
    for (const Point p : ends_) points.emplace_back(p.x, p.y);
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto at = CGAL::make_property_map(points);
    CGAL::spatial_sort(order.begin(), order.end(), CGAL::Spatial_sort_traits_adapter_2<Traits, decltype(at)>(at));
    std::vector<Graph::Vertex_handle> vertices(points.size());
    Graph::Vertex_handle near;
    for (const std::size_t i : order) {
      vertices[i] = near = graph_.insert(points[i], near);
      inserted.add();
    }
    for (const auto& [a, b] : pairs_) {
      graph_.insert(vertices[a], vertices[b]);
      inserted.add();
    }
  }

  std::uint32_t site_of(Graph::Vertex_handle v) const {
    const auto site = v->site();
    const auto index = [&](const Kernel::Point_2& p) { return number_.of({p.x(), p.y()}); };
    if (site.is_point()) return static_cast<std::uint32_t>(pairs_.size()) + index(site.point());
    const Pair pair = std::minmax<std::size_t>({index(site.source()), index(site.target())});
    const auto* piece = &pieces_[first_piece_[pair.first]];
    while (pairs_[*piece] != pair) ++piece;
    return *piece;
  }

  void collect_faces() {
    for (auto v = graph_.finite_vertices_begin(); v != graph_.finite_vertices_end(); ++v) v->number = site_of(v);
    for (auto f = graph_.finite_faces_begin(); f != graph_.finite_faces_end(); ++f) {
      f->number = static_cast<std::uint32_t>(found_.size());
      std::array<Segment, 3> sites;
      for (int i = 0; i < 3; ++i) sites[i] = result_.sites[f->vertex(i)->number];
      found_.push_back(point(sites, f));
    }
    cluster_.resize(found_.size());
    std::iota(cluster_.begin(), cluster_.end(), 0u);
  }

  /// Nearly parallel sites, or coordinates much larger than what they differ by, can leave doubles without an answer
  /// that is proven; exact predicates have one.
  VoronoiPoint point(const std::array<Segment, 3>& sites, Graph::Face_handle f) const {
    if (joint(sites)) return voronoi_point(sites, Point{});
    const VoronoiPoint found = voronoi_point(sites, [&] { return guess(f); });
    if (is_known(found) && std::isfinite(found.error)) return found;
    return exact_point(sites, f, is_known(found) ? found.at : sites[0].a).value_or(found);
  }

  static bool is_known(const VoronoiPoint& p) {
    return p.clearance > 0 && std::isfinite(p.at.x + p.at.y + p.clearance);
  }

  /// Nothing where CGAL has no formula: two sites on one line.
  std::optional<VoronoiPoint> exact_point(const std::array<Segment, 3>& sites, Graph::Face_handle f, Point near) const
      try {
    const auto x = around(f, {1, 0}, near.x), y = around(f, {0, 1}, near.y);
    if (!x || !y) return std::nullopt;
    const Point at{x->lo, y->lo};
    const double error = 1.0001 * std::hypot(x->hi - x->lo, y->hi - y->lo);
    VoronoiPoint again = voronoi_point(sites, at);
    const double apart = std::hypot(again.at.x - at.x, again.at.y - at.y);
    if (!is_known(again) || apart > error) return VoronoiPoint{at, segment_distance({at, at}, sites[0]), error};
    again.error = std::min(again.error, apart + error);
    return again;
  } catch (const CGAL::Failure_exception&) {
    return std::nullopt;
  }

  struct Around {
    double lo, hi;
  };

  /// The neighbouring doubles around a coordinate of the vertex: steps that grow, from `near` on, until it lies between
  /// two, then halving. On which side of a double it lies is one of CGAL's predicates, exact and without a root.
  std::optional<Around> around(Graph::Face_handle f, Point axis, double near) const {
    using Site = Traits::Site_2;
    const auto predicate = graph_.geom_traits().oriented_side_2_object();
    const Site along = Site::construct_site_2(Kernel::Point_2(0, 0), Kernel::Point_2(axis.x, axis.y));
    const auto side = [&](std::int64_t n) {
      const double v = nth_double(n);
      const Site here = Site::construct_site_2(Kernel::Point_2(v * axis.x, v * axis.y));
      return int(predicate(f->vertex(0)->site(), f->vertex(1)->site(), f->vertex(2)->site(), along, here));
    };
    std::int64_t lo = std::clamp(number_of(near), -kFarthest, kFarthest), hi = lo;
    for (std::int64_t step = 1; side(lo) > 0; step = doubled(step), lo = stepped(lo, -step))
      if (lo == -kFarthest) return std::nullopt;
    for (std::int64_t step = 1; side(hi) < 0; step = doubled(step), hi = stepped(hi, step))
      if (hi == kFarthest) return std::nullopt;
    while (lo + 1 < hi) {
      const std::int64_t middle = std::midpoint(lo, hi);
      const int s = side(middle);
      if (s >= 0) hi = middle;
      if (s <= 0) lo = middle;
    }
    return Around{nth_double(lo), nth_double(hi)};
  }

  /// CGAL divides by zero when two of the sites are on one line; then voronoi_point has to do without.
  Point guess(Graph::Face_handle f) const {
    try {
      const Kernel::Point_2 p = graph_.primal(f);
      return {p.x(), p.y()};
    } catch (const CGAL::Failure_exception&) {
      return {NAN, NAN};
    }
  }

  /// The edges to keep or contract, and those to contract contracted. Of the points of a cluster, which are one
  /// exactly, the one known best stays.
  void contract() {
    for (auto e = graph_.finite_edges_begin(); e != graph_.finite_edges_end(); ++e) {
      const auto f = e->first, g = f->neighbor(e->second);
      if (graph_.is_infinite(f) || graph_.is_infinite(g)) continue;
      const std::uint32_t s = f->vertex(Graph::ccw(e->second))->number, t = f->vertex(Graph::cw(e->second))->number;
      if (is_own_end(result_.sites[s], result_.sites[t]) || is_own_end(result_.sites[t], result_.sites[s])) continue;
      result_.edges.push_back({f->number, g->number, {std::min(s, t), std::max(s, t)}});
      if (!has_no_length(*e, f->number, g->number, s, t)) continue;
      const std::uint32_t a = root(f->number), b = root(g->number);
      const bool first = found_[a].error != found_[b].error ? found_[a].error < found_[b].error : a < b;
      cluster_[first ? b : a] = first ? a : b;
    }
  }

  bool has_no_length(const Graph::Edge& e, std::uint32_t f, std::uint32_t g, std::uint32_t s, std::uint32_t t) const {
    if (go_straight_on(result_.sites[s], result_.sites[t])) return true;
    const VoronoiPoint &p = found_[f], &q = found_[g];
    if (std::hypot(p.at.x - q.at.x, p.at.y - q.at.y) > (p.error + q.error) * 1.0001) return false;
    // A vertex in a corner stays there: corners at one joint are different places, and no circle defines them.
    if ((p.clearance == 0 && p.error == 0) || (q.clearance == 0 && q.error == 0)) return false;
    const auto face = e.first;
    return graph_.geom_traits().is_degenerate_edge_2_object()(
        face->vertex(Graph::ccw(e.second))->site(), face->vertex(Graph::cw(e.second))->site(),
        face->vertex(e.second)->site(), graph_.data_structure().mirror_vertex(face, e.second)->site());
  }

  std::uint32_t root(std::uint32_t f) {
    while (cluster_[f] != f) f = cluster_[f] = cluster_[cluster_[f]];
    return f;
  }

  void keep_edges() {
    for (VoronoiDiagram::Edge& e : result_.edges) e.from = root(e.from), e.to = root(e.to);
    std::erase_if(result_.edges, [](const VoronoiDiagram::Edge& e) { return e.from == e.to; });
    result_.vertices = std::move(found_);
  }

  VoronoiDiagram result_;
  std::vector<Point> ends_;
  PointNumbers number_;
  std::vector<Pair> pairs_;
  std::vector<std::uint32_t> first_piece_, pieces_;  // by lower end
  Graph graph_;
  std::vector<VoronoiPoint> found_;
  std::vector<std::uint32_t> cluster_;
};

/// The largest coordinate is below 2 to this. Measured in that unit, products of coordinates, which go up to the 16th
/// degree, stay where doubles are good guesses, in a world of any size.
int exponent(std::span<const Constraint> pieces) {
  double largest = 0;
  for (const Constraint& c : pieces)
    for (const double v : {c.a.x, c.a.y, c.b.x, c.b.y}) largest = std::max(largest, std::abs(v));
  return std::ilogb(std::max(largest, std::numeric_limits<double>::min())) + 1;
}

Point scaled(Point p, int exponent) { return {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent)}; }

}  // namespace

VoronoiDiagram voronoi_diagram(std::span<const Constraint> pieces, const TellProgress& tell) {
  const int unit = exponent(pieces);
  std::vector<Constraint> in_unit(pieces.begin(), pieces.end());
  for (Constraint& c : in_unit) c.a = scaled(c.a, -unit), c.b = scaled(c.b, -unit);
  VoronoiDiagram diagram = Builder(in_unit).build(tell);
  for (Segment& s : diagram.sites) s = {scaled(s.a, unit), scaled(s.b, unit)};
  for (VoronoiPoint& v : diagram.vertices)
    v = {scaled(v.at, unit), std::ldexp(v.clearance, unit), std::ldexp(v.error, unit)};
  return diagram;
}

}  // namespace taut::detail
