#include <taut/geometry/predicates.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <taut/geometry/detail/ring_tests.h>

namespace taut {

namespace {
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

Kernel::Point_2 cgal(Point p) { return {p.x, p.y}; }
}  // namespace

namespace detail {
int exact_orientation(Point a, Point b, Point c) {
  // Common on grids: an axis-parallel line, where the sign of one product decides.
  if (a.x == b.x) return a.y == b.y ? 0 : (a.x == c.x ? 0 : ((a.x < c.x) == (a.y > b.y) ? 1 : -1));
  if (a.y == b.y) return a.y == c.y ? 0 : ((a.y < c.y) == (a.x < b.x) ? 1 : -1);
  return static_cast<int>(CGAL::orientation(cgal(a), cgal(b), cgal(c)));
}
}  // namespace detail

bool segments_meet(const Segment& s, const Segment& t) {
  return cross_properly(s, t) || on_segment(t.a, s.a, s.b) || on_segment(t.b, s.a, s.b) || on_segment(s.a, t.a, t.b) ||
         on_segment(s.b, t.a, t.b);
}

int compare_distance(Point p, Point a, Point b) {
  return static_cast<int>(CGAL::compare_distance_to_point(cgal(p), cgal(a), cgal(b)));
}

double ring_area(const Ring& ring) {
  double twice = 0;
  const Point o = ring.empty() ? Point{} : ring.front();
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point p = ring[i], q = ring[(i + 1) % ring.size()];
    twice += (p.x - o.x) * (q.y - o.y) - (p.y - o.y) * (q.x - o.x);
  }
  return twice;
}

int ring_orientation(const Ring& ring) {
  return detail::ring_orientation_by(ring, [](Point a, Point b, Point c) { return orientation(a, b, c); });
}

int side_of_ring(Point p, const Ring& ring) {
  return detail::side_of_ring_by(
      p, ring, [](Point a, Point b, Point c) { return orientation(a, b, c); },
      [](Point q, Point a, Point b) { return on_segment(q, a, b); });
}

}  // namespace taut
