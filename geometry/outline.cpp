#include <taut/geometry/detail/outline.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include <taut/geometry/box_index.h>
#include <taut/geometry/written.h>

namespace taut::detail {

namespace {

// Corners only: vertices in the middle of a straight piece are left out.
Ring corners(const Ring& ring) {
  Ring kept;
  const std::size_t n = ring.size();
  for (std::size_t i = 0; i < n; ++i)
    if (written::orientation(ring[(i + n - 1) % n], ring[i], ring[(i + 1) % n]) != 0) kept.push_back(ring[i]);
  return kept;
}

void add_sides(const Ring& ring, std::vector<Segment>& sides) {
  const Ring c = corners(ring);
  for (std::size_t i = 0; i < c.size(); ++i) sides.push_back({c[i], c[(i + 1) % c.size()]});
}

// Along one side: order by the coordinate in which it is longer, in its own direction.
class Along {
 public:
  explicit Along(const Segment& side)
      : by_x_(std::abs(side.b.x - side.a.x) >= std::abs(side.b.y - side.a.y)),
        up_(by_x_ ? side.a.x < side.b.x : side.a.y < side.b.y) {}

  double key(Point p) const { return (up_ ? 1 : -1) * (by_x_ ? p.x : p.y); }
  bool before(Point p, Point q) const { return key(p) < key(q); }

 private:
  bool by_x_;
  bool up_;
};

class Cover {
 public:
  explicit Cover(const std::vector<Segment>& sides) : sides_(sides), pieces_(sides.size()) {
    std::vector<Box> boxes;
    boxes.reserve(sides.size());
    for (const Segment& s : sides) boxes.push_back(box_around(s.a, s.b));
    index_ = BoxIndex(std::move(boxes));
  }

  void add_wall(Point p, Point q) {
    index_.meeting(box_around(p, q), [&](std::uint32_t i) { add(i, p, q); });
  }

  void add_seams() {
    for (std::uint32_t j = 0; j < sides_.size(); ++j)
      index_.meeting(box_around(sides_[j].a, sides_[j].b), [&](std::uint32_t i) {
        if (i != j && Along(sides_[i]).before(sides_[j].b, sides_[j].a)) add(i, sides_[j].a, sides_[j].b);
      });
  }

  std::vector<Segment> open() {
    std::vector<Segment> result;
    for (std::uint32_t i = 0; i < sides_.size(); ++i) append_open(i, result);
    return result;
  }

 private:
  void add(std::uint32_t i, Point p, Point q) {
    const Segment& s = sides_[i];
    if (p == q || written::orientation(s.a, s.b, p) != 0 || written::orientation(s.a, s.b, q) != 0) return;
    if (Along(s).before(q, p)) std::swap(p, q);
    pieces_[i].push_back({p, q});
  }

  void append_open(std::uint32_t i, std::vector<Segment>& result) {
    const Segment& s = sides_[i];
    const Along along(s);
    auto& pieces = pieces_[i];
    std::sort(pieces.begin(), pieces.end(), [&](const Segment& u, const Segment& v) { return along.before(u.a, v.a); });
    Point reached = s.a;
    for (const Segment& piece : pieces) {
      if (along.before(reached, piece.a)) result.push_back({reached, along.before(piece.a, s.b) ? piece.a : s.b});
      if (along.before(reached, piece.b)) reached = piece.b;
      if (!along.before(reached, s.b)) return;
    }
    result.push_back({reached, s.b});
  }

  const std::vector<Segment>& sides_;
  std::vector<std::vector<Segment>> pieces_;
  BoxIndex index_{{}};
};

}  // namespace

std::vector<Segment> outline(const Polygon& polygon) {
  std::vector<Segment> sides;
  add_sides(polygon.outer, sides);
  for (const Ring& hole : polygon.holes) add_sides(hole, sides);
  return sides;
}

std::vector<Segment> outline(const std::vector<Area>& areas) {
  std::vector<Segment> sides;
  for (const Area& area : areas) {
    const std::vector<Segment> more = outline(area.polygon);
    sides.insert(sides.end(), more.begin(), more.end());
  }
  return sides;
}

std::vector<Segment> open_pieces(const std::vector<Segment>& sides, const std::vector<Wall>& walls, bool seams) {
  Cover cover(sides);
  for (const Wall& wall : walls) cover.add_wall(wall.a, wall.b);
  if (seams) cover.add_seams();
  return cover.open();
}

}  // namespace taut::detail
