#include <taut/search/no_path.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include <taut/geometry/rounding.h>
#include <taut/geometry/written.h>
#include <taut/search/detail/room_entries.h>

namespace taut {

namespace {

using Parts = std::vector<std::uint32_t>;

constexpr double kSlack = 0x1p-20;  // of a disc's radius, for what roundings move

Parts parts_at(const FreeSpace& space, Point p) {
  const Triangulation& tri = space.triangulation();
  const Location at = space.locate(p);
  if (at.kind == Location::Kind::outside) return {};
  Parts parts{space.component(at.triangle)};
  if (at.kind == Location::Kind::side) {
    const std::uint32_t across = tri.neighbours[at.triangle][at.index];
    if (across != kNone && tri.free[across]) parts.push_back(space.component(across));
  }
  if (at.kind == Location::Kind::vertex)
    for (const Triangulation::Sector& sector : tri.sectors_at(tri.triangles[at.triangle][at.index]))
      parts.push_back(space.component(sector.triangle));
  return parts;
}

/// Do their insides meet? Exact: two convex shapes are apart iff a side of one of them has the other on its far side.
bool meet(const Triangulation& tri, std::uint32_t t, const Box& box) {
  Point corner[3];
  for (std::size_t i = 0; i < 3; ++i) corner[i] = tri.points[tri.triangles[t][i]];
  const auto [left, right] = std::minmax({corner[0].x, corner[1].x, corner[2].x});
  const auto [low, high] = std::minmax({corner[0].y, corner[1].y, corner[2].y});
  if (right <= box.min.x || left >= box.max.x || high <= box.min.y || low >= box.max.y) return false;
  const Point ring[] = {box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}};
  for (std::size_t i = 0; i < 3; ++i) {
    const Point a = corner[i], b = corner[(i + 1) % 3];
    if (std::all_of(std::begin(ring), std::end(ring), [&](Point q) { return written::orientation(a, b, q) <= 0; }))
      return false;
  }
  return true;
}

std::vector<std::uint32_t> triangles_in(const FreeSpace& space, const std::vector<Box>& room) {
  const Triangulation& tri = space.triangulation();
  std::vector<std::uint32_t> found;
  for (std::uint32_t t = 0; t < tri.triangles.size(); ++t)
    if (tri.free[t] && std::any_of(room.begin(), room.end(), [&](const Box& b) { return meet(tri, t, b); }))
      found.push_back(t);
  return found;
}

Parts parts_of(const FreeSpace& space, const Goal& goal) {
  if (goal.point) return parts_at(space, *goal.point);
  Parts parts;
  for (const std::uint32_t t : triangles_in(space, goal.room)) parts.push_back(space.component(t));
  return parts;
}

bool are_apart(const FreeSpace& space, Point from, const Goal& to) {
  const Parts here = parts_at(space, from), there = parts_of(space, to);
  return std::find_first_of(here.begin(), here.end(), there.begin(), there.end()) == here.end();
}

Point centre_of(const Triangulation& tri, std::uint32_t t) {
  const auto& v = tri.triangles[t];
  const Point a = tri.points[v[0]], b = tri.points[v[1]], c = tri.points[v[2]];
  return {a.x + ((b.x - a.x) + (c.x - a.x)) / 3, a.y + ((b.y - a.y) + (c.y - a.y)) / 3};
}

/// Points that stand for the goal; of a room the middles first, as they are what people think of.
std::vector<Point> points_of(const FreeSpace& space, const Goal& goal) {
  if (goal.point) return {*goal.point};
  std::vector<Point> points;
  for (const Box& box : goal.room) points.push_back(detail::middle(box));
  for (const std::uint32_t t : triangles_in(space, goal.room)) points.push_back(centre_of(space.triangulation(), t));
  return points;
}

Footprint inside_of(const Footprint& disc) {
  const double r = disc.radius() * (1 - kSlack);
  Ring ring;
  for (int i = 0; i < Footprint::kDiscSides; ++i) {
    const double angle = 2 * std::numbers::pi * i / Footprint::kDiscSides;
    ring.push_back({r * std::cos(angle), r * std::sin(angle)});
  }
  return Footprint::polygon(std::move(ring));
}

}  // namespace

struct NoPath::Impl {
  explicit Impl(FreeSpace s) : space(std::move(s)) {}

  /// Where the polygon inside the disc can be; nothing when roundings may have moved it out of the disc, or are
  /// refused.
  const std::optional<FreeSpace>& inner() {
    if (std::exchange(is_tried, true)) return inner_space;
    try {
      FreeSpace made(space.world(), inside_of(space.footprint()));
      if (made.report().displacement <= kSlack / 2 * space.footprint().radius()) inner_space = std::move(made);
    } catch (const InputError&) {
    }
    return inner_space;
  }

  FreeSpace space;
  std::optional<FreeSpace> inner_space;
  bool is_tried = false;
};

NoPath::NoPath(FreeSpace space) : impl_(std::make_unique<Impl>(std::move(space))) {}
NoPath::~NoPath() = default;

bool NoPath::holds(Point from, const Goal& to) const {
  if (!are_apart(impl_->space, from, to)) return false;
  if (impl_->space.footprint().kind() != Footprint::Kind::disc)
    return is_sure(impl_->space, from) && (!to.point || is_sure(impl_->space, *to.point));
  return impl_->inner() && are_apart(*impl_->inner(), from, to);
}

std::optional<std::vector<Constraint>> NoPath::walls(Point from, const Goal& to) const {
  using Walls = std::vector<Constraint>;
  const FreeSpace& space = impl_->space;
  if (!holds(from, to)) return std::nullopt;
  if (parts_at(space, from).empty() || parts_of(space, to).empty()) return Walls{};
  for (const Point goal : points_of(space, to)) {
    if (space.locate(goal).kind == Location::Kind::outside) continue;
    Walls chain = space.separation(from, goal);
    if (!chain.empty()) return chain;
  }
  return std::nullopt;
}

}  // namespace taut
