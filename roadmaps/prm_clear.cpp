#include <taut/roadmaps/prm_clear.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <taut/geometry/expects.h>
#include <taut/geometry/ray_walk.h>
#include <taut/geometry/segment_distance.h>

namespace taut {

namespace {

BoxIndex boxes_of(const std::vector<Constraint>& constraints) {
  std::vector<Box> boxes;
  boxes.reserve(constraints.size());
  for (const Constraint& c : constraints) boxes.push_back(box_around(c.a, c.b));
  return BoxIndex(std::move(boxes));
}

}  // namespace

PrmClear::PrmClear(const FreeSpace& space, double clearance)
    : space_(space),
      clearance_(clearance),
      from_{{0, 0}, {0, 0}},
      to_{{clearance, 0}, {clearance, 0}},
      index_(boxes_of(space.constraints())) {
  TAUT_EXPECTS(clearance >= 0 && clearance <= World::kLargest);
}

/// Holds every point nearer to the box than `by`, however its sides are rounded.
std::optional<Location> PrmClear::place(Point p) const {
  const Location at = space_.locate(p);
  return is_untouched(at) && keeps_distance({p, p}) ? std::optional(at) : std::nullopt;
}

bool PrmClear::leg(Point p, Point q) const { return space_.sees(p, q) && keeps_distance({p, q}); }

bool PrmClear::sees(Point p, const Location& at, Point q) const {
  if (p == q) return true;
  RayWalk walk(space_.triangulation(), p, q, true);
  auto end = walk.start(at);
  while (end == RayWalk::End::vertex) end = walk.next();
  return end == RayWalk::End::reached;
}

bool PrmClear::is_untouched(const Location& at) const {
  if (at.kind == Location::Kind::triangle) return true;
  if (at.kind != Location::Kind::vertex) return false;
  const Triangulation& tri = space_.triangulation();
  const auto sectors = tri.sectors_at(tri.triangles[at.triangle][at.index]);
  return std::all_of(sectors.begin(), sectors.end(), [](const Triangulation::Sector& s) { return s.full; });
}

bool PrmClear::keeps_distance(const Segment& s) const {
  if (clearance_ == 0) return true;
  bool keeps = true;
  near(box_around(s.a, s.b), clearance_, [&](std::uint32_t i) {
    const Constraint& c = space_.constraints()[i];
    keeps = keeps && compare_segment_distances(s, {c.a, c.b}, from_, to_) >= 0;
  });
  return keeps;
}

}  // namespace taut
