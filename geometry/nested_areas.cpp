#include <taut/geometry/nested_areas.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>
#include <utility>

#include <taut/geometry/box_index.h>
#include <taut/geometry/detail/ring_corner.h>

namespace taut {

namespace {

using detail::Corner;

struct Side {
  Point a;
  Point b;
  std::uint32_t area = 0;
  std::uint32_t ring = 0;  // 0 is the outer one
  std::uint32_t index = 0;

  Segment segment() const { return {a, b}; }
};

bool holds(const Box& outer, const Box& inner) {
  return outer.min.x <= inner.min.x && outer.min.y <= inner.min.y && inner.max.x <= outer.max.x &&
         inner.max.y <= outer.max.y;
}

class Nesting {
 public:
  explicit Nesting(const std::vector<Area>& areas) : areas_(areas) {
    for (std::uint32_t i = 0; i < areas.size(); ++i) {
      boxes_.push_back(box_around(areas[i].polygon.outer));
      first_side_.push_back(sides_.size());
      for (std::uint32_t r = 0; r <= areas[i].polygon.holes.size(); ++r) add_sides(i, r);
    }
    first_side_.push_back(sides_.size());
    area_index_ = BoxIndex(boxes_);
    std::vector<Box> boxes;
    for (const Side& s : sides_) boxes.push_back(box_around(s.a, s.b));
    side_index_ = BoxIndex(std::move(boxes));
  }

  std::vector<NestedArea> run() {
    std::vector<NestedArea> result;
    for (std::uint32_t i = 0; i < areas_.size(); ++i) {
      const std::vector<std::uint32_t> around = those_around(i);
      // Of two that are equal the first stays.
      const auto outer = std::find_if(around.begin(), around.end(), [&](std::uint32_t j) {
        if (boxes_[i] != boxes_[j] || j < i) return true;
        const std::vector<std::uint32_t> back = those_around(j);
        return std::find(back.begin(), back.end(), i) == back.end();
      });
      if (outer != around.end()) result.push_back({i, *outer});
    }
    return result;
  }

 private:
  // How the rings of an area meet those of one whose box holds it.
  struct Meeting {
    std::set<std::uint32_t> inner;  // rings that have a contact
    std::set<std::uint32_t> outer;
  };

  const Ring& ring(std::uint32_t area, std::uint32_t id) const {
    const Polygon& polygon = areas_[area].polygon;
    return id == 0 ? polygon.outer : polygon.holes[id - 1];
  }

  void add_sides(std::uint32_t area, std::uint32_t id) {
    const Ring& r = ring(area, id);
    for (std::uint32_t i = 0; i < r.size(); ++i)
      sides_.push_back({r[i], r[i + 1 == r.size() ? 0 : i + 1], area, id, i});
  }

  // The areas that area i lies in.
  std::vector<std::uint32_t> those_around(std::uint32_t i) const {
    std::map<std::uint32_t, Meeting> meetings;
    area_index_.meeting(boxes_[i], [&](std::uint32_t j) {
      if (j != i && holds(boxes_[j], boxes_[i])) meetings[j];
    });
    for (std::size_t s = first_side_[i]; s < first_side_[i + 1] && !meetings.empty(); ++s) meet(sides_[s], meetings);
    std::vector<std::uint32_t> result;
    for (const auto& [j, meeting] : meetings)
      if (lies_in(i, j, meeting)) result.push_back(j);
    return result;
  }

  // Drops the areas that side s of another leads out of.
  void meet(const Side& s, std::map<std::uint32_t, Meeting>& meetings) const {
    side_index_.meeting(box_around(s.a, s.b), [&](std::uint32_t k) {
      const Side& t = sides_[k];
      const auto found = meetings.find(t.area);
      if (found == meetings.end() || !written::segments_meet(s.segment(), t.segment())) return;
      found->second.inner.insert(s.ring);
      found->second.outer.insert(t.ring);
      if (written::cross_properly(s.segment(), t.segment()) || !stays(s, t)) meetings.erase(found);
    });
  }

  // Where they touch, does the area of side s stay within that of t?
  bool stays(const Side& s, const Side& t) const {
    for (Point p : {s.a, s.b})
      if (written::on_segment(p, t.a, t.b) && !stays(s, t, p)) return false;
    for (Point p : {t.a, t.b})
      if (written::on_segment(p, s.a, s.b) && !stays(s, t, p)) return false;
    return true;
  }

  bool stays(const Side& s, const Side& t, Point p) const {
    const Corner inner = corner(s, p), outer = corner(t, p);
    for (Point q : {inner.before, inner.after})
      if (!outer.on_arm(q) && !outer.left(q)) return false;
    // A stretch of wall that both have, but from the other side.
    if (detail::same_ray(p, inner.after, outer.before) || detail::same_ray(p, inner.before, outer.after)) return false;
    return !leads_inside(s.area, p, outer.before) && !leads_inside(s.area, p, outer.after);
  }

  Corner corner(const Side& s, Point p) const { return detail::corner_of(ring(s.area, s.ring), s.index, p); }

  // From its point p towards q, is the inside of the area at once? Several of its rings may touch at p.
  bool leads_inside(std::uint32_t area, Point p, Point q) const {
    bool inside = true;
    side_index_.meeting({p, p}, [&](std::uint32_t k) {
      const Side& s = sides_[k];
      if (!inside || s.area != area || !written::on_segment(p, s.a, s.b)) return;
      const Corner at = corner(s, p);
      inside = !at.on_arm(q) && at.left(q);
    });
    return inside;
  }

  // Nothing of the rings crosses: what is left to ask of rings without contact is a point each.
  bool lies_in(std::uint32_t i, std::uint32_t j, const Meeting& meeting) const {
    for (std::uint32_t r = 0; r <= areas_[i].polygon.holes.size(); ++r)
      if (!meeting.inner.contains(r) && !is_inside(ring(i, r).front(), j)) return false;
    std::set<std::uint32_t> seen = meeting.outer;
    bool clear = true;
    side_index_.meeting(boxes_[i], [&](std::uint32_t k) {
      const Side& t = sides_[k];
      if (t.area == j && clear && seen.insert(t.ring).second && is_inside(t.a, i)) clear = false;
    });
    return clear;
  }

  // Precondition: p is on none of its rings.
  bool is_inside(Point p, std::uint32_t area) const {
    bool inside = false;
    side_index_.meeting({p, {std::max(p.x, boxes_[area].max.x), p.y}}, [&](std::uint32_t k) {
      if (sides_[k].area != area) return;
      Point a = sides_[k].a, b = sides_[k].b;
      if ((a.y > p.y) == (b.y > p.y)) return;
      if (a.y > b.y) std::swap(a, b);
      if (written::orientation(a, b, p) > 0) inside = !inside;
    });
    return inside;
  }

  const std::vector<Area>& areas_;
  std::vector<Box> boxes_;
  std::vector<Side> sides_;
  std::vector<std::size_t> first_side_;
  BoxIndex area_index_{{}};
  BoxIndex side_index_{{}};
};

}  // namespace

std::vector<NestedArea> nested_areas(const std::vector<Area>& areas) {
  if (areas.size() < 2) return {};
  return Nesting(areas).run();
}

}  // namespace taut
