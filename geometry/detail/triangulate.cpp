#include <taut/geometry/detail/triangulate.h>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/hilbert_sort.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include <taut/geometry/detail/written_integers.h>
#include <taut/geometry/written.h>

namespace taut::detail {

namespace {

using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
__extension__ typedef __int128 Int128;  // NOLINT(modernize-use-using): pedantic compilers take no other

/// Epick, but for the two predicates that a triangulation of integers below 2^29 asks all the time: CGAL's filters fail
/// on every cocircular quadruple, and a grid consists of them.
struct LatticeTraits : Epick {
  struct Orientation_2 {
    using result_type = CGAL::Orientation;
    result_type operator()(const Point_2& p, const Point_2& q, const Point_2& r) const {
      // Products below 2^60 need not be exact in double; their int64 is.
      const auto px = integer(p.x()), py = integer(p.y());
      const auto det = (integer(q.x()) - px) * (integer(r.y()) - py) - (integer(q.y()) - py) * (integer(r.x()) - px);
      return CGAL::sign(det);
    }
  };

  struct Side_of_oriented_circle_2 {
    using result_type = CGAL::Oriented_side;
    result_type operator()(const Point_2& p, const Point_2& q, const Point_2& r, const Point_2& s) const {
      const auto sx = integer(s.x()), sy = integer(s.y());
      const auto px = integer(p.x()) - sx, py = integer(p.y()) - sy, qx = integer(q.x()) - sx, qy = integer(q.y()) - sy,
                 rx = integer(r.x()) - sx, ry = integer(r.y()) - sy;
      const auto largest =
          std::max({std::abs(px), std::abs(py), std::abs(qx), std::abs(qy), std::abs(rx), std::abs(ry)});
      return largest < (1 << 14) ? side<std::int64_t>(px, py, qx, qy, rx, ry) : side<Int128>(px, py, qx, qy, rx, ry);
    }

   private:
    template <class Integer>
    static result_type side(Integer px, Integer py, Integer qx, Integer qy, Integer rx, Integer ry) {
      const Integer det = (px * px + py * py) * (qx * ry - qy * rx) - (qx * qx + qy * qy) * (px * ry - py * rx) +
                          (rx * rx + ry * ry) * (px * qy - py * qx);
      return det > 0 ? CGAL::ON_POSITIVE_SIDE : det < 0 ? CGAL::ON_NEGATIVE_SIDE : CGAL::ON_ORIENTED_BOUNDARY;
    }
  };

  Orientation_2 orientation_2_object() const { return {}; }
  Side_of_oriented_circle_2 side_of_oriented_circle_2_object() const { return {}; }

 private:
  static std::int64_t integer(double x) { return static_cast<std::int64_t>(x); }
};

/// Points that mean what was written.
struct WrittenTraits : Epick {
  struct Orientation_2 {
    using result_type = CGAL::Orientation;
    result_type operator()(const Point_2& p, const Point_2& q, const Point_2& r) const {
      return static_cast<result_type>(written::orientation(point(p), point(q), point(r)));
    }
  };

  struct Side_of_oriented_circle_2 {
    using result_type = CGAL::Oriented_side;
    result_type operator()(const Point_2& p, const Point_2& q, const Point_2& r, const Point_2& s) const {
      return static_cast<result_type>(written::side_of_circle(point(p), point(q), point(r), point(s)));
    }
  };

  Orientation_2 orientation_2_object() const { return {}; }
  Side_of_oriented_circle_2 side_of_oriented_circle_2_object() const { return {}; }

