#include <taut/geometry/world.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <taut/geometry/box.h>
#include <taut/geometry/detail/coordinate_gate.h>
#include <taut/geometry/detail/implied_area.h>
#include <taut/geometry/detail/outline.h>
#include <taut/geometry/detail/raster.h>
#include <taut/geometry/detail/room_cut.h>
#include <taut/geometry/mend_rings.h>
#include <taut/geometry/text.h>
#include <taut/geometry/written.h>

namespace taut {

namespace {

using Gate = detail::CoordinateGate;

Box box_of(const std::vector<Area>& areas) {
  detail::Bounds bounds;
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

// Bends the sides of `areas` on which the opening lies to p, where p is not on them exactly.
void bend(std::vector<Area>& areas, const Segment& opening, Point p) {
  if (written::on_segment(p, opening.a, opening.b)) return;
  for (Area& area : areas) {
    std::vector<Ring*> rings{&area.polygon.outer};
    for (Ring& hole : area.polygon.holes) rings.push_back(&hole);
    for (Ring* ring : rings)
      for (std::size_t i = 0; i < ring->size(); ++i) {
        const Point a = (*ring)[i], b = (*ring)[(i + 1) % ring->size()];
        const bool holds = written::on_segment(opening.a, a, b) && written::on_segment(opening.b, a, b);
        if (holds) ring->insert(ring->begin() + static_cast<std::ptrdiff_t>(++i), p);
      }
  }
}

// Says whether an outline had to bend.
bool end_at_openings(WorldParts& parts, const std::vector<Segment>& openings) {
  if (parts.start || parts.goal.point || !parts.goal.room.empty() || openings.size() != 2) return false;
  const Point ends[] = {written::middle(openings[0]), written::middle(openings[1])};
  const auto [first, second] = std::minmax(ends[0], ends[1]);
  parts.start = first;
  parts.goal.point = second;
  for (const int i : {0, 1}) bend(parts.areas, openings[static_cast<std::size_t>(i)], ends[i]);
  return !written::on_segment(ends[0], openings[0].a, openings[0].b) ||
         !written::on_segment(ends[1], openings[1].a, openings[1].b);
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
  if (implied_area_) detail::imply_area(parts_);
  box_ = box_of(parts_.areas);
  detail::cut_room(parts_.goal.room, box_, parts_.source);  // no end can widen the box again: see ends_beyond
  if (parts_.boundary != Boundary::limit) return;
  find_openings();
  if (end_at_openings(parts_, openings_)) find_openings();
}

void World::find_openings() {
  openings_ = detail::open_pieces(detail::outline(parts_.areas), parts_.walls, parts_.areas.size() > 1);
}

const std::vector<Area>& World::solids() const { return raster_ ? raster_->solids() : parts_.solids; }
const OccupancyGrid* World::raster() const { return raster_ ? &raster_->grid() : nullptr; }

WorldParts World::parts() const {
  WorldParts parts = parts_;
  if (raster_) parts.solids = raster_->solids();
  if (implied_area_) parts.areas.clear();
  return parts;
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
  if (!implied_area_ || (parts_.boundary == Boundary::limit && !detail::ends_beyond(parts_))) return;
  if (parts_.boundary == Boundary::limit)
    detail::imply_area(parts_);
  else
    detail::widen_area(parts_);
  box_ = box_of(parts_.areas);
  if (parts_.boundary == Boundary::open)
    openings_.clear();
  else
    find_openings();
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
