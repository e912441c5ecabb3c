#include <taut/geometry/world.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <taut/geometry/detail/coordinate_gate.h>
#include <taut/geometry/detail/outline.h>
#include <taut/geometry/detail/room_cut.h>
#include <taut/geometry/mend_rings.h>
#include <taut/geometry/text.h>
#include <taut/geometry/written.h>

namespace taut {

namespace {

using Gate = detail::CoordinateGate;

// An axis-parallel box that grows.
class Bounds {
 public:
  void add(Point p) {
    box_.min = {std::min(box_.min.x, p.x), std::min(box_.min.y, p.y)};
    box_.max = {std::max(box_.max.x, p.x), std::max(box_.max.y, p.y)};
  }
  void add(Point p, double margin) {
    add({p.x - margin, p.y - margin});
    add({p.x + margin, p.y + margin});
  }
  bool empty() const { return box_.min.x > box_.max.x; }
  const Box& box() const { return box_; }

 private:
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Box box_{{kInfinity, kInfinity}, {-kInfinity, -kInfinity}};
};

Ring ring_of(const Box& b) { return {b.min, {b.max.x, b.min.y}, b.max, {b.min.x, b.max.y}}; }

Box box_of(const std::vector<Area>& areas) {
  Bounds bounds;
  for (const Area& area : areas)
    for (Point p : area.polygon.outer) bounds.add(p);
  return bounds.box();
}

void admit_walls(const WorldParts& parts) {
  for (const Wall& wall : parts.walls) {
    const Gate gate(parts.source, wall.line);
    gate.admit(wall.a);
    gate.admit(wall.b);
    gate.admit_thickness(wall.thickness);
  }
}

void admit_ends(const WorldParts& parts) {
  const Gate gate(parts.source, 0);
  if (parts.start) gate.admit(*parts.start);
  if (parts.goal.point) gate.admit(*parts.goal.point);
  for (const Box& box : parts.goal.room) {
    gate.admit(box.min);
    gate.admit(box.max);
    if (box.min.x > box.max.x || box.min.y > box.max.y)
      throw InputError(parts.source, 0, "goal box " + text(box.min) + " to " + text(box.max) + " is upside down");
  }
}

std::size_t drop_points(std::vector<Wall>& walls) {
  const auto is_point = [](const Wall& w) { return w.a == w.b && w.thickness == 0; };
  return std::erase_if(walls, is_point);
}

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

// Does an end lie beyond the box, or a part of a room?
bool ends_beyond(const WorldParts& parts, const Box& box) {
  const auto beyond = [&](const std::optional<Point>& p) { return p && !box.contains(*p); };
  const std::vector<Box>& room = parts.goal.room;
  return beyond(parts.start) || beyond(parts.goal.point) ||
         !std::all_of(room.begin(), room.end(), [&](const Box& b) { return detail::is_within(b, box); });
}

// The bounding box of the walls, when walls cover at least half its outline and no end lies beyond.
std::optional<Box> walled_box(const WorldParts& parts) {
  Bounds bounds;
  for (const Wall& wall : parts.walls) {
    bounds.add(wall.a);
    bounds.add(wall.b);
  }
  const Box& b = bounds.box();
  if (bounds.empty() || !(b.min.x < b.max.x && b.min.y < b.max.y)) return std::nullopt;
  if (ends_beyond(parts, b)) return std::nullopt;
  double open = 0;
  const std::vector<Area> areas{{{ring_of(b), {}}, 0}};
  for (const Segment& s : detail::open_pieces(detail::outline(areas), parts.walls, false))
    open += std::abs(s.b.x - s.a.x) + std::abs(s.b.y - s.a.y);
  if (open > b.max.x - b.min.x + (b.max.y - b.min.y)) return std::nullopt;
  return b;
}

void imply_area(WorldParts& parts) {
  const std::optional<Box> walled = walled_box(parts);
  parts.boundary = walled ? Boundary::limit : Boundary::open;
  parts.areas = {{{ring_of(walled ? *walled : roomy_box(parts)), {}}, 0}};
}

void end_at_openings(WorldParts& parts, const std::vector<Segment>& openings) {
  if (parts.start || parts.goal.point || !parts.goal.room.empty() || openings.size() != 2) return;
  const auto [first, second] = std::minmax({written::middle(openings[0]), written::middle(openings[1])});
  parts.start = first;
  parts.goal.point = second;
}

}  // namespace

World::World(WorldParts parts) : parts_(std::move(parts)) {
  admit_walls(parts_);
  mend_rings(parts_);
  admit_ends(parts_);
  dropped_walls_ = drop_points(parts_.walls);
  if (parts_.walls.empty() && parts_.areas.empty() && parts_.solids.empty())
    throw InputError(
        parts_.source, 0,
        dropped_walls_ > 0 ? "all walls have length zero, and there are no areas" : "no walls and no areas");
  implied_area_ = parts_.areas.empty();
  if (implied_area_) imply_area(parts_);
  box_ = box_of(parts_.areas);
  detail::cut_room(parts_.goal.room, box_, parts_.source);  // no end can widen the box again: see ends_beyond
  if (parts_.boundary != Boundary::limit) return;
  openings_ = detail::open_pieces(detail::outline(parts_.areas), parts_.walls, parts_.areas.size() > 1);
  end_at_openings(parts_, openings_);
}

World World::with_ends(std::optional<Point> start, std::optional<Point> goal) const {
  World copy = *this;
  if (start) copy.parts_.start = start;
  if (goal) copy.parts_.goal = {goal, {}};
  admit_ends(copy.parts_);
  copy.fit_area();
  return copy;
}

World World::with_wall_thickness(double thickness) const {
  Gate(parts_.source, 0).admit_thickness(thickness);
  World copy = *this;
  for (Wall& wall : copy.parts_.walls) wall.thickness = thickness;
  copy.dropped_walls_ += drop_points(copy.parts_.walls);
  copy.fit_area();
  return copy;
}

void World::fit_area() {
  if (!implied_area_ || (parts_.boundary == Boundary::limit && !ends_beyond(parts_, box_))) return;
  if (parts_.boundary == Boundary::limit)
    imply_area(parts_);
  else if (!bounds_of_everything(parts_).empty())
    parts_.areas.front().polygon.outer = ring_of(roomy_box(parts_));
  if (parts_.boundary == Boundary::open) openings_.clear();
  box_ = box_of(parts_.areas);
}

World world_of(std::shared_ptr<const GridMaze> grid, double cell_size, std::string source) {
  const int width = grid->width(), height = grid->height();
  const auto corner = [&](int x, int y) { return Point{written::times(x, cell_size), written::times(y, cell_size)}; };
  WorldParts parts;
  parts.source = std::move(source);
  parts.areas = {{{ring_of({corner(0, 0), corner(width, height)}), {}}, 0}};
  const auto stands = [&](int x, int y, Side far, Side near, bool last) {
    return last ? grid->wall({x, y}, far) : grid->wall({x, y}, near);
  };
  for (int y = 0; y <= height; ++y)
    for (int x = 0; x < width; ++x) {
      const int from = x;
      while (x < width && stands(x, std::min(y, height - 1), Side::north, Side::south, y == height)) ++x;
      if (x > from) parts.walls.push_back({corner(from, y), corner(x, y), 0, 0});
    }
  for (int x = 0; x <= width; ++x)
    for (int y = 0; y < height; ++y) {
      const int from = y;
      while (y < height && stands(std::min(x, width - 1), y, Side::east, Side::west, x == width)) ++y;
      if (y > from) parts.walls.push_back({corner(x, from), corner(x, y), 0, 0});
    }
  for (Cell c : grid->goal) parts.goal.room.push_back({corner(c.x, c.y), corner(c.x + 1, c.y + 1)});
  const Cell s = grid->start;
  const double half = written::middle(0, cell_size);
  const Point start{written::times(2 * s.x + 1, half), written::times(2 * s.y + 1, half)};
  if (!grid->goal.empty()) parts.start = start;
  parts.grid = std::move(grid);
  World world(std::move(parts));
  if (!world.start()) return world.with_ends(start, std::nullopt);
  return world;
}

}  // namespace taut
