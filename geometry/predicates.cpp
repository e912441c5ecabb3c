#include <taut/geometry/predicates.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>

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
  if (ring.size() < 3) return 0;
  const auto least = std::min_element(ring.begin(), ring.end()) - ring.begin();
  const auto n = static_cast<std::ptrdiff_t>(ring.size());
  const Point p = ring[least];
  // Neighbours that differ from p and are not collinear with it: a simple ring has them.
  std::ptrdiff_t i = least, j = least;
  do i = (i + n - 1) % n;
  while (ring[i] == p && i != least);
  do j = (j + 1) % n;
  while (ring[j] == p && j != least);
  return orientation(ring[i], p, ring[j]);
}

int side_of_ring(Point p, const Ring& ring) {
  bool inside = false;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    Point a = ring[j], b = ring[i];
    if (on_segment(p, a, b)) return 0;
    if ((a.y > p.y) == (b.y > p.y)) continue;
    if (a.y > b.y) std::swap(a, b);
    if (orientation(a, b, p) > 0) inside = !inside;
  }
  return inside ? 1 : -1;
}

}  // namespace taut
