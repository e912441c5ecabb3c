#include <taut/geometry/detail/polygon_validation.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include <taut/geometry/box_index.h>
#include <taut/geometry/errors.h>
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

// The rays from p to x and from p to y are the same. x, y != p.
bool same_ray(Point p, Point x, Point y) { return written::orientation(p, x, y) == 0 && !written::on_segment(p, x, y); }

// What a ring looks like around one of its points: it comes from `before` and leaves to `after`.
struct Corner {
  Point before;
  Point at;
  Point after;

  Corner reversed() const { return {after, at, before}; }

  // Is the direction at -> p strictly to the left of the chain? Precondition: it is on neither arm.
  bool left(Point p) const {
    const bool left_of_in = written::orientation(before, at, p) > 0;
    const bool left_of_out = written::orientation(at, after, p) > 0;
    return written::orientation(before, at, after) > 0 ? left_of_in && left_of_out : left_of_in || left_of_out;
  }
};

class Gate {
 public:
  Gate(Polygon& polygon, const std::string& source, int line) : polygon_(polygon), source_(source), line_(line) {}

  void run() {
    check_size(polygon_.outer);
    for (Ring& hole : polygon_.holes) check_size(hole);
    collect_sides();
    check_spikes(polygon_.outer);
    for (const Ring& hole : polygon_.holes) check_spikes(hole);
    for (std::uint32_t i = 0; i < sides_.size(); ++i) check_side(i);
    turn(polygon_.outer, 1);
    for (Ring& hole : polygon_.holes) turn(hole, -1);
    if (polygon_.holes.empty()) return;
    collect_sides();
    for (std::uint32_t i = 0; i < sides_.size(); ++i) check_contacts(i);
    for (std::uint32_t hole = 1; hole <= polygon_.holes.size(); ++hole) check_nesting(hole);
  }

 private:
  [[noreturn]] void fail(const std::string& message) const { throw InputError(source_, line_, message); }

  void check_size(Ring& ring) const {
    drop_repeats(ring);
    if (ring.size() >= 3) return;
    const std::string at = ring.empty() ? "" : " near " + text(ring.front());
    fail("ring" + at + " has fewer than 3 distinct points");
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

  void check_side(std::uint32_t i) const {
    const Side& s = sides_[i];
    index_.meeting(box_around(s.a, s.b), [&](std::uint32_t j) {
      if (j > i && sides_[j].ring == s.ring) check_pair(s, sides_[j]);
    });
  }

  // Sides of one ring, s before t. Neighbours meet only at their common vertex, unless there is a spike.
  void check_pair(const Side& s, const Side& t) const {
    const bool neighbours = t.index == s.index + 1 || (s.index == 0 && t.index == ring(s.ring).size() - 1);
    if (!neighbours && written::segments_meet(s.segment(), t.segment())) fail_pair(s, t);
  }

  void check_spikes(const Ring& r) const {
    const std::size_t n = r.size();
    for (std::size_t i = 0; i < n; ++i) {
      const Point a = r[i], b = r[(i + 1) % n], c = r[(i + 2) % n];
      if (written::orientation(a, b, c) == 0 && !written::on_segment(b, a, c))
        fail("ring has a spike at " + text(b) + ": side " + text(Segment{b, c}) + " folds back over side " +
             text(Segment{a, b}));
    }
  }

  [[noreturn]] void fail_pair(const Side& s, const Side& t) const {
    const std::string sides = "side " + text(s.segment()) + " and side " + text(t.segment());
    if (written::cross_properly(s.segment(), t.segment())) fail("ring crosses itself: " + sides);
    std::vector<Point> shared;
    for (Point p : {t.a, t.b})
      if (written::on_segment(p, s.a, s.b)) shared.push_back(p);
    for (Point p : {s.a, s.b})
      if (written::on_segment(p, t.a, t.b)) shared.push_back(p);
    if (shared.front() != shared.back()) fail("ring overlaps itself: " + sides);
    fail("ring touches itself at " + text(shared.front()) + ": " + sides);
  }

  void check_contacts(std::uint32_t i) const {
    const Side& s = sides_[i];
    index_.meeting(box_around(s.a, s.b), [&](std::uint32_t j) {
      const Side& t = sides_[j];
      if (t.ring <= s.ring) return;
      if (written::cross_properly(s.segment(), t.segment())) fail_rings(s, t, "crosses");
      for (Point p : {s.a, s.b})
        if (written::on_segment(p, t.a, t.b)) check_touch(s, t, p);
      for (Point p : {t.a, t.b})
        if (written::on_segment(p, s.a, s.b)) check_touch(s, t, p);
    });
  }

  Corner corner(const Side& s, Point p) const {
    const Ring& r = ring(s.ring);
    if (p == s.a) return {r[s.index == 0 ? r.size() - 1 : s.index - 1], p, s.b};
    if (p == s.b) return {s.a, p, r[(s.index + 2) % r.size()]};
    return {s.a, p, s.b};
  }

  // Rings of two sides that share the point p, no side of which crosses the other properly.
  void check_touch(const Side& s, const Side& t, Point p) const {
    const Corner u = corner(s, p), v = corner(t, p);
    for (Point x : {u.before, u.after})
      for (Point y : {v.before, v.after})
        if (same_ray(p, x, y)) fail_rings(s, t, "runs along");
    if (u.left(v.before) != u.left(v.after)) fail_rings(s, t, "crosses");
    // Free space lies to the left of every ring: outer ones are counter-clockwise, holes clockwise.
    if (!u.left(v.before)) fail_place(t, s);
    if (!v.left(u.before)) fail_place(t, s);
  }

  [[noreturn]] void fail_rings(const Side& s, const Side& t, const char* verb) const {
    fail("hole " + std::to_string(t.ring) + " " + verb + " " + name(s.ring) + ": side " + text(t.segment()) +
         " and side " + text(s.segment()));
  }

  [[noreturn]] void fail_place(const Side& hole, const Side& other) const { fail_place(hole.ring, other.ring, hole.a); }

  [[noreturn]] void fail_place(std::uint32_t hole, std::uint32_t other, Point at) const {
    fail("hole " + std::to_string(hole) + " at " + text(at) + " does not lie " +
         (other == 0 ? "inside its outer ring" : "apart from " + name(other)));
  }

  static std::string name(std::uint32_t id) { return id == 0 ? "the outer ring" : "hole " + std::to_string(id); }

  // A ray to the right from one vertex; rings through that vertex have been judged as contacts.
  void check_nesting(std::uint32_t hole) const {
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
    if (!touched.contains(0) && !inside[0]) fail_place(hole, 0, p);
    for (const auto& [other, in] : inside)
      if (other != 0 && in && !touched.contains(other)) fail_place(hole, other, p);
  }

  Polygon& polygon_;
  const std::string& source_;
  int line_;
  std::vector<Side> sides_;
  BoxIndex index_{{}};
};

}  // namespace

void admit(Polygon& polygon, const std::string& source, int line) { Gate(polygon, source, line).run(); }

}  // namespace taut::detail
