// Tests of rings, by whichever orientation the caller means: of doubles as they are, or of what was written.
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>

#include <taut/geometry/point.h>

namespace taut::detail {

/// ring_orientation() of predicates.h: `orientation(a, b, c)` gives the sign of a triangle's area.
template <typename Orientation>
int ring_orientation_by(const Ring& ring, Orientation orientation) {
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

/// side_of_ring() of predicates.h: `on_segment(q, a, b)` says whether q lies on the closed segment.
template <typename Orientation, typename OnSegment>
int side_of_ring_by(Point p, const Ring& ring, Orientation orientation, OnSegment on_segment) {
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

}  // namespace taut::detail
