#include <taut/roadmaps/wall_index.h>

#include <algorithm>
#include <numeric>

#include <taut/geometry/written.h>

namespace taut {

namespace {

/// Where one may stand but not leave.
std::vector<Segment> openings_of(const World& world) {
  if (world.boundary() == Boundary::limit) return world.openings();
  std::vector<Segment> result;
  if (world.boundary() != Boundary::open) return result;
  const auto add = [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) result.push_back({ring[i], ring[(i + 1) % ring.size()]});
  };
  for (const Area& area : world.areas()) {
    add(area.polygon.outer);
    for (const Ring& hole : area.polygon.holes) add(hole);
  }
  return result;
}

}  // namespace

WallIndex::WallIndex(const FreeSpace& space)
    : space_(space), wall_boxes_((find_ends(), find_openings(), boxes_of_walls())) {
  flood();
  find_triangles();
}

Segment WallIndex::segment(std::uint32_t constraint) const {
  const Constraint& c = space_.constraints()[constraint];
  return {c.a, c.b};
}

std::span<const std::uint32_t> WallIndex::at(std::uint32_t v) const {
  return std::span(incident_).subspan(first_[v], first_[v + 1] - first_[v]);
}

std::span<const std::uint32_t> WallIndex::around(std::uint32_t v) const {
  return std::span(triangles_).subspan(first_triangle_[v], first_triangle_[v + 1] - first_triangle_[v]);
}

std::uint32_t WallIndex::along(std::uint32_t t, int i) const {
  const Triangulation& tri = triangulation();
  if (!tri.is_constrained(t, i)) return kNone;
  const std::uint32_t u = tri.triangles[t][Triangulation::ccw(i)], v = tri.triangles[t][Triangulation::cw(i)];
  for (const std::uint32_t c : at(u))
    if (ends_[c][0] == v || ends_[c][1] == v) return c;
  return kNone;
}

void WallIndex::find_ends() {
  const std::vector<Point>& points = triangulation().points;
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return points[a] < points[b]; });
  const auto vertex = [&](Point p) {
    return *std::lower_bound(order.begin(), order.end(), p, [&](std::uint32_t v, Point q) { return points[v] < q; });
  };
  for (const Constraint& c : space_.constraints()) ends_.push_back({vertex(c.a), vertex(c.b)});

  first_.assign(points.size() + 1, 0);
  for (const auto& pair : ends_)
    for (const std::uint32_t v : pair) ++first_[v + 1];
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  incident_.resize(2 * ends_.size());
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for (std::uint32_t c = 0; c < ends_.size(); ++c)
    for (const std::uint32_t v : ends_[c]) incident_[next[v]++] = c;
}

void WallIndex::find_openings() {
  const std::vector<Segment> openings = openings_of(space_.world());
  std::vector<Box> boxes;
  boxes.reserve(openings.size());
  for (const Segment& s : openings) boxes.push_back(box_around(s.a, s.b));
  const BoxIndex index(std::move(boxes));
  opening_.assign(ends_.size(), 0);
  wall_vertex_.assign(triangulation().points.size(), 0);
  for (std::uint32_t c = 0; c < ends_.size(); ++c) {
    const auto [a, b] = segment(c);
    if (const Constraint& piece = space_.constraints()[c]; !piece.is_wall() && piece.wall == kNone)
      index.meeting(box_around(a, b), [&, a = a, b = b](std::uint32_t i) {
        if (written::on_segment(a, openings[i].a, openings[i].b) &&
            written::on_segment(b, openings[i].a, openings[i].b))
          opening_[c] = 1;
      });
    if (!opening_[c])
      for (const std::uint32_t v : ends_[c]) wall_vertex_[v] = 1;
  }
}

std::vector<Box> WallIndex::boxes_of_walls() {
  std::vector<Box> boxes;
  for (std::uint32_t c = 0; c < ends_.size(); ++c) {
    if (opening_[c]) continue;
    walls_.push_back(c);
    boxes.push_back(box_around(segment(c).a, segment(c).b));
  }
  return boxes;
}

void WallIndex::flood() {
  const Triangulation& tri = triangulation();
  open_ = tri.free;
  std::vector<std::uint32_t> stack;
  for (std::uint32_t t = 0; t < tri.triangles.size(); ++t)
    if (open_[t]) stack.push_back(t);
  while (!stack.empty()) {
    const std::uint32_t t = stack.back();
    stack.pop_back();
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t n = tri.neighbours[t][i];
      if (n == kNone || open_[n]) continue;
      if (const std::uint32_t c = along(t, i); c != kNone && !opening_[c]) continue;
      open_[n] = 1;
      stack.push_back(n);
    }
  }
}

void WallIndex::find_triangles() {
  const Triangulation& tri = triangulation();
  first_triangle_.assign(tri.points.size() + 1, 0);
  const auto each_corner = [&](auto visit) {
    for (std::uint32_t t = 0; t < tri.triangles.size(); ++t)
      if (open_[t])
        for (const std::uint32_t v : tri.triangles[t]) visit(t, v);
  };
  each_corner([&](std::uint32_t, std::uint32_t v) { ++first_triangle_[v + 1]; });
  std::partial_sum(first_triangle_.begin(), first_triangle_.end(), first_triangle_.begin());
  triangles_.resize(first_triangle_.back());
  std::vector<std::uint32_t> next(first_triangle_.begin(), first_triangle_.end() - 1);
  each_corner([&](std::uint32_t t, std::uint32_t v) { triangles_[next[v]++] = t; });
}

}  // namespace taut
