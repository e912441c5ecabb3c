#include <taut/search/detail/room_entries.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include <taut/geometry/cell_plan.h>
#include <taut/geometry/contact.h>
#include <taut/geometry/exact/exact_point.h>
#include <taut/geometry/written.h>
#include <taut/search/query_ends.h>

namespace taut::detail {

namespace {

bool vertical(const Segment& s) { return s.a.x == s.b.x; }

std::vector<Point> meeting_points(const Segment& side, const Constraint& c) {
  std::vector<Point> points;
  for (const Point p : {c.a, c.b})
    if (written::on_segment(p, side.a, side.b)) points.push_back(p);
  if (!written::cross_properly(side, {c.a, c.b})) return points;
  const ExactPoint exact = line_crossing(side, {c.a, c.b});
  const Point p = nearest_point(exact);
  points.push_back(p);
  if (ExactPoint(p) == exact) return points;
  // One of the doubles next to it lies in the free space; the other is dropped as no place to be.
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const double towards : {-kInfinity, kInfinity})
    points.push_back(vertical(side) ? Point{p.x, std::nextafter(p.y, towards)}
                                    : Point{std::nextafter(p.x, towards), p.y});
  return points;
}

bool lies_inside(const Box& b, Point p) { return b.min.x < p.x && p.x < b.max.x && b.min.y < p.y && p.y < b.max.y; }

/// What may meet a side.
std::vector<Constraint> pieces_near(const FreeSpace& space, const Segment& side) {
  std::vector<Constraint> pieces;
  if (const CellPlan* plan = space.cells()) {
    plan->append_along(side, pieces);
    return pieces;
  }
  for (const Constraint& c : space.constraints()) {
    if (std::max(c.a.x, c.b.x) < side.a.x || std::min(c.a.x, c.b.x) > side.b.x || std::max(c.a.y, c.b.y) < side.a.y ||
        std::min(c.a.y, c.b.y) > side.b.y)
      continue;
    pieces.push_back(c);
  }
  return pieces;
}

/// Where the inside of a box is, seen from a place on its rim: to the right (x > 0) or left, above or below; 0: both.
struct Inwards {
  int x, y;

  Inwards(const Box& box, Point p)
      : x((p.x == box.min.x) - (p.x == box.max.x)), y((p.y == box.min.y) - (p.y == box.max.y)) {}

  bool holds(Point p, Point towards) const {
    return (x == 0 || x * towards.x > x * p.x) && (y == 0 || y * towards.y > y * p.y);
  }
};

Point straight(Point p, double dx, double dy, double far) { return {p.x + dx * far, p.y + dy * far}; }

/// What lies ahead of p counter-clockwise: the rim of the box, pieces that lead into it, the rim again.
std::vector<Point> directions_in(const Box& box, Point p, const Star& star, double far) {
  const Inwards in(box, p);
  std::vector<Point> inner;
  for (const Star::Ray& ray : star.rays())
    if (in.holds(p, ray.towards)) inner.push_back(ray.towards);
  std::sort(inner.begin(), inner.end(), [&](Point a, Point b) { return written::orientation(p, a, b) > 0; });
  Point first = straight(p, in.x == 0 ? in.y : 0, in.x == 0 ? 0 : -in.x, far);
  Point last = straight(p, in.x == 0 ? -in.y : 0, in.x == 0 ? 0 : in.x, far);
  if (in.x != 0 && in.y != 0) {
    first = straight(p, in.x, 0, far), last = straight(p, 0, in.y, far);
    if (in.x != in.y) std::swap(first, last);
  }
  inner.insert(inner.begin(), first);
  inner.push_back(last);
  return inner;
}

/// A point from p strictly between two directions, the second less than half a turn counter-clockwise of the first;
/// nothing where they are so close together that no double is found there.
std::optional<Point> between(Point p, Point a, Point b, double far) {
  const double ax = a.x - p.x, ay = a.y - p.y, bx = b.x - p.x, by = b.y - p.y;
  const double m = std::hypot(ax, ay), n = std::hypot(bx, by);
  const Point q = straight(p, ax / m + bx / n, ay / m + by / n, far);
  if (written::orientation(p, a, q) <= 0 || written::orientation(p, q, b) <= 0) return std::nullopt;
  return q;
}

/// Into the box from a place on its side, one way for each part that the pieces there (`touching`) leave: points that
/// lie straight ahead.
std::vector<Point> ways_in(const RoomSide& side, Point p, const std::vector<Constraint>& pieces,
                           const std::vector<std::uint32_t>& touching) {
  const double far = std::min(side.box.max.x - side.box.min.x, side.box.max.y - side.box.min.y) / 4;
  const Star star = star_at(p, pieces, touching);
  const std::vector<Point> directions = directions_in(side.box, p, star, far);
  if (directions.size() == 2) return {side.inside};
  std::vector<Point> ways;
  for (std::size_t i = 0; i + 1 < directions.size(); ++i)
    if (const auto way = between(p, directions[i], directions[i + 1], far);
        way && !star.solid(star.sector_left_of(*way)))
      ways.push_back(*way);
  return ways;
}

std::vector<std::uint32_t> all_of(const std::vector<Constraint>& pieces) {
  std::vector<std::uint32_t> numbers(pieces.size());
  std::iota(numbers.begin(), numbers.end(), 0U);
  return numbers;
}

bool is_in(const FreeSpace& space, const Box& box, Point p) {
  if (!box.contains(p) || lies_inside(box, p)) return box.contains(p);
  for (const RoomSide& side : room_sides({box})) {
    if (!written::on_segment(p, side.side.a, side.side.b)) continue;
    const std::vector<Constraint> pieces = pieces_near(space, side.side);
    for (const Point way : ways_in(side, p, pieces, all_of(pieces)))
      if (space.opens_towards(p, way)) return true;
  }
  return false;
}

}  // namespace

