#include <taut/search/voronoi_search.h>

#include <algorithm>
#include <optional>
#include <utility>

#include <taut/search/clearance_search.h>

namespace taut {

namespace {

bool holds(const Box& b, Point p) { return b.min.x <= p.x && p.x <= b.max.x && b.min.y <= p.y && p.y <= b.max.y; }

struct Entry {
  double parameter;
  Point at;
};

/// Where the leg first meets the closed box, on its side exactly.
std::optional<Entry> entry(Point p, Point q, const Box& box) {
  if (holds(box, p)) return Entry{0, p};
  std::optional<Entry> first;
  const auto through = [&](double from, double to, double side, bool is_x) {
    if ((from < side) == (to < side) && from != side && to != side) return;
    if (from == to) return;
    const double t = (side - from) / (to - from);
    if (!(t >= 0 && t <= 1) || (first && first->parameter <= t)) return;
    Point at{p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)};
    (is_x ? at.x : at.y) = side;
    if (t == 1) at = q;
    if (holds(box, at)) first = Entry{t, at};
  };
  for (const double side : {box.min.x, box.max.x}) through(p.x, q.x, side, true);
  for (const double side : {box.min.y, box.max.y}) through(p.y, q.y, side, false);
  return first;
}

/// Up to where the path first enters the room. A start on a wall with the room behind it is not in it yet.
std::vector<Point> until_room(const FreeSpace& space, const std::vector<Point>& points, const std::vector<Box>& room) {
  std::vector<Point> kept{points.front()};
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point q = points[std::min(i + 1, points.size() - 1)];
    std::optional<Entry> first;
    for (const Box& box : room)
      if (const auto here = entry(points[i], q, box);
          here && (!first || here->parameter < first->parameter) && space.clearance(here->at).distance > 0)
        first = here;
    if (first && first->at != kept.back()) kept.push_back(first->at);
    if (first || i + 1 == points.size()) return kept;
    kept.push_back(q);
  }
  return kept;
}

}  // namespace

std::vector<Point> goal_points(const FreeSpace& space, const Goal& goal) {
  if (goal.point) return {*goal.point};
  std::vector<Point> points;
  for (const Box& b : goal.room) {
    const Point middle{b.min.x + (b.max.x - b.min.x) / 2, b.min.y + (b.max.y - b.min.y) / 2};
    if (space.locate(middle).kind != Location::Kind::outside) points.push_back(middle);
  }
  return points;
}

GraphSearchResult voronoi_search(const VoronoiRoadmap& map, Point from, const Goal& to, double tolerance,
                                 double clearance) {
  GraphSearchResult best;
  for (const Point goal : goal_points(map.space(), to)) {
    const auto way = ClearanceSearch(map, from, goal).shortest(clearance);
    if (!way) continue;
    best.expanded += way->expanded;
    std::vector<Point> points = way->curves.empty() ? std::vector<Point>{from} : sampled(way->curves, tolerance);
    if (!to.point) points = until_room(map.space(), points, to.room);
    Length length(points);
    if (best.status == SearchStatus::found && !(length < best.path.length)) continue;
    best.status = SearchStatus::found;
    best.path = {std::move(points), std::move(length)};
  }
  return best;
}

}  // namespace taut
