#include <taut/geometry/detail/polygon_triangles.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include <taut/geometry/detail/noding.h>
#include <taut/geometry/detail/triangulate.h>
#include <taut/geometry/written.h>

namespace taut::detail {

namespace {

void add_ring(const Ring& ring, int turn, std::vector<Edge>& edges) {
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
    edges.push_back({ring[j], ring[i], turn, kNone});
}

bool contains(const Polygon& polygon, Point p) {
  return written::side_of_ring(p, polygon.outer) > 0 &&
         std::none_of(polygon.holes.begin(), polygon.holes.end(),
                      [p](const Ring& hole) { return written::side_of_ring(p, hole) >= 0; });
}

/// The parts of a triangulation that no edge divides, told apart by one point each.
class Regions {
 public:
  Regions(const Triangulation& tri, std::span<const Polygon* const> polygons)
      : tri_(tri), polygons_(polygons), covered_(tri_.triangles.size(), false) {
    std::vector<bool> seen(tri_.triangles.size(), false);
    for (std::uint32_t t = 0; t < tri_.triangles.size(); ++t)
      if (!seen[t]) decide(region_of(t, seen));
  }

  PolygonTriangles select(bool covered) const {
    PolygonTriangles result;
    for (std::uint32_t t = 0; t < tri_.triangles.size(); ++t)
      if (covered_[t] == covered) result.triangles.push_back(corners(t));
    return result;
  }

 private:
  std::array<Point, 3> corners(std::uint32_t t) const {
    const auto& v = tri_.triangles[t];
    return {tri_.points[v[0]], tri_.points[v[1]], tri_.points[v[2]]};
  }

  std::vector<std::uint32_t> region_of(std::uint32_t first, std::vector<bool>& seen) const {
    std::vector<std::uint32_t> region{first};
    seen[first] = true;
    for (std::size_t k = 0; k < region.size(); ++k)
      for (int i = 0; i < 3; ++i) {
        const std::uint32_t n = tri_.neighbours[region[k]][i];
        if (n == kNone || seen[n] || tri_.is_constrained(region[k], i)) continue;
        seen[n] = true;
        region.push_back(n);
      }
    return region;
  }

  // By the widest triangle: a narrow one may lie between a side as written and as it was rounded.
  void decide(const std::vector<std::uint32_t>& region) {
    double widest = 0;
    std::optional<Point> place;
    for (const std::uint32_t t : region) {
      const double w = width(t);
      if (place && w <= widest) continue;
      if (const std::optional<Point> m = middle(t)) {
        widest = w;
        place = m;
      }
    }
    // No triangle has a point with double coordinates in it: nobody can be there, and it counts as not covered.
    if (!place) return;
    const bool covered =
        std::any_of(polygons_.begin(), polygons_.end(), [&](const Polygon* p) { return contains(*p, *place); });
    for (const std::uint32_t u : region) covered_[u] = covered;
  }

  // A point with double coordinates inside.
  std::optional<Point> middle(std::uint32_t t) const {
    const auto [a, b, c] = corners(t);
    const Point m{(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3};
    if (written::orientation(a, b, m) <= 0 || written::orientation(b, c, m) <= 0 || written::orientation(c, a, m) <= 0)
      return std::nullopt;
    return m;
  }

  // About the radius of the inscribed circle: it only compares.
  double width(std::uint32_t t) const {
    const auto [a, b, c] = corners(t);
    const double round =
        std::hypot(b.x - a.x, b.y - a.y) + std::hypot(c.x - b.x, c.y - b.y) + std::hypot(a.x - c.x, a.y - c.y);
    return std::abs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / round;
  }

  const Triangulation& tri_;
  std::span<const Polygon* const> polygons_;
  std::vector<bool> covered_;
};

PolygonTriangles triangles_of(std::span<const Polygon* const> polygons, const Box* frame, const DecimalUnit& unit,
                              std::span<const Point> fixed) {
  std::vector<Edge> edges;
  for (const Polygon* polygon : polygons) {
    add_ring(polygon->outer, -1, edges);
    for (const Ring& hole : polygon->holes) add_ring(hole, -1, edges);
  }
  if (frame) add_ring({frame->min, {frame->max.x, frame->min.y}, frame->max, {frame->min.x, frame->max.y}}, 0, edges);
  const Noded noded = node(std::move(edges), unit, fixed);
  const Mesh mesh = triangulate(noded.edges);
  PolygonTriangles result = Regions(mesh.triangulation, polygons).select(frame == nullptr);
  result.displacement = noded.displacement;
  return result;
}

}  // namespace

PolygonTriangles inside_triangles(std::span<const Polygon* const> polygons, const DecimalUnit& unit,
                                  std::span<const Point> fixed) {
  return triangles_of(polygons, nullptr, unit, fixed);
}

PolygonTriangles outside_triangles(std::span<const Polygon* const> polygons, const Box& frame, const DecimalUnit& unit,
                                   std::span<const Point> fixed) {
  return triangles_of(polygons, &frame, unit, fixed);
}

}  // namespace taut::detail