 private:
  static Point point(const Point_2& p) { return {p.x(), p.y()}; }
};

/// The distinct ends of the edges along a Hilbert curve, so that what is near in the plane is near in memory.
std::vector<Point> ends_of(std::span<const Edge> edges) {
  std::vector<Point> points;
  points.reserve(2 * edges.size());
  for (const Edge& c : edges) points.insert(points.end(), {c.a, c.b});
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  std::vector<std::pair<Epick::Point_2, std::size_t>> order(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) order[i] = {{points[i].x, points[i].y}, i};
  using Traits =
      CGAL::Spatial_sort_traits_adapter_2<Epick,
                                          CGAL::First_of_pair_property_map<std::pair<Epick::Point_2, std::size_t>>>;
  CGAL::hilbert_sort(order.begin(), order.end(), Traits());
  std::vector<Point> sorted(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) sorted[i] = points[order[i].second];
  return sorted;
}

using Ends = std::pair<std::uint32_t, std::uint32_t>;

/// The edges as pairs of point indices.
std::vector<Ends> index_pairs(std::span<const Edge> edges, std::span<const Point> points) {
  std::vector<std::uint32_t> by_place(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i) by_place[i] = i;
  std::sort(by_place.begin(), by_place.end(), [&](auto i, auto j) { return points[i] < points[j]; });
  const auto index = [&](Point p) {
    return *std::lower_bound(by_place.begin(), by_place.end(), p, [&](auto i, Point q) { return points[i] < q; });
  };
  std::vector<Ends> pairs(edges.size());
  for (std::size_t i = 0; i < edges.size(); ++i) pairs[i] = {index(edges[i].a), index(edges[i].b)};
  return pairs;
}

template <class Traits>
void triangulate_with(Triangulation& out, std::span<const Ends> pairs, std::span<const Point> places) {
  using Vertex = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Traits>;
  using Face = CGAL::Triangulation_face_base_with_info_2<std::uint32_t, Traits,
                                                         CGAL::Constrained_triangulation_face_base_2<Traits>>;
  using Cdt = CGAL::Constrained_Delaunay_triangulation_2<Traits, CGAL::Triangulation_data_structure_2<Vertex, Face>,
                                                         CGAL::No_constraint_intersection_tag>;
  Cdt cdt;
  std::vector<typename Cdt::Vertex_handle> handles(out.points.size());
  typename Cdt::Face_handle hint;
  for (std::uint32_t i = 0; i < out.points.size(); ++i) {
    handles[i] = cdt.insert({places[i].x, places[i].y}, hint);
    handles[i]->info() = i;
    hint = handles[i]->face();
  }
  for (const auto& [a, b] : pairs) cdt.insert_constraint(handles[a], handles[b]);

  // Triangles in the order of their vertices, along the curve too.
  std::vector<typename Cdt::Face_handle> faces;
  faces.reserve(2 * out.points.size());
  for (const auto face : cdt.all_face_handles()) face->info() = kNone;
  for (const auto handle : handles) {
    if (cdt.dimension() < 2) break;
    auto face = cdt.incident_faces(handle);
    const auto first = face;
    do {
      if (cdt.is_infinite(face) || face->info() != kNone) continue;
      face->info() = static_cast<std::uint32_t>(faces.size());
      faces.push_back(face);
    } while (++face != first);
  }
  out.triangles.resize(faces.size());
  out.neighbours.resize(faces.size());
  out.constrained.resize(faces.size());
  for (std::uint32_t t = 0; t < faces.size(); ++t) {
    const auto face = faces[t];
    for (int i = 0; i < 3; ++i) {
      out.triangles[t][i] = face->vertex(i)->info();
      out.neighbours[t][i] = face->neighbor(i)->info();
      if (face->is_constrained(i)) out.constrained[t] |= static_cast<std::uint8_t>(1 << i);
    }
  }
}

/// Which edge runs along each constrained side.
std::vector<std::uint32_t> edges_along_sides(const Triangulation& tri, std::span<const Ends> pairs) {
  std::vector<std::uint32_t> first(tri.points.size() + 1, 0);
  for (const auto& [a, b] : pairs) ++first[std::min(a, b) + 1];
  for (std::size_t i = 1; i < first.size(); ++i) first[i] += first[i - 1];
  std::vector<std::pair<std::uint32_t, std::uint32_t>> rows(pairs.size());  // the other end, the edge
  auto next = first;
  for (std::uint32_t i = 0; i < pairs.size(); ++i) {
    const auto [low, high] = std::minmax(pairs[i].first, pairs[i].second);
    rows[next[low]++] = {high, i};
  }
  std::vector<std::uint32_t> edge_of(3 * tri.triangles.size(), kNone);
  for (std::uint32_t t = 0; t < tri.triangles.size(); ++t)
    for (int i = 0; i < 3; ++i) {
      if (!tri.is_constrained(t, i)) continue;
      const auto [low, high] =
          std::minmax(tri.triangles[t][Triangulation::ccw(i)], tri.triangles[t][Triangulation::cw(i)]);
      for (auto row = first[low]; row != first[low + 1]; ++row)
        if (rows[row].first == high) edge_of[3 * t + i] = rows[row].second;
    }
  return edge_of;
}

/// The same as binary_integers for integers and multiples of a half to a 64th, in one glance each; else empty. With so
/// few digits a number means the double that it is.
std::vector<double> small_fractions(std::span<const double> values, double limit) {
  std::vector<double> integers(values.size());
  for (double scale = 1; scale <= 64; scale *= 2) {
    std::size_t i = 0;
    for (; i < values.size(); ++i) {
      const double v = values[i] * scale;
      if (!(std::abs(v) < limit) || v != static_cast<double>(static_cast<std::int32_t>(v))) break;
      integers[i] = v;
    }
    if (i == values.size()) return integers;
  }
  return {};
}

/// The values as multiples of a power of two, counted from zero; empty when some are none below the limit.
std::vector<double> binary_integers(std::span<const double> values, double limit) {
  int lowest = 0;  // the exponent of the lowest bit in use, at most 0
  double largest = 0;
  for (const double c : values) {
    largest = std::max(largest, std::abs(c));
    if (c == 0) continue;
    int exponent = 0;
    const auto mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(c, &exponent), 53));
    lowest = std::min(lowest, exponent - 53 + std::countr_zero(static_cast<std::uint64_t>(mantissa)));
    if (lowest < -60 || std::ldexp(largest, -lowest) >= limit || !written::is_plain(c)) return {};
  }
  std::vector<double> integers(values.begin(), values.end());
  for (double& v : integers) v = std::ldexp(v, -lowest);
  return integers;
}

