#include <taut/search/detail/face_finder.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <taut/geometry/box.h>
#include <taut/geometry/segment_distance.h>
#include <taut/geometry/written.h>
#include <taut/roadmaps/exact/exact_gates.h>
#include <taut/search/detail/disc_ends.h>
#include <taut/search/detail/gate_crossings.h>

namespace taut::detail {

namespace {

std::vector<std::uint32_t> openings_of(const WallIndex& walls) {
  std::vector<std::uint32_t> result;
  for (std::uint32_t c = 0; c < walls.ends().size(); ++c)
    if (walls.is_opening(c)) result.push_back(c);
  return result;
}

std::vector<Box> boxes_of(const WallIndex& walls, const std::vector<std::uint32_t>& constraints) {
  std::vector<Box> boxes;
  boxes.reserve(constraints.size());
  for (const std::uint32_t c : constraints) boxes.push_back(box_around(walls.segment(c).a, walls.segment(c).b));
  return boxes;
}

/// The end of c that is nearest to p; kNone: its inside is.
std::uint32_t nearest_end(const WallIndex& walls, std::uint32_t c, Point p) {
  const auto [a, b] = walls.segment(c);
  if (dot_sign(a, b, p) <= 0) return walls.ends()[c][0];
  if (dot_sign(b, a, p) <= 0) return walls.ends()[c][1];
  return kNone;
}

/// Scratch memory for one thread.
std::vector<NearWall>& scratch() {
  thread_local std::vector<NearWall> walls;
  return walls;
}

}  // namespace

FaceFinder::FaceFinder(const Gates& gates)
    : gates_(gates),
      faces_(gates),
      tree_(gates.exact().walls),
      openings_(openings_of(gates.exact().walls)),
      opening_boxes_(boxes_of(gates.exact().walls, openings_)) {}

PassagePlace FaceFinder::find(Point p) const {
  PassagePlace place;
  place.point = p;
  std::vector<NearWall>& near = scratch();
  near.clear();
  if (!tree_.empty()) {
    tree_.nearest(p, near);
    find_wall(place, near);
  }
  // The side of the nearest wall says whether p is outside, unless it may be on the wall, or an opening is between.
  if (tree_.empty() || !openings_.empty() || place.distance.lo <= 0) {
    find_by_triangle(place, near);
    return place;
  }
  place.face = face_at(p, near);
  place.component = faces_.component(place.face);
  place.outside = place.component == kNone;
  return place;
}

void FaceFinder::find_wall(PassagePlace& place, const std::vector<NearWall>& near) const {
  const auto least = std::min_element(near.begin(), near.end(),
                                      [](const NearWall& a, const NearWall& b) { return a.squared < b.squared; });
  const double distance = std::sqrt(least->squared), slack = tree_.slack() + 0x1p-48 * distance;
  place.constraint = least->constraint;
  place.distance = {std::max(0.0, distance - slack), distance + slack};
  if (near.size() == 1) return;
  // Mostly the walls that end in one point.
  const WallIndex& walls = gates_.exact().walls;
  const std::uint32_t end = nearest_end(walls, least->constraint, place.point);
  for (const NearWall& wall : near) {
    if (end == kNone || nearest_end(walls, wall.constraint, place.point) != end) place.tied = true;
    place.constraint = std::min(place.constraint, wall.constraint);
  }
}

void FaceFinder::find_by_triangle(PassagePlace& place, const std::vector<NearWall>& near) const {
  const FreeSpace& space = gates_.space();
  const Location at = space.locate(place.point);
  if (at.kind == Location::Kind::outside) return;
  place.outside = false;
  place.component = space.component(at.triangle);
  if (near.empty()) return;
  const std::optional<std::uint32_t> opening = on_constraint(at, place);
  if (place.on_wall) place.distance = 0;
  if (!place.on_wall) place.face = opening ? *opening : face_at(place.point, near);
}

/// On an opening: the face inside it. On a wall: says so.
std::optional<std::uint32_t> FaceFinder::on_constraint(const Location& at, PassagePlace& place) const {
  if (at.kind == Location::Kind::triangle) return std::nullopt;
  const WallIndex& walls = gates_.exact().walls;
  const Triangulation& tri = walls.triangulation();
  const auto& corners = tri.triangles[at.triangle];
  if (at.kind == Location::Kind::vertex) {
    const std::uint32_t v = corners[at.index];
    place.on_wall = walls.is_wall_vertex(v);
    if (place.on_wall) return std::nullopt;
    if (walls.at(v).empty()) return std::nullopt;
    return faces_.at_vertex(v, {tri.points[v], tri.points[corners[Triangulation::ccw(at.index)]], 0});
  }
  const std::uint32_t c = walls.along(at.triangle, at.index);
  place.on_wall = !walls.is_opening(c);
  if (place.on_wall) return std::nullopt;
  const Segment s = walls.segment(c);
  const bool left = written::orientation(s.a, s.b, tri.points[corners[at.index]]) > 0;
  const Direction inwards{s.a, s.b, static_cast<std::uint8_t>(left ? 1 : 3)};
  return faces_.beside_opening(c, left, place_along(s, place.point), inwards);
}

/// The face that all walls agree on which may be the nearest; else that of the one that is.
std::uint32_t FaceFinder::face_at(Point p, const std::vector<NearWall>& near) const {
  const std::uint32_t face = face_towards(p, near.front().constraint);
  const bool agree = std::all_of(near.begin() + 1, near.end(),
                                 [&](const NearWall& wall) { return face_towards(p, wall.constraint) == face; });
  return agree ? face : face_towards(p, lowest_nearest(p, near));
}

std::uint32_t FaceFinder::face_towards(Point p, std::uint32_t wall) const {
  const WallIndex& walls = gates_.exact().walls;
  const Segment s = walls.segment(wall);
  const std::uint32_t end = nearest_end(walls, wall, p);
  const std::uint32_t face = end != kNone ? faces_.at_vertex(end, {walls.triangulation().points[end], p, 0})
                                          : faces_.beside_wall(wall, written::orientation(s.a, s.b, p) > 0, p);
  return openings_.empty() ? face : face_beyond_openings(p, wall, face);
}

/// The way from p to the wall may cross openings: the first counts.
std::uint32_t FaceFinder::face_beyond_openings(Point p, std::uint32_t wall, std::uint32_t here) const {
  const WallIndex& walls = gates_.exact().walls;
  const Segment s = walls.segment(wall);
  const std::uint32_t end = nearest_end(walls, wall, p);
  const Point at_end = end != kNone ? walls.triangulation().points[end] : Point{};
  const GateShape way = end != kNone ? GateShape{p, {at_end, at_end}} : *gate_to_inside(p, s);
  const Point rough = nearest_foot(way);
  Box box = box_around(p, rough);
  const double more = tree_.slack() + 0x1p-40 * (box.max.x - box.min.x + box.max.y - box.min.y);
  box = {{box.min.x - more, box.min.y - more}, {box.max.x + more, box.max.y + more}};
  std::vector<GateCrossing> crossings;
  opening_boxes_.meeting(box, [&](std::uint32_t i) {
    const Segment o = walls.segment(openings_[i]);
    // Most are plainly on one side of the way.
    if (way.exact() && written::orientation(p, rough, o.a) * written::orientation(p, rough, o.b) > 0) return;
    append_crossings(ExactPoint(p), exact_foot(way), walls, openings_[i], crossings);
  });
  const auto first =
      std::min_element(crossings.begin(), crossings.end(),
                       [](const GateCrossing& a, const GateCrossing& b) { return a.from_end < b.from_end; });
  if (first == crossings.end()) return here;
  // Back to p: against the way to the wall.
  const bool left_of_wall = written::orientation(s.a, s.b, p) > 0;
  const Direction back =
      end != kNone ? Direction{at_end, p, 0} : Direction{s.a, s.b, static_cast<std::uint8_t>(left_of_wall ? 1 : 3)};
  if (first->vertex != kNone) return faces_.at_vertex(first->vertex, back);
  const Segment o = walls.segment(first->opening);
  return faces_.beside_opening(first->opening, written::orientation(o.a, o.b, p) > 0, first->along, back);
}

std::uint32_t FaceFinder::lowest_nearest(Point p, const std::vector<NearWall>& near) const {
  const WallIndex& walls = gates_.exact().walls;
  std::uint32_t best = kNone;
  std::optional<Rational> least;  // of the best, when it was needed
  for (const NearWall& wall : near) {
    const std::uint32_t c = wall.constraint;
    if (best == kNone) {
      best = c;
      continue;
    }
    const std::uint32_t end = nearest_end(walls, c, p);
    if (end != kNone && end == nearest_end(walls, best, p)) {
      best = std::min(best, c);
      continue;
    }
    const Interval mine = segment_distance_interval({p, p}, walls.segment(c)),
                   its = segment_distance_interval({p, p}, walls.segment(best));
    std::optional<int> sign = compare(mine, its);
    if (!sign) {
      if (!least) least = squared_distance(p, walls.segment(best));
      sign = cmp(squared_distance(p, walls.segment(c)), *least);
    }
    if (*sign < 0 || (*sign == 0 && c < best)) {
      best = c;
      least.reset();
    }
  }
  return best;
}

std::uint32_t FaceFinder::nearest_wall(const PassagePlace& p) const {
  if (!p.tied) return p.constraint;
  std::vector<NearWall>& near = scratch();
  tree_.nearest(p.point, near);
  return lowest_nearest(p.point, near);
}

}  // namespace taut::detail
