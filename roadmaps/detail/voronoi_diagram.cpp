#include <taut/roadmaps/detail/voronoi_diagram.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel_with_sqrt.h>
#include <CGAL/Handle_hash_function.h>
#include <CGAL/Segment_Delaunay_graph_2.h>
#include <CGAL/Segment_Delaunay_graph_filtered_traits_2.h>
#include <CGAL/Segment_Delaunay_graph_traits_2.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <unordered_map>

#include <taut/geometry/detail/segment_distance.h>

namespace taut::detail {

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Traits = CGAL::Segment_Delaunay_graph_filtered_traits_without_intersections_2<Kernel, CGAL::Field_with_sqrt_tag>;
using Graph = CGAL::Segment_Delaunay_graph_2<Traits>;

class Builder {
 public:
  explicit Builder(std::span<const Constraint> pieces) {
    for (const Constraint& c : pieces) ends_.insert(ends_.end(), {c.a, c.b});
    std::sort(ends_.begin(), ends_.end());
    ends_.erase(std::unique(ends_.begin(), ends_.end()), ends_.end());
    for (const Constraint& c : pieces) {
      result_.sites.push_back({c.a, c.b});
      pairs_.push_back({std::min(end_index(c.a), end_index(c.b)), std::max(end_index(c.a), end_index(c.b))});
    }
    for (const Point p : ends_) result_.sites.push_back({p, p});
    for (std::uint32_t i = 0; i < pairs_.size(); ++i) piece_of_.push_back({pairs_[i], i});
    std::sort(piece_of_.begin(), piece_of_.end());
  }

  VoronoiDiagram build() && {
    insert();
    collect_faces();
    contract();
    collect_edges();
    return std::move(result_);
  }

 private:
  using Pair = std::pair<std::size_t, std::size_t>;

  std::size_t end_index(Point p) const { return std::lower_bound(ends_.begin(), ends_.end(), p) - ends_.begin(); }

  void insert() {
    std::vector<Kernel::Point_2> points;
    for (const Point p : ends_) points.push_back({p.x, p.y});
    graph_.insert_segments(points, pairs_.begin(), pairs_.end());
  }

  std::uint32_t site_of(Graph::Vertex_handle v) const {
    const auto site = v->site();
    const auto index = [&](const Kernel::Point_2& p) { return end_index({p.x(), p.y()}); };
    if (site.is_point()) return static_cast<std::uint32_t>(pairs_.size() + index(site.point()));
    const std::size_t s = index(site.source()), t = index(site.target());
    const Pair pair{std::min(s, t), std::max(s, t)};
    return std::lower_bound(piece_of_.begin(), piece_of_.end(), std::pair(pair, 0u))->second;
  }

  void collect_faces() {
    for (auto v = graph_.finite_vertices_begin(); v != graph_.finite_vertices_end(); ++v)
      site_[Graph::Vertex_handle(v)] = site_of(v);
    for (auto f = graph_.finite_faces_begin(); f != graph_.finite_faces_end(); ++f) {
      face_[Graph::Face_handle(f)] = static_cast<std::uint32_t>(found_.size());
      std::array<Segment, 3> sites;
      for (int i = 0; i < 3; ++i) sites[i] = result_.sites[site_.at(f->vertex(i))];
      found_.push_back(point(sites, f));
    }
    cluster_.resize(found_.size());
    std::iota(cluster_.begin(), cluster_.end(), 0u);
  }

  /// Nearly parallel sites can leave doubles without any answer; exact numbers have one.
  VoronoiPoint point(const std::array<Segment, 3>& sites, Graph::Face_handle f) const {
    if (joint(sites)) return voronoi_point(sites, {});
    const VoronoiPoint found = voronoi_point(sites, guess(f));
    if (is_known(found)) return found;
    return exact_point(sites).value_or(found);
  }

  static bool is_known(const VoronoiPoint& p) {
    return p.clearance > 0 && std::isfinite(p.at.x + p.at.y + p.clearance);
  }

