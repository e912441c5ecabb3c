#include <taut/geometry/detail/polygon_mend.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <taut/geometry/detail/noding.h>
#include <taut/geometry/detail/outline_rings.h>
#include <taut/geometry/detail/triangulate.h>
#include <taut/geometry/text.h>

namespace taut::detail {

namespace {

void add_ring(const Ring& ring, int turn, std::vector<Edge>& edges) {
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
    if (ring[i] != ring[j]) edges.push_back({ring[j], ring[i], turn, kNone});
}

void add_polygons(const std::vector<Polygon>& polygons, int turn, std::vector<Edge>& edges) {
  for (const Polygon& polygon : polygons) {
    add_ring(polygon.outer, turn, edges);
    for (const Ring& hole : polygon.holes) add_ring(hole, turn, edges);
  }
}

double reach(const std::vector<Polygon>& polygons) {
  double largest = 0;
  const auto add = [&](const Ring& ring) {
    for (Point p : ring) largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
  };
  for (const Polygon& polygon : polygons) {
    add(polygon.outer);
    for (const Ring& hole : polygon.holes) add(hole);
  }
  return largest;
}

/// What of the plane has a winding number that is wanted. `see(winding, place)` is told of all that there are.
template <class Wanted, class See>
std::vector<Polygon> select(std::vector<Edge> edges, const DecimalUnit& unit, Wanted wanted, See see) {
  std::vector<Edge> noded = node(std::move(edges), unit, {}, Rounding::nearest).edges;
  std::erase_if(noded, [](const Edge& e) { return e.turn == 0; });
  if (noded.empty()) return {};
  Mesh mesh = triangulate(noded);
  Triangulation& tri = mesh.triangulation;
  const std::vector<int> winding = winding_numbers(mesh, noded, 0);
  tri.free.resize(winding.size());
  for (std::size_t t = 0; t < winding.size(); ++t) {
    tri.free[t] = wanted(winding[t]);
    see(winding[t], tri.points[tri.triangles[t][0]]);
  }
  return outline_rings(tri);
}

bool is_odd(int winding) { return winding % 2 != 0; }

class Mend {
 public:
  Mend(const Polygon& polygon, std::vector<Flaw>& flaws) : polygon_(polygon), flaws_(flaws), unit_(reach({polygon})) {}

  std::vector<Polygon> run() {
    std::vector<Polygon> parts = inside(polygon_.outer);
    if (parts.empty() || polygon_.holes.empty()) return parts;
    std::vector<Edge> edges;
    add_polygons(parts, 1, edges);
    for (const Ring& hole : polygon_.holes) add_polygons(inside(hole), -1, edges);
    // The outer ring counts 1, each hole -1: what remains is 1, and below 0 a hole covers what is no longer there.
    return select(
        std::move(edges), unit_, [](int winding) { return winding == 1; },
        [&](int winding, Point p) {
          if (winding < 0) find({Flaw::reach, "a hole reaches over the outer ring or another hole near " + text(p)});
        });
  }

 private:
  std::vector<Polygon> inside(const Ring& ring) {
    std::vector<Edge> edges;
    add_ring(ring, 1, edges);
    std::vector<Polygon> parts = select(std::move(edges), unit_, is_odd, [&](int winding, Point p) {
      if (std::abs(winding) > 1) find({Flaw::crossing, "ring winds more than once around a place near " + text(p)});
    });
    if (parts.empty()) find({Flaw::flat, "ring near " + text(ring.front()) + " has no area"});
    return parts;
  }

  void find(Flaw flaw) {
    const auto same = [&](const Flaw& f) { return f.kind == flaw.kind; };
    if (std::none_of(flaws_.begin(), flaws_.end(), same)) flaws_.push_back(std::move(flaw));
  }

  const Polygon& polygon_;
  std::vector<Flaw>& flaws_;
  DecimalUnit unit_;
};

}  // namespace

std::vector<Polygon> mended(const Polygon& polygon, std::vector<Flaw>& flaws) { return Mend(polygon, flaws).run(); }

std::vector<Polygon> even_odd(const std::vector<Polygon>& polygons) {
  std::vector<Edge> edges;
  add_polygons(polygons, 1, edges);
  return select(std::move(edges), DecimalUnit(reach(polygons)), is_odd, [](int, Point) {});
}

}  // namespace taut::detail
