#include <taut/search/detail/seen_places.h>

#include <algorithm>

#include <taut/geometry/written.h>

namespace taut::detail {

using Tri = Triangulation;

SeenPlaces::SeenPlaces(const FreeSpace& space, std::span<const Point> places)
    : space_(space), tri_(space.triangulation()), places_(places), marks_(places.size(), 0) {
  first_triangle_.reserve(places.size() + 1);
  for (std::size_t i = 0; i < places.size(); ++i) {
    first_triangle_.push_back(triangles_.size());
    add_triangles_of(i);
  }
  first_triangle_.push_back(triangles_.size());
  sort_in();
}

/// All that hold it, closed: a view along a side comes into only one of the side's triangles.
void SeenPlaces::add_triangles_of(std::size_t place) {
  const Point p = places_[place];
  const Location at = space_.locate(p);
  if (at.kind == Location::Kind::vertex) {
    for (const Tri::Sector& sector : tri_.sectors_at(tri_.triangles[at.triangle][at.index]))
      each_triangle(tri_, sector, [&](std::uint32_t t, int) { add_triangle(t); });
    return;
  }
  add_triangle(at.triangle);
  for (int i = 0; i < 3; ++i) {
    const std::uint32_t n = tri_.neighbours[at.triangle][i];
    if (n != kNone && tri_.free[n] &&
        written::on_segment(p, point(at.triangle, Tri::ccw(i)), point(at.triangle, Tri::cw(i))))
      add_triangle(n);
  }
}

void SeenPlaces::sort_in() {
  first_place_.assign(tri_.triangles.size() + 1, 0);
  for (const std::uint32_t t : triangles_) ++first_place_[t + 1];
  for (std::size_t t = 0; t < tri_.triangles.size(); ++t) first_place_[t + 1] += first_place_[t];
  place_.resize(triangles_.size());
  std::vector<std::uint32_t> next(first_place_.begin(), first_place_.end() - 1);
  for (std::uint32_t i = 0; i < places_.size(); ++i)
    for (std::size_t k = first_triangle_[i]; k < first_triangle_[i + 1]; ++k) place_[next[triangles_[k]]++] = i;
}

void SeenPlaces::add(std::uint32_t place) {
  if (marks_[place] == call_) return;
  marks_[place] = call_;
  seen_.push_back(place);
}

const std::vector<std::uint32_t>& SeenPlaces::from(std::size_t i) {
  ++call_;
  seen_.clear();
  const Point origin = places_[i];
  for (std::size_t k = first_triangle_[i]; k < first_triangle_[i + 1]; ++k) {
    const std::uint32_t t = triangles_[k];
    for (std::uint32_t n = first_place_[t]; n < first_place_[t + 1]; ++n) add(place_[n]);
    for (int side = 0; side < 3; ++side) {
      const Point right = point(t, Tri::ccw(side)), left = point(t, Tri::cw(side));
      // Through a side that the origin lies on nothing is seen that its other triangle does not see.
      if (!written::on_segment(origin, right, left)) spread(origin, {t, side, right, left});
    }
  }
  return seen_;
}

void SeenPlaces::spread(Point origin, const View& first) {
  open_.assign(1, first);
  while (!open_.empty()) {
    const View view = open_.back();
    open_.pop_back();
    if (tri_.is_constrained(view.triangle, view.side)) continue;
    look_into(origin, view, tri_.neighbours[view.triangle][view.side], tri_.mirror(view.triangle, view.side));
  }
}

/// `corner` lies beyond the side that the view comes through.
void SeenPlaces::look_into(Point origin, const View& view, std::uint32_t triangle, int corner) {
  const auto from_right = [&](Point p) { return written::orientation(origin, view.right, p); };
  const auto from_left = [&](Point p) { return written::orientation(origin, view.left, p); };
  for (std::uint32_t n = first_place_[triangle]; n < first_place_[triangle + 1]; ++n) {
    const Point p = places_[place_[n]];
    if (from_right(p) >= 0 && from_left(p) <= 0) add(place_[n]);
  }
  const Point apex = point(triangle, corner);
  const int r = from_right(apex), l = from_left(apex);
  if (l < 0) open_.push_back({triangle, Tri::cw(corner), r >= 0 ? apex : view.right, view.left});
  if (r > 0) open_.push_back({triangle, Tri::ccw(corner), view.right, l <= 0 ? apex : view.left});
}

}  // namespace taut::detail
