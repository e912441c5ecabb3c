#include <taut/io/worlds/detail/cells_of_world.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <taut/geometry/box.h>
#include <taut/geometry/errors.h>
#include <taut/geometry/text.h>
#include <taut/geometry/written.h>
#include <taut/io/worlds/detail/implied.h>

namespace taut::detail {

namespace {

constexpr double kLongestSide = 20000;

class Loss {
 public:
  explicit Loss(std::string_view format) : format_(format) {}
  [[noreturn]] void fail(const std::string& what) const {
    throw InputError("", 0, std::string(format_) + " cannot hold " + what);
  }
  void unless(bool holds, const char* what) const {
    if (!holds) fail(what);
  }

 private:
  std::string_view format_;
};

bool is_whole(Point p) { return p.x == std::floor(p.x) && p.y == std::floor(p.y); }

/// Width and height of a box of unit cells from (0, 0) on.
Cell size_of(const World& world, const Loss& loss) {
  const auto [low, high] = world.box();
  if (low != Point{0, 0} || !is_whole(high)) loss.fail("limits that are no box of unit cells from (0, 0) on");
  if (high.x > kLongestSide || high.y > kLongestSide) loss.fail("more than 20000 cells in a row");
  return {static_cast<int>(high.x), static_cast<int>(high.y)};
}

void set_wall(GridMaze& maze, const Wall& wall, const Loss& loss) {
  if (wall.thickness > 0) loss.fail("walls with a thickness");
  const bool upright = wall.a.x == wall.b.x;
  if (!is_whole(wall.a) || !is_whole(wall.b) || (!upright && wall.a.y != wall.b.y))
    loss.fail("the wall " + text(Segment{wall.a, wall.b}) + ", which runs along no sides of unit cells");
  const auto [from, to] = std::minmax(wall.a, wall.b);
  for (Cell c{static_cast<int>(from.x), static_cast<int>(from.y)}; upright ? c.y < to.y : c.x < to.x;
       ++(upright ? c.y : c.x)) {
    const bool beyond = upright ? c.x == maze.width() : c.y == maze.height();
    if (upright)
      maze.set_wall(beyond ? Cell{c.x - 1, c.y} : c, beyond ? Side::east : Side::west, true);
    else
      maze.set_wall(beyond ? Cell{c.x, c.y - 1} : c, beyond ? Side::north : Side::south, true);
  }
}

Cell cell_in_the_middle_of(Point p, const Loss& loss) {
  const Cell c{static_cast<int>(std::floor(p.x)), static_cast<int>(std::floor(p.y))};
  if (p != Point{c.x + 0.5, c.y + 0.5}) loss.fail("an end at " + text(p) + ", which is no middle of a cell");
  return c;
}

void set_ends(GridMaze& maze, const World& world, const Loss& loss) {
  if (ends_are_implied(world)) return;
  loss.unless(world.start().has_value(), "a world without a start");
  loss.unless(!world.goal().point, "a goal point, only cells to get into");
  maze.start = cell_in_the_middle_of(*world.start(), loss);
  for (const Box& box : world.goal().room) {
    if (!is_whole(box.min) || !is_whole(box.max)) loss.fail("a goal room that is none of whole cells");
    for (int y = static_cast<int>(box.min.y); y < box.max.y; ++y)
      for (int x = static_cast<int>(box.min.x); x < box.max.x; ++x) maze.goal.push_back({x, y});
  }
}

void require_cells(const Area& area, const Loss& loss) {
  const auto require = [&](const Ring& ring) {
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
      if (!is_whole(ring[i]) || (ring[i].x != ring[j].x && ring[i].y != ring[j].y))
        loss.fail("the side " + text(Segment{ring[j], ring[i]}) + ", which runs along no sides of unit cells");
  };
  require(area.polygon.outer);
  std::ranges::for_each(area.polygon.holes, require);
}

bool holds(const Area& area, Point p) {
  const auto is_in = [p](const Ring& ring) { return written::side_of_ring(p, ring) > 0; };
  return is_in(area.polygon.outer) && std::ranges::none_of(area.polygon.holes, is_in);
}

/// Marks the cells of the area: those whose middles it holds, within its own box.
void mark(OccupancyGrid& grid, const Area& area, std::uint8_t value) {
  const Box box = box_around(area.polygon.outer);
  const auto first = [](double v) { return static_cast<std::uint32_t>(std::max(0.0, v)); };
  for (std::uint32_t row = first(box.min.y); row < std::min<double>(grid.height, box.max.y); ++row)
    for (std::uint32_t column = first(box.min.x); column < std::min<double>(grid.width, box.max.x); ++column)
      if (holds(area, {column + 0.5, row + 0.5})) grid.blocked[std::size_t{row} * grid.width + column] = value;
}

}  // namespace

GridMaze maze_of(const World& world, std::string_view format) {
  const Loss loss(format);
  loss.unless(world.solids().empty(), "solid polygons");
  loss.unless(world.boundary() == Boundary::limit, "a world without limits, or one of floor plans");
  const Polygon& area = world.areas().front().polygon;
  const Cell size = size_of(world, loss);
  loss.unless(world.areas().size() == 1 && area.holes.empty() && area.outer.size() == 4, "limits that are no box");
  GridMaze maze(size.x, size.y, false);
  for (int x = 0; x < size.x; ++x) {
    maze.set_wall({x, 0}, Side::south, false);
    maze.set_wall({x, size.y - 1}, Side::north, false);
  }
  for (int y = 0; y < size.y; ++y) {
    maze.set_wall({0, y}, Side::west, false);
    maze.set_wall({size.x - 1, y}, Side::east, false);
  }
  for (const Wall& wall : world.walls()) set_wall(maze, wall, loss);
  set_ends(maze, world, loss);
  return maze;
}

OccupancyGrid cells_of(const World& world, std::string_view format) {
  const Loss loss(format);
  loss.unless(world.walls().empty(), "walls, only cells");
  loss.unless(world.boundary() == Boundary::walled, "limits that are open: its border is a wall");
  const Cell size = size_of(world, loss);
  OccupancyGrid grid{static_cast<std::uint32_t>(size.x), static_cast<std::uint32_t>(size.y), {}};
  grid.blocked.assign(std::size_t{grid.width} * grid.height, 1);
  for (const auto& [areas, value] : {std::pair{&world.areas(), 0}, std::pair{&world.solids(), 1}})
    for (const Area& area : *areas) {
      require_cells(area, loss);
      mark(grid, area, static_cast<std::uint8_t>(value));
    }
  return grid;
}

}  // namespace taut::detail
