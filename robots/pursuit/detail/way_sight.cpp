#include <taut/robots/pursuit/detail/way_sight.h>

#include <optional>

#include <taut/geometry/triangular_expansion.h>
#include <taut/geometry/written.h>

namespace taut::pursuit::detail {

namespace {

using Tri = Triangulation;

/// Collects cones.
class Cones {
 public:
  Cones(const Tri& tri, Point from, std::vector<SightCone>& all) : tri_(tri), from_(from), all_(all) {}

  void out_of(std::uint32_t t, int i) {
    Expansion<DoubleCoordinates, Cones> expansion(tri_, *this);
    expansion.spread(from_, t, i, expansion.ray(tri_.triangles[t][Tri::ccw(i)]),
                     expansion.ray(tri_.triangles[t][Tri::cw(i)]));
  }

  /// Through all sides that do not hold the place.
  void triangle(std::uint32_t t) {
    for (int i = 0; i < 3; ++i)
      if (written::orientation(corner(t, Tri::ccw(i)), corner(t, Tri::cw(i)), from_) > 0) out_of(t, i);
  }

  // What the expansion calls.
  bool hides(std::uint32_t) const { return true; }
  void vertex(std::uint32_t, int) {}
  void blocked(std::uint32_t t, int i, const auto& right, const auto& left) {
    all_.push_back({right.through, left.through, {corner(t, Tri::ccw(i)), corner(t, Tri::cw(i))}});
  }

 private:
  Point corner(std::uint32_t t, int i) const { return tri_.points[tri_.triangles[t][i]]; }

  const Tri& tri_;
  Point from_;
  std::vector<SightCone>& all_;
};

void look(const Tri& tri, const Tri::Sector& sector, std::vector<SightCone>& cones) {
  Cones all(tri, tri.points[sector.vertex], cones);
  each_triangle(tri, sector, [&](std::uint32_t t, int i) { all.out_of(t, i); });
}

void look(const FreeSpace& space, Point from, std::vector<SightCone>& cones) {
  const Tri& tri = space.triangulation();
  const Location at = space.locate(from);
  if (at.kind == Location::Kind::outside) return;
  if (at.kind == Location::Kind::vertex) {
    for (const Tri::Sector& sector : tri.sectors_at(tri.triangles[at.triangle][at.index])) look(tri, sector, cones);
    return;
  }
  Cones all(tri, from, cones);
  all.triangle(at.triangle);
  // A place on a side belongs to the triangle beyond, too.
  for (int i = 0; i < 3; ++i) {
    const std::uint32_t beyond = tri.neighbours[at.triangle][i];
    const Point a = tri.points[tri.triangles[at.triangle][Tri::ccw(i)]],
                b = tri.points[tri.triangles[at.triangle][Tri::cw(i)]];
    if (beyond != kNone && tri.free[beyond] && written::orientation(a, b, from) == 0) all.triangle(beyond);
  }
}

Rational area(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Cuts off what lies to the right of a -> b; false: that is all.
bool keep_left(Part& part, Point a, Point b, const Segment& s) {
  const int first = written::orientation(a, b, s.a), last = written::orientation(a, b, s.b);
  if (first >= 0 && last >= 0) return true;
  if (first < 0 && last < 0) return false;
  const ExactPoint from(a), to(b);
  const Rational begins = area(from, to, ExactPoint(s.a)), ends = area(from, to, ExactPoint(s.b));
  const Rational crossing = begins / (begins - ends);
  if (first < 0 && part.first < crossing) part.first = crossing;
  if (last < 0 && crossing < part.second) part.second = crossing;
  return part.first <= part.second;
}

}  // namespace

WaySight::WaySight(const FreeSpace& space, Point from) : from_(from) { look(space, from, cones_); }

WaySight::WaySight(const FreeSpace& space, const Triangulation::Sector& sector)
    : from_(space.triangulation().points[sector.vertex]) {
  look(space.triangulation(), sector, cones_);
}

std::vector<Part> WaySight::parts(const Segment& s) const {
  std::vector<Part> all;
  for (const SightCone& cone : cones_) {
    Part part{0, 1};
    if (keep_left(part, from_, cone.right, s) && keep_left(part, cone.left, from_, s) &&
        keep_left(part, cone.side.a, cone.side.b, s))
      all.push_back(std::move(part));
  }
  return all;
}

}  // namespace taut::pursuit::detail
