#include <taut/geometry/detail/implied_area.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include <taut/geometry/box.h>
#include <taut/geometry/detail/outline.h>
#include <taut/geometry/snap.h>
#include <taut/geometry/text.h>
#include <taut/geometry/written.h>

namespace taut::detail {

namespace {

constexpr double kHullCovered = 0.75;
constexpr double kRounding = 1e-9;  // of a covered share

Bounds bounds_of_everything(const WorldParts& parts) {
  Bounds bounds;
  for (const Wall& wall : parts.walls) {
    bounds.add(wall.a, wall.thickness);
    bounds.add(wall.b, wall.thickness);
  }
  for (const Area& solid : parts.solids)
    for (Point p : solid.polygon.outer) bounds.add(p);
  if (parts.start) bounds.add(*parts.start);
  if (parts.goal.point) bounds.add(*parts.goal.point);
  for (const Box& box : parts.goal.room) {
    bounds.add(box.min);
    bounds.add(box.max);
  }
  return bounds;
}

// One coordinate of the widened box: away from `value` by at least `margin`, a multiple of `step` where doubles allow
// it.
double widened(double value, double margin, double step, int direction) {
  const double steps = std::floor((direction * value + margin) / step) + 1;
  const double aim = std::abs(steps) < 1e15 ? written::times(static_cast<std::int64_t>(steps), step) : steps * step;
  const double result = direction * aim;
  const double least = std::nextafter(value, direction * std::numeric_limits<double>::infinity());
  return direction * result < direction * least ? least : result;
}

// Wide enough to go around everything; a shortest path stays within the convex hull of what it goes around.
Box roomy_box(const WorldParts& parts) {
  const Box b = bounds_of_everything(parts).box();
  const double extent = std::max(b.max.x - b.min.x, b.max.y - b.min.y);
  const double margin = extent > 0 ? extent / 4 : 0.5;
  // Of small worlds a decimal, so that the box lies on the lattice of what it is around.
  const double step = margin >= 0.01 ? std::exp2(std::floor(std::log2(margin)))
                                     : written::number(1, -static_cast<int>(std::floor(std::log10(margin))));
  const Box wide{{widened(b.min.x, margin, step, -1), widened(b.min.y, margin, step, -1)},
                 {widened(b.max.x, margin, step, 1), widened(b.max.y, margin, step, 1)}};
  for (double v : {wide.min.x, wide.min.y, wide.max.x, wide.max.y})
    if (std::abs(v) > World::kLargest)
      throw InputError(parts.source, 0,
                       "no boundary is given, and one around everything would reach beyond " + text(World::kLargest));
  return wide;
}

bool ends_beyond(const WorldParts& parts, const Ring& ring) {
  const auto beyond = [&](Point p) { return written::side_of_ring(p, ring) < 0; };
  const std::vector<Box>& room = parts.goal.room;
  return (parts.start && beyond(*parts.start)) || (parts.goal.point && beyond(*parts.goal.point)) ||
         std::any_of(room.begin(), room.end(), [&](const Box& b) {
           const Ring box = ring_of(b);
           return std::any_of(box.begin(), box.end(), beyond);
         });
}

double length(const Segment& s) { return std::hypot(s.b.x - s.a.x, s.b.y - s.a.y); }

// The share of the ring on which walls stand.
double covered(const Ring& ring, const std::vector<Wall>& walls) {
  const std::vector<Segment> sides = outline({{{ring, {}}, 0}});
  double whole = 0, open = 0;
  for (const Segment& s : sides) whole += length(s);
  for (const Segment& s : open_pieces(sides, walls, false)) open += length(s);
  return 1 - open / whole;
}

bool is_axis_parallel(const Wall& wall) { return wall.a.x == wall.b.x || wall.a.y == wall.b.y; }

// Wall ends and the ends of paths.
std::vector<Point> places_of(const WorldParts& parts) {
  std::vector<Point> places;
  for (const Wall& wall : parts.walls) places.insert(places.end(), {wall.a, wall.b});
  if (parts.start) places.push_back(*parts.start);
  if (parts.goal.point) places.push_back(*parts.goal.point);
  return places;
}

std::optional<Ring> turned_face(const WorldParts& parts, const std::vector<Point>& places) {
  const TurnedFaces faces = turned_faces(parts.walls, places, std::max(parts.uncertainty, rounding_tolerance(parts)));
  const Ring* best = nullptr;
  double most = 0.5 - kRounding;
  for (const Ring& ring : faces.rectangles) {
    const double share = covered(ring, parts.walls);
    if (share < most || (best && share <= most) || ends_beyond(parts, ring)) continue;
    most = share;
    best = &ring;
  }
  if (best) return *best;
  const Ring& hull = faces.hull;
  if (hull.size() < 3 || covered(hull, parts.walls) < kHullCovered - kRounding || ends_beyond(parts, hull))
    return std::nullopt;
  return hull;
}

// The outer face of the walls, when they cover enough of it and no end lies beyond.
std::optional<Ring> outer_face(const WorldParts& parts) {
  Bounds bounds;
  for (const Wall& wall : parts.walls) {
    bounds.add(wall.a);
    bounds.add(wall.b);
  }
  const Box& b = bounds.box();
  if (bounds.empty() || !(b.min.x < b.max.x && b.min.y < b.max.y)) return std::nullopt;
  Ring box = ring_of(b);
  const std::vector<Point> places = parts.uncertainty > 0 ? places_of(parts) : std::vector<Point>();
  if (parts.uncertainty > 0) box = passed_through(box, places, parts.uncertainty);
  const double half = parts.uncertainty > 0 ? 0.5 - kRounding : 0.5;
  if (covered(box, parts.walls) >= half && !ends_beyond(parts, box)) return box;
  if (std::all_of(parts.walls.begin(), parts.walls.end(), is_axis_parallel)) return std::nullopt;
  return turned_face(parts, places.empty() ? places_of(parts) : places);
}

}  // namespace

void imply_area(WorldParts& parts) {
  std::optional<Ring> face = outer_face(parts);
  parts.boundary = face ? Boundary::limit : Boundary::open;
  parts.areas = {{{face ? std::move(*face) : ring_of(roomy_box(parts)), {}}, 0}};
}

void widen_area(WorldParts& parts) {
  if (!bounds_of_everything(parts).empty()) parts.areas.front().polygon.outer = ring_of(roomy_box(parts));
}

bool ends_beyond(const WorldParts& parts) { return ends_beyond(parts, parts.areas.front().polygon.outer); }

}  // namespace taut::detail
