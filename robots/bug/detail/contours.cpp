#include <taut/robots/bug/detail/contours.h>

namespace taut::bug::detail {

using Tri = Triangulation;

Contours::Contours(const Triangulation& tri) : tri_(tri), at_(3 * tri.triangles.size()) {
  for (std::uint32_t t = 0; t < tri.triangles.size(); ++t)
    for (int i = 0; i < 3; ++i) {
      if (!tri.free[t] || !tri.is_constrained(t, i) || at(t, i).contour != kNone) continue;
      const auto contour = static_cast<std::uint32_t>(contours_.size());
      std::vector<HalfEdge>& edges = contours_.emplace_back();
      for (HalfEdge e{t, i}; at(e.t, e.i).contour == kNone; e = next(e)) {
        at_[3 * e.t + static_cast<std::uint32_t>(e.i)] = {contour, static_cast<std::uint32_t>(edges.size())};
        edges.push_back(e);
      }
    }
}

HalfEdge Contours::next(HalfEdge e) const {
  const std::uint32_t head = 3 * e.t + static_cast<std::uint32_t>(Tri::cw(e.i));
  const Tri::Sector& sector = tri_.sectors[tri_.sector_of[head]];
  return {sector.triangle, Tri::cw(tri_.corner(sector.triangle, sector.vertex))};
}

Contours::At Contours::at(const Tri::Sector& sector) const {
  return at(sector.triangle, Tri::cw(tri_.corner(sector.triangle, sector.vertex)));
}

Point Contours::tail(At at) const {
  const HalfEdge e = contours_[at.contour][at.edge];
  return tri_.points[tri_.triangles[e.t][Tri::ccw(e.i)]];
}

Point Contours::head(At at) const {
  const HalfEdge e = contours_[at.contour][at.edge];
  return tri_.points[tri_.triangles[e.t][Tri::cw(e.i)]];
}

std::uint32_t Contours::sector(At at) const {
  const HalfEdge e = contours_[at.contour][at.edge];
  return tri_.sector_of[3 * e.t + static_cast<std::uint32_t>(Tri::ccw(e.i))];
}

Interval Contours::perimeter(std::uint32_t contour) const {
  Length length;
  for (std::uint32_t k = 0; k < contours_[contour].size(); ++k) length.add(tail({contour, k}), head({contour, k}));
  return length.interval();
}

}  // namespace taut::bug::detail
