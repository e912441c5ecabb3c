#include <taut/geometry/detail/locator.h>

#include <algorithm>
#include <cmath>

#include <taut/geometry/written.h>

namespace taut::detail {

namespace {

using Tri = Triangulation;

int side_of(const Tri& tri, std::uint32_t t, int i, Point p) {
  const auto& v = tri.triangles[t];
  return written::orientation(tri.points[v[Tri::ccw(i)]], tri.points[v[Tri::cw(i)]], p);
}

bool contains(const Tri& tri, std::uint32_t t, Point p) {
  return side_of(tri, t, 0, p) >= 0 && side_of(tri, t, 1, p) >= 0 && side_of(tri, t, 2, p) >= 0;
}

Location at_vertex(const Tri& tri, std::uint32_t v) {
  const auto sectors = tri.sectors_at(v);
  if (sectors.empty()) return {};
  const std::uint32_t t = sectors.front().triangle;
  return {Location::Kind::vertex, t, tri.corner(t, v)};
}

Location on_side(const Tri& tri, std::uint32_t t, int i) {
  if (!tri.free[t]) {
    const std::uint32_t n = tri.neighbours[t][i];
    if (n == kNone || !tri.free[n]) return {};
    i = tri.mirror(t, i);
    t = n;
  }
  return {tri.is_constrained(t, i) ? Location::Kind::side : Location::Kind::triangle, t, i};
}

}  // namespace

Locator::Locator(const Tri& tri) {
  if (tri.points.empty()) return;
  box_ = {tri.points[0], tri.points[0]};
  for (const Point p : tri.points) {
    box_.min = {std::min(box_.min.x, p.x), std::min(box_.min.y, p.y)};
    box_.max = {std::max(box_.max.x, p.x), std::max(box_.max.y, p.y)};
  }
  const double width = box_.max.x - box_.min.x, height = box_.max.y - box_.min.y,
               cells = 1 + static_cast<double>(tri.triangles.size()) / 2;
  columns_ = static_cast<std::uint32_t>(std::clamp(std::sqrt(cells * (width / height)), 1.0, cells));
  rows_ = static_cast<std::uint32_t>(std::clamp(cells / columns_, 1.0, cells));
  per_x_ = columns_ / width;
  per_y_ = rows_ / height;
  hints_.assign(std::size_t{columns_} * rows_, kNone);
  for (std::uint32_t t = 0; t < tri.triangles.size(); ++t) {
    const auto& v = tri.triangles[t];
    const Point a = tri.points[v[0]], b = tri.points[v[1]], c = tri.points[v[2]];
    hints_[cell({(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3})] = t;
  }
  std::uint32_t last = 0;
  for (std::uint32_t& hint : hints_) last = hint = hint == kNone ? last : hint;
}

std::uint32_t Locator::cell(Point p) const {
  const auto index = [](double offset, double per, std::uint32_t count) {
    return static_cast<std::uint32_t>(std::clamp(offset * per, 0.0, static_cast<double>(count - 1)));
  };
  return index(p.y - box_.min.y, per_y_, rows_) * columns_ + index(p.x - box_.min.x, per_x_, columns_);
}

std::uint32_t Locator::walk(const Tri& tri, Point p) const {
  std::uint32_t t = hints_[cell(p)];
  // A visibility walk ends in a Delaunay triangulation; constraints could make it circle, so its length is bounded.
  for (std::size_t steps = 0; steps < 64 + tri.triangles.size() / 4; ++steps) {
    int out = -1;
    for (int k = 0; k < 3 && out < 0; ++k) {
      const int i = (k + static_cast<int>(steps)) % 3;
      if (side_of(tri, t, i, p) < 0) out = i;
    }
    if (out < 0) return t;
    if (tri.neighbours[t][out] == kNone) return kNone;  // beyond a side of the convex hull
    t = tri.neighbours[t][out];
  }
  for (t = 0; t < tri.triangles.size(); ++t)
    if (contains(tri, t, p)) return t;
  return kNone;
}

Location Locator::locate(const Tri& tri, Point p) const {
  if (tri.triangles.empty() || !box_.contains(p)) return {};
  const std::uint32_t t = walk(tri, p);
  if (t == kNone) return {};
  for (const std::uint32_t v : tri.triangles[t])
    if (tri.points[v] == p) return at_vertex(tri, v);
  for (int i = 0; i < 3; ++i)
    if (side_of(tri, t, i, p) == 0) return on_side(tri, t, i);
  if (!tri.free[t]) return {};
  return {Location::Kind::triangle, t, 0};
}

}  // namespace taut::detail