/// The values, x and y in turn, as multiples of a power of ten, counted from the least x and y; empty likewise.
std::vector<double> decimal_integers(std::span<const double> values, double limit) {
  std::vector<double> integers(values.size());
  if (!to_integers(values.data(), values.size(), integers.data())) return {};
  double least[2] = {HUGE_VAL, HUGE_VAL};
  for (std::size_t i = 0; i < integers.size(); ++i) least[i % 2] = std::min(least[i % 2], integers[i]);
  for (std::size_t i = 0; i < integers.size(); ++i)
    if ((integers[i] -= least[i % 2]) >= limit) return {};
  return integers;
}

}  // namespace

std::vector<Point> lattice_places(std::span<const Point> points) {
  constexpr double kLimit = 1 << 29;
  std::vector<double> values;
  values.reserve(2 * points.size());
  for (const Point p : points) values.insert(values.end(), {p.x, p.y});
  std::vector<double> integers = small_fractions(values, kLimit);
  if (integers.empty()) integers = binary_integers(values, kLimit);
  if (integers.empty()) integers = decimal_integers(values, kLimit);
  std::vector<Point> result(integers.size() / 2);
  for (std::size_t i = 0; i < result.size(); ++i) result[i] = {integers[2 * i], integers[2 * i + 1]};
  return result;
}

Mesh triangulate(std::span<const Edge> edges) {
  if (std::optional<Mesh> mesh = triangulate_axis_parallel(edges)) return std::move(*mesh);
  return triangulate_general(edges);
}

Mesh triangulate_general(std::span<const Edge> edges) {
  Mesh mesh;
  Triangulation& tri = mesh.triangulation;
  tri.points = ends_of(edges);
  const std::vector<Ends> pairs = index_pairs(edges, tri.points);
  if (const std::vector<Point> places = lattice_places(tri.points); !places.empty()) {
    tri.lattice.resize(places.size());
    for (std::size_t i = 0; i < places.size(); ++i)
      tri.lattice[i] = {static_cast<std::int32_t>(places[i].x), static_cast<std::int32_t>(places[i].y)};
    triangulate_with<LatticeTraits>(tri, pairs, places);
  } else {
    triangulate_with<WrittenTraits>(tri, pairs, tri.points);
  }
  mesh.edge_of = edges_along_sides(tri, pairs);
  return mesh;
}

}  // namespace taut::detail
