#include <taut/geometry/detail/polygon_validation.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include <taut/geometry/box_index.h>
#include <taut/geometry/detail/axis_rings.h>
#include <taut/geometry/detail/polygon_mend.h>
#include <taut/geometry/detail/ring_corner.h>
#include <taut/geometry/text.h>
#include <taut/geometry/written.h>

namespace taut::detail {

namespace {

struct Side {
  Point a;
  Point b;
  std::uint32_t ring = 0;  // 0 is the outer one
  std::uint32_t index = 0;

  Segment segment() const { return {a, b}; }
};

void drop_repeats(Ring& ring) {
  ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
  while (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
}

class Gate {
 public:
  Gate(Polygon& polygon, std::vector<Flaw>& flaws) : polygon_(polygon), flaws_(flaws) {}

  /// Is the polygon as World guarantees it?
  bool run() {
    if (is_surely_regular(polygon_)) {
      turn_all();
      return true;
    }
    clean(polygon_.outer);
    for (Ring& hole : polygon_.holes) clean(hole);
    std::erase_if(polygon_.holes, [](const Ring& hole) { return hole.size() < 3; });
    if (polygon_.outer.size() < 3) return false;
    regular_ = true;
    check_rings();
    if (!regular_) return false;
    turn_all();
    if (!polygon_.holes.empty()) check_holes();
    return regular_;
  }

 private:
  void find(Flaw::Kind kind, std::string message) {
    regular_ = false;
    const auto same = [&](const Flaw& f) { return f.kind == kind; };
    if (std::none_of(flaws_.begin(), flaws_.end(), same)) flaws_.push_back({kind, std::move(message)});
  }

  void clean(Ring& ring) {
    const auto twin = std::adjacent_find(ring.begin(), ring.end());
    if (twin != ring.end()) find(Flaw::repeat, "ring repeats the point " + text(*twin));
    drop_repeats(ring);
    if (ring.size() >= 3) return;
    const std::string at = ring.empty() ? "" : " near " + text(ring.front());
    find(Flaw::flat, "ring" + at + " has fewer than 3 distinct points");
  }

  void check_rings() {
    collect_sides();
    check_spikes(polygon_.outer);
    for (const Ring& hole : polygon_.holes) check_spikes(hole);
    for (std::uint32_t i = 0; i < sides_.size(); ++i) check_side(i);
  }

  void check_holes() {
    collect_sides();
    for (std::uint32_t i = 0; i < sides_.size(); ++i) check_contacts(i);
    if (!regular_) return;
    for (std::uint32_t hole = 1; hole <= polygon_.holes.size(); ++hole) check_nesting(hole);
  }

  void turn_all() {
    turn(polygon_.outer, 1);
    for (Ring& hole : polygon_.holes) turn(hole, -1);
  }

  static void turn(Ring& ring, int wanted) {
    if (written::ring_orientation(ring) != wanted) std::reverse(ring.begin() + 1, ring.end());
  }

  void collect_sides() {
    sides_.clear();
    for (std::uint32_t id = 0; id <= polygon_.holes.size(); ++id) add_sides(id);
    std::vector<Box> boxes;
    boxes.reserve(sides_.size());
    for (const Side& s : sides_) boxes.push_back(box_around(s.a, s.b));
    index_ = BoxIndex(std::move(boxes));
  }

  void add_sides(std::uint32_t id) {
    const Ring& r = ring(id);
    for (std::size_t i = 0; i < r.size(); ++i)
      sides_.push_back({r[i], r[i + 1 == r.size() ? 0 : i + 1], id, static_cast<std::uint32_t>(i)});
  }

  const Ring& ring(std::uint32_t id) const { return id == 0 ? polygon_.outer : polygon_.holes[id - 1]; }

  void check_side(std::uint32_t i) {
    const Side& s = sides_[i];
    index_.meeting(box_around(s.a, s.b), [&](std::uint32_t j) {
      if (j > i && sides_[j].ring == s.ring) check_pair(s, sides_[j]);
    });
  }

  // Sides of one ring, s before t. Neighbours meet only at their common vertex, unless there is a spike.
  void check_pair(const Side& s, const Side& t) {
    const bool neighbours = t.index == s.index + 1 || (s.index == 0 && t.index == ring(s.ring).size() - 1);
    if (!neighbours && written::segments_meet(s.segment(), t.segment())) find_pair(s, t);
  }

  void check_spikes(const Ring& r) {
    const std::size_t n = r.size();
    for (std::size_t i = 0; i < n; ++i) {
      const Point a = r[i], b = r[(i + 1) % n], c = r[(i + 2) % n];
      if (written::orientation(a, b, c) == 0 && !written::on_segment(b, a, c))
        find(Flaw::spike, "ring has a spike at " + text(b) + ": side " + text(Segment{b, c}) +
                              " folds back over side " + text(Segment{a, b}));
    }
  }

  void find_pair(const Side& s, const Side& t) {
    const std::string sides = "side " + text(s.segment()) + " and side " + text(t.segment());
    if (written::cross_properly(s.segment(), t.segment())) return find(Flaw::crossing, "ring crosses itself: " + sides);
    std::vector<Point> shared;
    for (Point p : {t.a, t.b})
      if (written::on_segment(p, s.a, s.b)) shared.push_back(p);
    for (Point p : {s.a, s.b})
      if (written::on_segment(p, t.a, t.b)) shared.push_back(p);
    if (shared.front() != shared.back()) return find(Flaw::overlap, "ring overlaps itself: " + sides);
    find(Flaw::touch, "ring touches itself at " + text(shared.front()) + ": " + sides);
  }

  void check_contacts(std::uint32_t i) {
    const Side& s = sides_[i];
    index_.meeting(box_around(s.a, s.b), [&](std::uint32_t j) {
      const Side& t = sides_[j];
      if (t.ring <= s.ring) return;
      if (written::cross_properly(s.segment(), t.segment())) return find_rings(Flaw::reach, s, t, "crosses");
      for (Point p : {s.a, s.b})
        if (written::on_segment(p, t.a, t.b)) check_touch(s, t, p);
      for (Point p : {t.a, t.b})
        if (written::on_segment(p, s.a, s.b)) check_touch(s, t, p);
    });
  }

  // Rings of two sides that share the point p, no side of which crosses the other properly.
  void check_touch(const Side& s, const Side& t, Point p) {
    const Corner u = corner_of(ring(s.ring), s.index, p), v = corner_of(ring(t.ring), t.index, p);
    for (Point x : {u.before, u.after})
      for (Point y : {v.before, v.after})
        if (same_ray(p, x, y)) return find_rings(Flaw::along, s, t, "runs along");
    if (u.left(v.before) != u.left(v.after)) return find_rings(Flaw::reach, s, t, "crosses");
    // Free space lies to the left of every ring: outer ones are counter-clockwise, holes clockwise.
    if (!u.left(v.before) || !v.left(u.before)) find_place(t.ring, s.ring, t.a);
  }

  void find_rings(Flaw::Kind kind, const Side& s, const Side& t, const char* verb) {
    find(kind, "hole " + std::to_string(t.ring) + " " + verb + " " + name(s.ring) + ": side " + text(t.segment()) +
                   " and side " + text(s.segment()));
  }

  void find_place(std::uint32_t hole, std::uint32_t other, Point at) {
    find(Flaw::reach, "hole " + std::to_string(hole) + " at " + text(at) + " does not lie " +
                          (other == 0 ? "inside its outer ring" : "apart from " + name(other)));
  }

  static std::string name(std::uint32_t id) { return id == 0 ? "the outer ring" : "hole " + std::to_string(id); }

  // A ray to the right from one vertex; rings through that vertex have been judged as contacts.
  void check_nesting(std::uint32_t hole) {
    const Point p = ring(hole).front();
    double right = p.x;
    for (Point q : polygon_.outer) right = std::max(right, q.x);
    std::map<std::uint32_t, bool> inside;
    std::map<std::uint32_t, bool> touched;
    index_.meeting({p, {right, p.y}}, [&](std::uint32_t j) {
      Point a = sides_[j].a, b = sides_[j].b;
      if (sides_[j].ring == hole) return;
      if (written::on_segment(p, a, b)) touched[sides_[j].ring] = true;
      if ((a.y > p.y) == (b.y > p.y)) return;
      if (a.y > b.y) std::swap(a, b);
      if (written::orientation(a, b, p) > 0) inside[sides_[j].ring] ^= true;
    });
    if (!touched.contains(0) && !inside[0]) find_place(hole, 0, p);
    for (const auto& [other, in] : inside)
      if (other != 0 && in && !touched.contains(other)) find_place(hole, other, p);
  }

  Polygon& polygon_;
  std::vector<Flaw>& flaws_;
  bool regular_ = true;
  std::vector<Side> sides_;
  BoxIndex index_{{}};
};

}  // namespace

std::vector<Polygon> admit(Polygon polygon, std::vector<Flaw>& flaws, Crossings crossings) {
  std::vector<Flaw> found;
  const bool regular = Gate(polygon, found).run();
  std::vector<Polygon> result;
  const auto is_ambiguous = [](const Flaw& f) { return f.is_ambiguous(); };
  const bool clear = crossings == Crossings::even_odd || std::none_of(found.begin(), found.end(), is_ambiguous);
  if (regular)
    result.push_back(std::move(polygon));
  else if (clear && polygon.outer.size() >= 3)
    result = mended(polygon, found);
  flaws.insert(flaws.end(), found.begin(), found.end());
  return result;
}

}  // namespace taut::detail