  /// Nothing where CGAL has no formula: two sites on one line.
  static std::optional<VoronoiPoint> exact_point(const std::array<Segment, 3>& sites) try {
    const Point at = exact_vertex(sites);
    if (!std::isfinite(at.x + at.y)) return std::nullopt;
    const VoronoiPoint again = voronoi_point(sites, at);
    if (is_known(again) && std::isfinite(again.error)) return again;
    return VoronoiPoint{at, segment_distance({at, at}, sites[0]), 0x1p-50 * (std::abs(at.x) + std::abs(at.y))};
  } catch (const CGAL::Failure_exception&) {
    return std::nullopt;
  }

  static Point exact_vertex(const std::array<Segment, 3>& sites) {
    using Exact = CGAL::Exact_predicates_exact_constructions_kernel_with_sqrt;
    using ExactTraits = CGAL::Segment_Delaunay_graph_traits_without_intersections_2<Exact, CGAL::Field_with_sqrt_tag>;
    const auto exact = [](Point p) { return Exact::Point_2(p.x, p.y); };
    const auto site = [&](const Segment& s) {
      return s.a == s.b ? ExactTraits::Site_2::construct_site_2(exact(s.a))
                        : ExactTraits::Site_2::construct_site_2(exact(s.a), exact(s.b));
    };
    const auto p = ExactTraits().construct_svd_vertex_2_object()(site(sites[0]), site(sites[1]), site(sites[2]));
    return {CGAL::to_double(p.x()), CGAL::to_double(p.y())};
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

  /// Calls visit(edge, face, other face, site, site) for the edges to keep or contract.
  template <class Visit>
  void each_edge(Visit visit) const {
    for (auto e = graph_.finite_edges_begin(); e != graph_.finite_edges_end(); ++e) {
      const auto f = e->first, g = f->neighbor(e->second);
      if (graph_.is_infinite(f) || graph_.is_infinite(g)) continue;
      const std::uint32_t s = site_.at(f->vertex(Graph::ccw(e->second))), t = site_.at(f->vertex(Graph::cw(e->second)));
      if (is_own_end(result_.sites[s], result_.sites[t]) || is_own_end(result_.sites[t], result_.sites[s])) continue;
      visit(*e, face_.at(f), face_.at(g), s, t);
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

  /// Of the points of a cluster, which are one exactly, the one known best stays.
  void contract() {
    each_edge([&](const Graph::Edge& e, std::uint32_t f, std::uint32_t g, std::uint32_t s, std::uint32_t t) {
      if (!has_no_length(e, f, g, s, t)) return;
      const std::uint32_t a = root(f), b = root(g);
      const bool first = found_[a].error != found_[b].error ? found_[a].error < found_[b].error : a < b;
      cluster_[first ? b : a] = first ? a : b;
    });
  }

  void collect_edges() {
    result_.vertices = found_;
    each_edge([&](const Graph::Edge&, std::uint32_t f, std::uint32_t g, std::uint32_t s, std::uint32_t t) {
      if (root(f) != root(g)) result_.edges.push_back({root(f), root(g), {std::min(s, t), std::max(s, t)}});
    });
  }

  VoronoiDiagram result_;
  std::vector<Point> ends_;
  std::vector<Pair> pairs_;
  std::vector<std::pair<Pair, std::uint32_t>> piece_of_;
  Graph graph_;
  std::unordered_map<Graph::Vertex_handle, std::uint32_t, CGAL::Handle_hash_function> site_;
  std::unordered_map<Graph::Face_handle, std::uint32_t, CGAL::Handle_hash_function> face_;
  std::vector<VoronoiPoint> found_;
  std::vector<std::uint32_t> cluster_;
};

}  // namespace

VoronoiDiagram voronoi_diagram(std::span<const Constraint> pieces) { return Builder(pieces).build(); }

}  // namespace taut::detail
