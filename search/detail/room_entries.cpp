#include <taut/search/detail/room_entries.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include <taut/geometry/cell_plan.h>
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
  const auto is_there = [&](const Box& b) {
    return b.contains(from) && (lies_inside(b, from) || space.opens_towards(from, middle(b)));
  };
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
  std::map<std::pair<Point, Point>, std::vector<Point>> sides;
  for (const Box& b : room) {
    const Point corners[] = {b.min, {b.max.x, b.min.y}, b.max, {b.min.x, b.max.y}};
    for (int i = 0; i < 4; ++i) sides[std::minmax(corners[i], corners[(i + 1) % 4])].push_back(middle(b));
  }
  std::vector<RoomSide> result;
  for (const auto& [side, insides] : sides)
    if (insides.size() == 1) result.push_back({{side.first, side.second}, insides[0]});
  return result;
}

std::vector<RoomEntry> room_entries(const FreeSpace& space, const std::vector<Box>& room) {
  std::vector<RoomEntry> entries;
  for (const RoomSide& side : room_sides(room)) {
    std::vector<Point> points{side.side.a, side.side.b};
    for (const Constraint& c : pieces_near(space, side.side)) {
      const std::vector<Point> met = meeting_points(side.side, c);
      points.insert(points.end(), met.begin(), met.end());
    }
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    for (const Point p : points)
      if (space.holds(p)) entries.push_back({p, side.inside});
  }
  return entries;
}

}  // namespace taut::detail
