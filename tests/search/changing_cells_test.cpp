// Axis-parallel walls that come and go, many times: each query as on a world built anew.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <taut/geometry/draws.h>
#include <taut/geometry/grid_maze.h>
#include <taut/geometry/maze_generator.h>
#include <taut/search/changing_world.h>
#include <taut/search/polyanya.h>
#include <taut/search/verify.h>

#include "support/small_world.h"

namespace taut {
namespace {

using namespace test;

/// The number of changes that the variable TAUT_CHANGES asks for, or few.
int wanted_changes() {
  const char* const asked = std::getenv("TAUT_CHANGES");
  return asked ? std::atoi(asked) : 400;
}

/// Walls whose ends are quarters, mostly whole numbers, in a square; each stands once.
class Walls {
 public:
  Walls(std::uint32_t side, std::uint32_t most, std::uint64_t seed) : side_(side), most_(most), draws_(seed) {}

  void change(ChangingWorld& world) {
    if (walls_.size() < 2 || draws_.below(2 * most_) >= walls_.size())
      add(world);
    else
      take(world);
  }

  Point any_point() {
    const double x = coordinate(), y = coordinate();
    return {x, y};
  }

  /// The first `count` ones of a maze.
  void begin_with(std::vector<Wall> walls) { walls_ = std::move(walls); }
  const std::vector<Wall>& now() const { return walls_; }

 private:
  double coordinate() {
    const double whole = draws_.below(side_ + 1);
    return draws_.below(8) > 0 || whole == side_ ? whole : whole + 0.25 * draws_.below(4);
  }

  void add(ChangingWorld& world) {
    const double line = coordinate(), from = coordinate(), to = coordinate();
    if (from == to) return;
    const Wall wall = draws_.below(2) == 0 ? Wall{{line, from}, {line, to}} : Wall{{from, line}, {to, line}};
    world.add(wall);
    walls_.push_back(wall);
  }

  /// All of a wall, or its first half: what lies on others as well goes from those, too.
  void take(ChangingWorld& world) {
    const Wall of = walls_[draws_.below(static_cast<std::uint32_t>(walls_.size()))];
    const Point middle{(of.a.x + of.b.x) / 2, (of.a.y + of.b.y) / 2};
    const Segment stretch{of.a, draws_.below(3) == 0 ? middle : of.b};
    EXPECT_TRUE(world.remove(stretch));
    std::vector<Wall> left;
    for (const Wall& wall : walls_) {
      const Segment whole = sorted({wall.a, wall.b}), gone = sorted(stretch);
      const bool is_upright = whole.a.x == whole.b.x;
      const bool lies_on = is_upright == (gone.a.x == gone.b.x) &&
                           (is_upright ? whole.a.x == gone.a.x && whole.a.y <= gone.a.y && gone.b.y <= whole.b.y
                                       : whole.a.y == gone.a.y && whole.a.x <= gone.a.x && gone.b.x <= whole.b.x);
      if (!lies_on) {
        left.push_back(wall);
        continue;
      }
      if (whole.a != gone.a) left.push_back({whole.a, gone.a});
      if (gone.b != whole.b) left.push_back({gone.b, whole.b});
    }
    walls_ = std::move(left);
  }

  static Segment sorted(Segment s) {
    if (s.b.x < s.a.x || s.b.y < s.a.y) std::swap(s.a, s.b);
    return s;
  }

  std::uint32_t side_, most_;
  Draws draws_;
  std::vector<Wall> walls_;
};

/// What is wrong with the answer, or nothing.
std::string fault(ChangingWorld& world, const FreeSpace& anew, Point from, Point to) {
  const GraphSearchResult expected = shortest_path(Polyanya(anew), from, {to, {}});
  if (world.find(from, to) != expected.status) return "one finds a path, the other none";
  if (expected.status != SearchStatus::found) return "";
  const Path found{world.points(), Length(world.points())};
  if (found.length != expected.path.length)
    return fmt::format("{} instead of {}", found.length.value(), expected.path.length.value());
  return verify(found, anew, from, {to, {}}).valid ? "" : "through a wall";
}

void agree(WorldParts parts, Walls& walls, int changes, int a_query) {
  ChangingWorld world{FreeSpace(World(parts))};
  for (int n = 1; n <= changes; ++n) {
    walls.change(world);
    if (n % a_query != 0) continue;
    parts.walls = walls.now();
    const FreeSpace anew{World(parts)};
    const Point from = walls.any_point(), to = walls.any_point();
    if (!anew.holds(from) || !anew.holds(to)) continue;
    ASSERT_EQ(fault(world, anew, from, to), "")
        << "after " << n << " changes, from " << from.x << ' ' << from.y << " to " << to.x << ' ' << to.y;
  }
  EXPECT_TRUE(world.is_among_cells());
  EXPECT_EQ(world.rebuilds(), 0u);
}

TEST(ChangingCells, AnswerAsAWorldBuiltAnewAfterEachChange) {
  WorldParts parts = SmallWorld{.solids = {box_ring(2, 2, 4, 3), box_ring(4, 3, 5, 7), box_ring(8, 1, 9, 2)}}.parts();
  Walls walls(10, 24, 1);
  agree(parts, walls, wanted_changes(), 1);
}

TEST(ChangingCells, AnswerAsAMazeBuiltAnewAfterManyChanges) {
  GridMaze maze = generate_backtracker(70, 70, 3);
  open_walls(maze, 0.2, 4);
  WorldParts parts = world_of(std::make_shared<GridMaze>(maze)).parts();
  parts.grid = nullptr;
  Walls walls(70, static_cast<std::uint32_t>(parts.walls.size()), 5);
  walls.begin_with(parts.walls);
  agree(parts, walls, wanted_changes(), std::max(40, wanted_changes() / 500));
}

}  // namespace
}  // namespace taut
