#include <taut/geometry/noded_parts.h>

#include <algorithm>
#include <utility>
#include <vector>

#include <taut/geometry/box.h>
#include <taut/geometry/detail/near_pairs.h>
#include <taut/geometry/exact/exact_point.h>
#include <taut/geometry/written.h>

namespace taut {

namespace {

bool along_axis(const Segment& s) { return s.a.x == s.b.x || s.a.y == s.b.y; }

std::vector<Point> with_ends(const WorldParts& parts, std::span<const Point> places) {
  std::vector<Point> all(places.begin(), places.end());
  if (parts.start) all.push_back(*parts.start);
  if (parts.goal.point) all.push_back(*parts.goal.point);
  return all;
}

class Noder {
 public:
  Noder(const WorldParts& parts, std::span<const Point> places)
      : pairs_(parts, with_ends(parts, places)), nodes_(pairs_.pieces().size()) {
    if (pairs_.pieces().empty()) return;
    touch();
    cross();
    for (std::uint32_t i = 0; i < nodes_.size(); ++i) arrange(i);
  }

  void rebuild(WorldParts& parts) const {
    std::uint32_t i = 0;
    std::vector<Wall> walls;
    for (const Wall& wall : parts.walls) {
      Point from = wall.a;
      for (const Point p : nodes_[i]) walls.push_back({std::exchange(from, p), p, wall.thickness, wall.line});
      walls.push_back({from, wall.b, wall.thickness, wall.line});
      ++i;
    }
    parts.walls = std::move(walls);
    detail::for_each_ring(parts, [&](Ring& ring, std::uint32_t, int) {
      Ring more;
      for (const Point p : ring) {
        more.push_back(p);
        more.insert(more.end(), nodes_[i].begin(), nodes_[i].end());
        ++i;
      }
      ring = std::move(more);
    });
  }

 private:
  bool is_thick(std::uint32_t i) const { return pairs_.pieces()[i].thickness > 0; }

  void touch() {
    for (const Point p : pairs_.points())
      pairs_.near(p, 0, [&](std::uint32_t i) {
        const Segment s = pairs_.segment(i);
        if (is_thick(i) || along_axis(s) || p == s.a || p == s.b) return;
        if (written::on_segment(p, s.a, s.b)) nodes_[i].push_back(p);
      });
  }

  void cross() {
    std::vector<Box> boxes;
    for (std::uint32_t i = 0; i < nodes_.size(); ++i) {
      const Segment s = pairs_.segment(i);
      boxes.push_back(box_around(s.a, s.b));
    }
    const DecimalUnit unit(box_around(pairs_.points()));
    const BoxIndex index(boxes);
    for (std::uint32_t i = 0; i < nodes_.size(); ++i) {
      if (is_thick(i) || along_axis(pairs_.segment(i))) continue;
      index.meeting(boxes[i], [&](std::uint32_t j) {
        if (j < i && !along_axis(pairs_.segment(j))) return;  // met already, from there
        if (!is_thick(j)) cross(i, j, unit);
      });
    }
  }

  void cross(std::uint32_t i, std::uint32_t j, const DecimalUnit& unit) {
    const Segment s = pairs_.segment(i), t = pairs_.segment(j);
    if (!written::cross_properly(s, t)) return;
    const ExactPoint crossing = line_crossing(s, t);
    const std::optional<Point> exact = exactly(crossing);
    const Point node = exact ? *exact : unit.nearest(crossing);
    nodes_[i].push_back(node);
    nodes_[j].push_back(node);
  }

  /// From the piece's first end to its other one, each once.
  void arrange(std::uint32_t i) {
    const Segment s = pairs_.segment(i);
    std::vector<Point>& nodes = nodes_[i];
    const double right = s.a.x < s.b.x ? 1 : s.a.x > s.b.x ? -1 : 0, up = s.a.y < s.b.y ? 1 : -1;
    std::sort(nodes.begin(), nodes.end(), [&](Point p, Point q) {
      if (right != 0 && p.x != q.x) return right * p.x < right * q.x;
      return up * p.y < up * q.y;
    });
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    std::erase_if(nodes, [&](Point p) { return p == s.a || p == s.b; });
  }

  detail::NearPairs pairs_;
  std::vector<std::vector<Point>> nodes_;  // of each piece
};

}  // namespace

WorldParts noded(WorldParts parts, std::span<const Point> places) {
  Noder(parts, places).rebuild(parts);
  return parts;
}

}  // namespace taut
