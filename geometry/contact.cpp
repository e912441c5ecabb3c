#include <taut/geometry/contact.h>

#include <algorithm>
#include <utility>

#include <taut/geometry/written.h>

namespace taut {

namespace {

/// Is the direction c -> p in the lower half of the circle, [180, 360) degrees?
bool lower_half(Point c, Point p) { return p.y < c.y || (p.y == c.y && p.x < c.x); }

/// Which of the directions c -> p, c -> q has the smaller angle in [0, 360): -1 p, 0 the same, +1 q. Within one half of
/// the circle two directions differ by less than 180 degrees, so the orientation orders them.
int compare_angle(Point c, Point p, Point q) {
  const bool p_low = lower_half(c, p), q_low = lower_half(c, q);
  if (p_low != q_low) return p_low ? 1 : -1;
  return -written::orientation(c, p, q);
}

bool contains(const Sectors& sectors, std::uint32_t sector) {
  return std::binary_search(sectors.begin(), sectors.end(), sector);
}

void insert_ray(std::vector<Star::Ray>& rays, Point centre, const Constraint& c, std::uint32_t piece) {
  if (centre != c.b) rays.push_back({c.b, piece, c.solid_left, c.solid_right});
  if (centre != c.a) rays.push_back({c.a, piece, c.solid_right, c.solid_left});
}

}  // namespace

Star::Star(Point centre, std::span<const Constraint> constraints, std::span<const std::uint32_t> pieces)
    : centre_(centre) {
  for (const std::uint32_t i : pieces) insert_ray(rays_, centre, constraints[i], i);
  std::sort(rays_.begin(), rays_.end(),
            [&](const Ray& r, const Ray& s) { return compare_angle(centre, r.towards, s.towards) < 0; });
}

bool Star::solid(std::uint32_t sector) const {
  if (rays_.empty()) return false;
  const Ray& first = rays_[sector];
  const Ray& last = rays_[(sector + 1) % rays_.size()];
  return first.solid_ccw || last.solid_cw;
}

Sectors Star::free_sectors() const {
  Sectors result;
  for (std::uint32_t s = 0; s < sector_count(); ++s)
    if (!solid(s)) result.push_back(s);
  return result;
}

bool Star::reflex(std::uint32_t sector) const {
  if (rays_.empty()) return false;
  if (rays_.size() == 1) return true;
  return written::orientation(centre_, rays_[sector].towards, rays_[(sector + 1) % rays_.size()].towards) < 0;
}

Star::Direction Star::direction(Point to) const {
  if (rays_.empty()) return {0, 0};
  const auto after = std::partition_point(rays_.begin(), rays_.end(),
                                          [&](const Ray& r) { return compare_angle(centre_, r.towards, to) < 0; });
  const auto n = sector_count();
  const auto i = static_cast<std::uint32_t>(after - rays_.begin());
  const std::uint32_t before = (i + n - 1) % n;
  const bool on_ray = i < n && compare_angle(centre_, after->towards, to) == 0;
  return {on_ray ? i : before, before};
}

std::uint32_t Star::sector_left_of(Point to) const { return direction(to).left; }

Sides Star::leave(const Sectors& sectors, Point to) const {
  const auto [left, right] = direction(to);
  const Sides on_left = contains(sectors, left) ? kLeftSide : kNoSide;
  const Sides on_right = contains(sectors, right) ? kRightSide : kNoSide;
  return Sides(on_left | on_right);
}

Sectors Star::arrive(Point from, Sides sides) const {
  // Looking back to where it came from, left and right of the travel are exchanged.
  const auto [back_left, back_right] = direction(from);
  Sectors result;
  if ((sides & kLeftSide) && !solid(back_right)) result.push_back(back_right);
  if ((sides & kRightSide) && !solid(back_left)) result.push_back(back_left);
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

bool Star::tangent(Point q) const {
  bool left = false, right = false;
  for (const Ray& r : rays_) {
    const int side = written::orientation(centre_, q, r.towards);
    left |= side > 0;
    right |= side < 0;
  }
  return !(left && right);
}

namespace {

/// Do two closed segments of one line share a point?
bool overlap_on_line(const Segment& leg, const Constraint& c) {
  const auto [a, b] = std::minmax(leg.a, leg.b);
  const auto [x, y] = std::minmax(c.a, c.b);
  return a <= y && x <= b;
}

}  // namespace

Contact contact(const Segment& leg, const Constraint& c) {
  if (leg.a == leg.b) return written::on_segment(leg.a, c.a, c.b) ? Contact::touch : Contact::none;
  const int a = written::orientation(leg.a, leg.b, c.a), b = written::orientation(leg.a, leg.b, c.b);
  if (a * b > 0) return Contact::none;
  if (a == 0 && b == 0) return overlap_on_line(leg, c) ? Contact::touch : Contact::none;
  const int from = written::orientation(c.a, c.b, leg.a), to = written::orientation(c.a, c.b, leg.b);
  if (from * to > 0) return Contact::none;
  // Neither is on one side of the other's line, so they meet in one point; inside both unless an end lies on the
  // other's line.
  return a != 0 && b != 0 && from != 0 && to != 0 ? Contact::cross : Contact::touch;
}

Star star_at(Point centre, std::span<const Constraint> constraints, std::span<const std::uint32_t> touching) {
  std::vector<std::uint32_t> pieces;
  for (const std::uint32_t i : touching)
    if (written::on_segment(centre, constraints[i].a, constraints[i].b)) pieces.push_back(i);
  return Star(centre, constraints, pieces);
}

namespace {

struct Touch {
  Point at;
  std::uint32_t piece;
};

/// Every contact point of the leg with every piece that contains it, in order along the leg. A contact is an end of the
/// leg or of a piece: a piece's interior is met only by an end of the leg, or along a stretch whose ends are such
/// points.
std::vector<Touch> touches_along(const Segment& leg, std::span<const Constraint> constraints,
                                 std::span<const std::uint32_t> touching) {
  std::vector<Touch> result;
  for (const std::uint32_t i : touching) {
    const Constraint& c = constraints[i];
    for (const Point p : {c.a, c.b})
      if (written::on_segment(p, leg.a, leg.b)) result.push_back({p, i});
    for (const Point p : {leg.a, leg.b})
      if (p != c.a && p != c.b && written::on_segment(p, c.a, c.b)) result.push_back({p, i});
  }
  // On a line the lexicographic order is the order along it.
  const bool forward = leg.a < leg.b;
  std::sort(result.begin(), result.end(), [forward](const Touch& s, const Touch& t) {
    if (s.at != t.at) return (s.at < t.at) == forward;
    return s.piece < t.piece;
  });
  return result;
}

/// Takes the touches at `at` from the front of `rest`.
Star take_star(Point at, std::span<const Touch>& rest, std::span<const Constraint> constraints) {
  std::vector<std::uint32_t> pieces;
  for (; !rest.empty() && rest.front().at == at; rest = rest.subspan(1)) pieces.push_back(rest.front().piece);
  return Star(at, constraints, pieces);
}

LegPassage blocked_at(const Star& star) {
  LegPassage result{true, star.centre(), {}, {}};
  for (const Star::Ray& r : star.rays()) result.pieces.push_back(r.piece);
  std::sort(result.pieces.begin(), result.pieces.end());
  result.pieces.erase(std::unique(result.pieces.begin(), result.pieces.end()), result.pieces.end());
  return result;
}

}  // namespace

LegPassage pass(const Segment& leg, const Sectors& from, std::span<const Constraint> constraints,
                std::span<const std::uint32_t> touching) {
  if (leg.a == leg.b) return {false, {}, {}, from};
  const std::vector<Touch> touches = touches_along(leg, constraints, touching);
  std::span<const Touch> rest = touches;
  Star here = take_star(leg.a, rest, constraints);
  Sectors sectors = from;
  while (here.centre() != leg.b) {
    const Sides sides = here.leave(sectors, leg.b);
    if (sides == kNoSide) return blocked_at(here);
    Star next = take_star(rest.empty() ? leg.b : rest.front().at, rest, constraints);
    sectors = next.arrive(leg.a, sides);
    if (sectors.empty()) return blocked_at(next);
    here = std::move(next);
  }
  return {false, {}, {}, std::move(sectors)};
}

}  // namespace taut
