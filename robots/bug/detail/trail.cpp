#include <taut/robots/bug/detail/trail.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <taut/geometry/written.h>
#include <taut/search/funnel.h>

namespace taut::bug::detail {

namespace {

using Tri = Triangulation;

int side_between(const Tri& tri, std::uint32_t t, std::uint32_t next) {
  const auto& n = tri.neighbours[t];
  return static_cast<int>(std::find(n.begin(), n.end(), next) - n.begin());
}

}  // namespace

Point rounded(const Triangulation& tri, const Stand& stand) {
  const Point nearest = taut::nearest_point(stand.at);
  if (stand.kind != Stand::Kind::side) return nearest;
  const auto& c = tri.triangles[stand.t];
  // Free space is to the right of the sides when they are turned round.
  const std::array<Segment, 3> sides{Segment{tri.points[c[1]], tri.points[c[0]]},
                                     Segment{tri.points[c[2]], tri.points[c[1]]},
                                     Segment{tri.points[c[0]], tri.points[c[2]]}};
  const auto is_inside = [&](Point p) {
    return std::all_of(sides.begin(), sides.end(),
                       [&](const Segment& s) { return written::orientation(s.a, s.b, p) <= 0; });
  };
  try {
    const Point p =
        taut::round_outward(stand.at, sides, taut::DecimalUnit(std::max(std::abs(nearest.x), std::abs(nearest.y))));
    if (is_inside(p)) return p;
  } catch (const taut::TooFine&) {
  }
  // No double near it in the triangle: the nearer end of the side is one.
  const Point a = tri.points[c[Tri::ccw(stand.i)]], b = tri.points[c[Tri::cw(stand.i)]];
  return written::compare_distance(nearest, a, b) <= 0 ? a : b;
}

bool Trail::goes_straight(Point from, Point to, const std::vector<std::uint32_t>& triangles) const {
  for (std::size_t k = 0; k + 1 < triangles.size(); ++k) {
    const int i = side_between(tri_, triangles[k], triangles[k + 1]);
    const auto& c = tri_.triangles[triangles[k]];
    if (written::orientation(from, to, tri_.points[c[Tri::ccw(i)]]) >= 0 ||
        written::orientation(from, to, tri_.points[c[Tri::cw(i)]]) <= 0)
      return false;
  }
  return true;
}

void Trail::add(const Walk& walk, Point end) {
  for (const Piece& piece : walk.pieces) {
    if (piece.triangles.empty()) continue;
    const Point from = points_.back(), to = piece.to.value_or(end);
    if (from == to) continue;
    if (goes_straight(from, to, piece.triangles)) {
      add(to);
      continue;
    }
    const Path pulled = funnel(tri_, {from, to, piece.triangles});
    for (const Point p : pulled.points) add(p);
  }
}

}  // namespace taut::bug::detail
