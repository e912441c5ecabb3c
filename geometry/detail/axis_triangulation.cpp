#include <algorithm>
#include <bit>
#include <numeric>
#include <optional>

#include <taut/geometry/detail/axis_noding.h>
#include <taut/geometry/detail/axis_sweep.h>
#include <taut/geometry/detail/radix_sort.h>
#include <taut/geometry/detail/triangulate.h>

namespace taut::detail {

namespace {

/// Sides turned for each point, at most: more is a world that the general triangulation takes in less time.
constexpr std::size_t kTurns = 64;

struct Range {
  std::int32_t least = 0;
  std::uint32_t size = 0;
};

/// The distinct ends of edges, and which they are.
struct Vertices {
  std::vector<LatticePoint> places;   ///< ordered by (y, x)
  std::vector<Point> points;          ///< the same
  std::vector<std::uint32_t> of_end;  ///< of the ends 2 * edge, 2 * edge + 1
  Range x, y;
};

std::optional<std::vector<LatticePoint>> lattice_ends(std::span<const Edge> edges) {
  std::vector<Point> ends;
  ends.reserve(2 * edges.size());
  for (const Edge& e : edges) ends.insert(ends.end(), {e.a, e.b});
  const std::vector<Point> places = lattice_places(ends);
  if (places.empty()) return std::nullopt;
  std::vector<LatticePoint> result(places.size());
  for (std::size_t i = 0; i < result.size(); ++i)
    result[i] = {static_cast<std::int32_t>(places[i].x), static_cast<std::int32_t>(places[i].y)};
  return result;
}

Range range(std::span<const LatticePoint> points, std::int32_t LatticePoint::*axis) {
  const auto [least, most] =
      std::minmax_element(points.begin(), points.end(), [&](auto p, auto q) { return p.*axis < q.*axis; });
  return {*least.*axis, static_cast<std::uint32_t>(*most.*axis - *least.*axis)};
}

Vertices vertices(std::span<const Edge> edges, std::span<const LatticePoint> ends) {
  Vertices result;
  result.x = range(ends, &LatticePoint::x);
  result.y = range(ends, &LatticePoint::y);
  struct End {
    std::uint64_t key;
    std::uint32_t index;
  };
  const int width = bits_of(result.x.size);
  std::vector<End> order(ends.size());
  for (std::uint32_t i = 0; i < ends.size(); ++i)
    order[i] = {static_cast<std::uint64_t>(ends[i].y - result.y.least) << width |
                    static_cast<std::uint64_t>(ends[i].x - result.x.least),
                i};
  radix_sort(order, width + bits_of(result.y.size), [](const End& e) { return e.key; });
  result.of_end.resize(ends.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const auto [key, end] = order[i];
    if (i == 0 || key != order[i - 1].key) {
      result.places.push_back(ends[end]);
      result.points.push_back(end % 2 == 0 ? edges[end / 2].a : edges[end / 2].b);
    }
    result.of_end[end] = static_cast<std::uint32_t>(result.places.size() - 1);
  }
  return result;
}

std::vector<AxisStar> stars(const Vertices& v, std::span<const Edge> edges) {
  std::vector<AxisStar> result(v.places.size());
  for (std::uint32_t e = 0; e < edges.size(); ++e) {
    // Points are ordered by (y, x).
    const auto [low, high] = std::minmax(v.of_end[2 * e], v.of_end[2 * e + 1]);
    if (edges[e].a.y == edges[e].b.y) {
      result[low].east = result[high].west = e;
    } else {
      result[low].north = result[high].south = e;
    }
  }
  return result;
}

/// Where a place lies along a Hilbert curve of so many levels over a square. Level by level which quarter, as the curve
/// there has it: its axes swapped, turned around, or both. No branches: they would be as good as random.
std::uint64_t along_hilbert_curve(std::uint32_t x, std::uint32_t y, int levels) {
  std::uint64_t along = 0;
  std::uint32_t swapped = 0, turned = 0;
  for (int level = levels - 1; level >= 0; --level) {
    const std::uint32_t a = (x >> level) & 1, b = (y >> level) & 1, differ = (a ^ b) & swapped;
    const std::uint32_t right = a ^ differ ^ turned, up = b ^ differ ^ turned;
    along = 4 * along + 2 * right + (right ^ up);
    swapped ^= 1 - up;
    turned ^= right & (1 - up);
  }
  return along;
}

/// The points so that what is near in the plane is near in memory.
std::vector<std::uint32_t> curve_order(const Vertices& v) {
  const int wide = bits_of(std::max(v.x.size, v.y.size));
  const int levels = std::clamp(bits_of(v.places.size()) / 2 + 1, 1, std::max(wide, 1));
  const int dropped = std::max(wide, 1) - levels;
  struct Place {
    std::uint64_t key;
    std::uint32_t vertex;
  };
  std::vector<Place> order(v.places.size());
  for (std::uint32_t i = 0; i < order.size(); ++i)
    order[i] = {along_hilbert_curve(static_cast<std::uint32_t>(v.places[i].x - v.x.least) >> dropped,
                                    static_cast<std::uint32_t>(v.places[i].y - v.y.least) >> dropped, levels),
                i};
  radix_sort(order, 2 * levels, [](const Place& p) { return p.key; });
  std::vector<std::uint32_t> result(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) result[i] = order[i].vertex;
  return result;
}

/// Triangles by their least vertex.
std::vector<std::uint32_t> triangle_order(std::span<const RawTriangle> triangles, std::span<const std::uint32_t> name) {
  const auto least = [&](const RawTriangle& t) {
    return std::min({name[t.corners[0]], name[t.corners[1]], name[t.corners[2]]});
  };
  std::vector<std::uint32_t> next(name.size() + 1, 0), result(triangles.size());
  for (const RawTriangle& t : triangles) ++next[least(t) + 1];
  std::partial_sum(next.begin(), next.end(), next.begin());
  for (std::uint32_t t = 0; t < triangles.size(); ++t) result[next[least(triangles[t])]++] = t;
  return result;
}

std::vector<std::uint32_t> inverse(std::span<const std::uint32_t> order) {
  std::vector<std::uint32_t> result(order.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) result[order[i]] = i;
  return result;
}

/// The mesh in its final order.
Mesh arranged(std::span<const RawTriangle> raw, const Vertices& v) {
  Mesh mesh;
  Triangulation& tri = mesh.triangulation;
  const std::vector<std::uint32_t> points = curve_order(v), name = inverse(points);
  tri.points.resize(points.size());
  tri.lattice.resize(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    tri.points[i] = v.points[points[i]];
    tri.lattice[i] = {v.places[points[i]].x, v.places[points[i]].y};
  }
  const std::vector<std::uint32_t> order = triangle_order(raw, name), place = inverse(order);
  tri.triangles.resize(raw.size());
  tri.neighbours.resize(raw.size());
  tri.constrained.resize(raw.size());
  mesh.edge_of.resize(3 * raw.size());
  for (std::size_t t = 0; t < raw.size(); ++t) {
    const RawTriangle& from = raw[order[t]];
    for (std::size_t i = 0; i < 3; ++i) {
      tri.triangles[t][i] = name[from.corners[i]];
      tri.neighbours[t][i] = from.twins[i] == kNone ? kNone : place[from.twins[i] / 3];
      mesh.edge_of[3 * t + i] = from.edges[i];
      if (from.edges[i] != kNone) tri.constrained[t] |= static_cast<std::uint8_t>(1 << i);
    }
  }
  return mesh;
}

}  // namespace

std::optional<Mesh> triangulate_axis_parallel(std::span<const Edge> edges) {
  if (edges.empty() || !std::all_of(edges.begin(), edges.end(), is_axis_parallel)) return std::nullopt;
  std::optional<std::vector<LatticePoint>> ends = lattice_ends(edges);
  if (!ends) return std::nullopt;
  Vertices v = vertices(edges, *ends);
  ends.reset();
  std::vector<RawTriangle> raw = sweep(v.places, stars(v, edges), edges.size());
  v.of_end = {};
  if (!make_delaunay(raw, v.places, kTurns * v.places.size())) return std::nullopt;
  return arranged(raw, v);
}

}  // namespace taut::detail
