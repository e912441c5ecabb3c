#include <taut/io/worlds/detail/shapes.h>

#include <algorithm>
#include <utility>

#include <taut/geometry/text.h>
#include <taut/io/worlds/detail/doors.h>

namespace taut::detail {

Ring Shapes::ring(Ring written, int line) {
  if (written.size() < 2) return written;
  if (written.front() == written.back()) {
    written.pop_back();
    return written;
  }
  if (written.size() < 3) return written;
  const std::string what = "ring is not closed: first " + text(written.front()) + ", last " + text(written.back());
  if (!closes_) at(line).fail(what + " (--repair closes it)");
  unclosed_.push_back("line " + std::to_string(line) + ": " + what + ": closed");
  return written;
}

void Shapes::add_polygon(Polygon polygon, int line) {
  switch (as_) {
    case ReadOptions::Polygons::free: return add_free(std::move(polygon), line);
    case ReadOptions::Polygons::obstacles: return add_solid(std::move(polygon), line);
    case ReadOptions::Polygons::nested: nested_.push_back({std::move(polygon), line});
  }
}

void Shapes::add_free(Polygon polygon, int line) { parts_.areas.push_back({std::move(polygon), line}); }

void Shapes::add_solid(Polygon polygon, int line) { parts_.solids.push_back({std::move(polygon), line}); }

void Shapes::add_walls(const Ring& chain, double thickness, int line) {
  if (chain.size() < 2) at(line).fail("a line needs at least two points");
  const double thick = thickness_.value_or(thickness);
  for (std::size_t i = 1; i < chain.size(); ++i) parts_.walls.push_back({chain[i - 1], chain[i], thick, line});
}

void Shapes::add_point(Point p) { points_.push_back(p); }

void Shapes::add_door(const Ring& chain) {
  for (std::size_t i = 1; i < chain.size(); ++i) doors_.push_back({chain[i - 1], chain[i]});
}

void Shapes::set_start(Point p, int line) {
  if (parts_.start) at(line).fail("a second start, " + text(p) + "; the first is " + text(*parts_.start));
  parts_.start = p;
}

void Shapes::set_goal(Point p, int line) {
  if (parts_.goal.point || !parts_.goal.room.empty()) at(line).fail("a second goal, " + text(p));
  parts_.goal.point = p;
}

void Shapes::add_goal_box(const Polygon& polygon, int line) {
  const Ring& r = polygon.outer;
  const bool upright = r.size() == 4 && (r[0].x == r[1].x ? r[1].y == r[2].y && r[2].x == r[3].x && r[3].y == r[0].y
                                                          : r[0].y == r[1].y && r[1].x == r[2].x && r[2].y == r[3].y &&
                                                                r[3].x == r[0].x);
  if (!polygon.holes.empty() || !upright) at(line).fail("a goal polygon must be an axis-parallel rectangle");
  if (parts_.goal.point) at(line).fail("a second goal");
  const auto [x0, x1] = std::minmax({r[0].x, r[2].x});
  const auto [y0, y1] = std::minmax({r[0].y, r[2].y});
  parts_.goal.room.push_back({{x0, y0}, {x1, y1}});
}

/// What is joined.
Beside Shapes::beside_walls() const {
  if (doors_.empty() || snap_.what == Snap::What::nothing) return {};
  WorldParts all = parts_;
  for (const Segment& door : doors_) all.walls.push_back({door.a, door.b, 0, 0});
  Beside beside{0, rounding_tolerance(all)};
  if (snap_.what == Snap::What::within) beside.tolerance = snap_.tolerance;
  if (snap_.what == Snap::What::automatic) beside.tolerance = auto_tolerance(all);
  return beside;
}

WorldParts Shapes::take(Alone ends, ReadNotes& notes) {
  parts_.boundary = boundary_;
  for (Area& area : even_odd_areas(nested_, source_)) parts_.areas.push_back(std::move(area));
  if (!unclosed_.empty()) notes.remarks.push_back(unclosed_.front() + more_like_it(unclosed_.size() - 1));
  const bool has_ends = parts_.start || parts_.goal.point || !parts_.goal.room.empty();
  if (!has_ends && (points_.size() == 2 || (points_.size() == 1 && ends == Alone::one_or_two))) {
    parts_.start = points_[0];
    if (points_.size() == 2) parts_.goal.point = points_[1];
  } else if (!points_.empty()) {
    notes.remarks.push_back(std::to_string(points_.size()) + (points_.size() == 1 ? " point" : " points") +
                            " without a role left out; start and goal are points with these roles, or two alone");
  }
  const Beside beside = beside_walls();
  for (const Segment& door : doors_)
    if (!open_door(parts_.walls, door, beside))
      notes.remarks.push_back("the door " + text(door.a) + "-" + text(door.b) + " lies on no wall and is left out");
  return std::move(parts_);
}

}  // namespace taut::detail
