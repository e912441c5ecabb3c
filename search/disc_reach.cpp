#include <taut/search/disc_reach.h>

#include <algorithm>
#include <cmath>

#include <taut/geometry/predicates.h>

namespace taut {

namespace {

double area_of(const Polygon& polygon) {
  double twice = std::abs(ring_area(polygon.outer));
  for (const Ring& hole : polygon.holes) twice -= std::abs(ring_area(hole));
  return twice / 2;
}

/// Of each component of the inflated space: does the disc get there?
std::vector<std::uint8_t> reached_components(const PassageIndex& index, const FreeSpace& inflated,
                                             const PassagePlace& start, double r) {
  enum : std::uint8_t { unknown, yes, no };
  std::vector<std::uint8_t> told(inflated.component_count(), unknown);
  const Triangulation& tri = inflated.triangulation();
  for (std::uint32_t t = 0; t < tri.triangles.size(); ++t) {
    if (!tri.free[t] || told[inflated.component(t)] != unknown) continue;
    const auto [a, b, c] = tri.triangles[t];
    const Point p = tri.points[a], q = tri.points[b], s = tri.points[c];
    const DiscStatus status = index.passes(start, index.place({(p.x + q.x + s.x) / 3, (p.y + q.y + s.y) / 3}), r);
    // Of a triangle so thin that rounding leaves it nothing is learnt.
    if (status == DiscStatus::found || status == DiscStatus::none)
      told[inflated.component(t)] = status == DiscStatus::found ? yes : no;
  }
  for (std::uint8_t& one : told) one = one == yes;
  return told;
}

/// The component that a polygon is, by the middle of one of its sides.
std::uint32_t component_of(const FreeSpace& space, const Polygon& polygon) {
  const Ring& ring = polygon.outer;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i], b = ring[(i + 1) % ring.size()];
    const Location at = space.locate({a.x + (b.x - a.x) / 2, a.y + (b.y - a.y) / 2});
    if (at.kind == Location::Kind::triangle || at.kind == Location::Kind::side) return space.component(at.triangle);
  }
  const Location at = space.locate(ring.front());
  return at.kind == Location::Kind::outside ? kNone : space.component(at.triangle);
}

}  // namespace

std::vector<std::uint32_t> closed_gates(const PassageIndex& index, const PassagePlace& start, double r) {
  std::vector<PassageIndex::Reach> all = index.reach(start);
  std::vector<std::uint8_t> reached;
  for (const PassageIndex::Reach& reach : all) {
    if (reach.face >= reached.size()) reached.resize(reach.face + 1, 0);
    reached[reach.face] = reach.gate == kNone || index.gate_radius(reach.gate) >= r;
  }
  const auto is_reached = [&](std::uint32_t face) { return face < reached.size() && reached[face] != 0; };
  std::vector<std::uint32_t> gates;
  for (auto i = static_cast<std::uint32_t>(index.gates().gates().size()); i-- > 0;) {
    if (index.gate_radius(i) >= r) continue;
    for (const auto& [left, right] : index.sides(i))
      if (is_reached(left) != is_reached(right)) {
        gates.push_back(i);
        break;
      }
  }
  return gates;
}

std::optional<DiscReach> disc_reach(const PassageIndex& index, Point start, double r) {
  const PassagePlace from = index.place(start);
  if (index.passes(from, from, r) != DiscStatus::found) return std::nullopt;
  const FreeSpace inflated(index.gates().space().world(), Footprint::disc(r));
  const std::vector<std::uint8_t> reached = reached_components(index, inflated, from, r);
  DiscReach result;
  for (const Polygon& polygon : inflated.polygons()) {
    result.whole_area += area_of(polygon);
    const std::uint32_t component = component_of(inflated, polygon);
    if (component == kNone || !reached[component]) continue;
    result.places.push_back(polygon);
    result.area += area_of(polygon);
  }
  result.gates = closed_gates(index, from, r);
  return result;
}

}  // namespace taut