Point middle(const Box& box) {
  return {box.min.x + (box.max.x - box.min.x) / 2, box.min.y + (box.max.y - box.min.y) / 2};
}

std::optional<GraphSearchResult> answer_at_start(const FreeSpace& space, Point from, const Goal& to) {
  require_free(space, from, "start");
  if (to.point) {
    require_free(space, *to.point, "goal");
    return std::nullopt;
  }
  const auto is_there = [&](const Box& box) { return is_in(space, box, from); };
  if (std::none_of(to.room.begin(), to.room.end(), is_there)) return std::nullopt;
  GraphSearchResult result;
  result.status = SearchStatus::found;
  result.path.points = {from};
  return result;
}

std::optional<Point> RoomSide::foot(Point p) const {
  const Point q = vertical(side) ? Point{side.a.x, p.y} : Point{p.x, side.a.y};
  if (q == p || !(side.a < q && q < side.b)) return std::nullopt;
  return q;
}

std::vector<RoomSide> room_sides(const std::vector<Box>& room) {
  std::map<std::pair<Point, Point>, std::vector<const Box*>> sides;
  for (const Box& b : room) {
    const Point corners[] = {b.min, {b.max.x, b.min.y}, b.max, {b.min.x, b.max.y}};
    for (int i = 0; i < 4; ++i) sides[std::minmax(corners[i], corners[(i + 1) % 4])].push_back(&b);
  }
  std::vector<RoomSide> result;
  for (const auto& [side, boxes] : sides)
    if (boxes.size() == 1) result.push_back({{side.first, side.second}, middle(*boxes[0]), *boxes[0]});
  return result;
}

std::vector<RoomEntry> room_entries(const FreeSpace& space, const std::vector<Box>& room) {
  std::vector<RoomEntry> entries;
  for (const RoomSide& side : room_sides(room)) {
    const std::vector<Constraint> pieces = pieces_near(space, side.side);
    // Pieces meet at ends alone, so what touches a point that is none of the side's own ends is what it was found by.
    std::map<Point, std::vector<std::uint32_t>> found{{side.side.a, all_of(pieces)}, {side.side.b, all_of(pieces)}};
    for (std::uint32_t i = 0; i < pieces.size(); ++i)
      for (const Point p : meeting_points(side.side, pieces[i]))
        if (p != side.side.a && p != side.side.b) found[p].push_back(i);
    for (const auto& [p, touching] : found)
      if (space.holds(p))
        for (const Point way : ways_in(side, p, pieces, touching)) entries.push_back({p, way});
  }
  return entries;
}

}  // namespace taut::detail
