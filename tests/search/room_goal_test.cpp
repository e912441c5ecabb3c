// Rooms as goals, with walls that stand in them: a shortest path ends where it first enters, on whatever side of a wall that is.
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include <taut/roadmaps/visibility_graph.h>
#include <taut/search/detail/room_entries.h>
#include <taut/search/polyanya.h>
#include <taut/search/shortest_path.h>
#include <taut/search/verify.h>

#include "support/small_world.h"

namespace taut {
namespace {

using test::SmallWorld;

Goal room(Box box) { return {std::nullopt, {box}}; }

std::optional<Path> by_graph(const FreeSpace& space, Point from, const Goal& to) {
  const GraphSearchResult found = shortest_path(VisibilityGraph(space), from, to);
  return found.status == SearchStatus::found ? std::optional(found.path) : std::nullopt;
}

TEST(RoomGoal, IsEnteredOnTheFarSideOfAWallThatPointsIntoIt) {
  const FreeSpace space = SmallWorld{.walls = {{{0, 5}, {5, 4}}}}.space();
  const Goal goal = room({{4, 3}, {6, 6}});
  // The wall meets the room's side at (4, 4.2), with the middle of the room above it and the path below.
  const auto path = shortest_path(space, {0.5, 4.85}, goal);
  ASSERT_TRUE(path);
  EXPECT_EQ(path->points.back(), (Point{4, 4.2}));
  EXPECT_DOUBLE_EQ(path->length.value(), std::hypot(3.5, 4.85 - 4.2));
  EXPECT_TRUE(verify(*path, space, {0.5, 4.85}, goal).valid);
  EXPECT_EQ(by_graph(space, {0.5, 4.85}, goal)->length, path->length);
}

TEST(RoomGoal, IsWhereAStartOnItsRimIsThatAnObstacleHidesTheMiddleFrom) {
  const FreeSpace space = SmallWorld{.solids = {{{4, 4}, {5.5, 4.5}, {5.5, 5}}}}.space();
  const Goal goal = room({{4, 3}, {6, 6}});
  const auto path = shortest_path(space, {4, 4}, goal);
  ASSERT_TRUE(path);
  EXPECT_EQ(path->length.value(), 0);
}

// It is an entry, of which it is known from where the room can be entered.
TEST(RoomGoal, HasNoFootOfACornerThatLiesOnItsRim) {
  std::optional<Point> of_corner = Point{}, beside;
  for (const detail::RoomSide& side : detail::room_sides({{{7, 4}, {8, 6}}}))
    if (side.side.a == Point{7, 4} && side.side.b == Point{7, 6}) {
      of_corner = side.foot({7, 5});
      beside = side.foot({5, 5});
    }
  EXPECT_EQ(of_corner, std::nullopt);
  EXPECT_EQ(beside, (Point{7, 5}));
}

TEST(RoomGoal, IsNotEnteredThroughAWallOnItsRim) {
  const FreeSpace space = SmallWorld{.walls = {{{4, 2}, {4, 7}}}}.space();
  const Goal goal = room({{4, 3}, {6, 6}});
  const auto path = shortest_path(space, {1, 4}, goal);
  ASSERT_TRUE(path);
  EXPECT_DOUBLE_EQ(path->length.value(), std::hypot(3, 2) + 1);
}

/// A world of few walls on a lattice, and a room in it.
struct Drawn {
  SmallWorld world;
  Box box;
  Point from;

  explicit Drawn(std::mt19937& draw) {
    const auto at_most = [&](int n) { return static_cast<double>(draw() % static_cast<unsigned>(n + 1)); };
    box.min = {1 + at_most(5), 1 + at_most(5)};
    box.max = {box.min.x + 1 + at_most(2), box.min.y + 1 + at_most(2)};
    for (double n = 1 + at_most(5); n > 0; --n)
      world.walls.push_back({{at_most(10), at_most(10)}, {at_most(10), at_most(10)}});
    from = {at_most(20) / 2, at_most(20) / 2};
  }
};

/// Places in the room just behind its sides: where walls cross them, on both sides of that, and between.
std::vector<Point> places_within(const Drawn& drawn) {
  constexpr double kNear = 0x1p-20;
  const Box& b = drawn.box;
  std::vector<double> parts{0x1p-18, 0.2501, 0.5003, 0.7507, 1 - 0x1p-18};
  std::vector<Point> places;
  const auto add_all = [&](Point corner, Point along, Point in, const std::vector<double>& at) {
    for (const double t : at)
      places.push_back({corner.x + t * along.x + kNear * in.x, corner.y + t * along.y + kNear * in.y});
  };
  const double w = b.max.x - b.min.x, h = b.max.y - b.min.y;
  const auto crossed = [&](bool is_upright, double line, double begin, double size) {
    std::vector<double> at = parts;
    for (const Segment& s : drawn.world.walls) {
      const double p = is_upright ? s.a.x : s.a.y, q = is_upright ? s.b.x : s.b.y;
      const double u = is_upright ? s.a.y : s.a.x, v = is_upright ? s.b.y : s.b.x;
      if (p == q || (p - line) * (q - line) > 0) continue;
      const double t = (u + (v - u) * (line - p) / (q - p) - begin) / size;
      for (const double d : {-0x1p-16, 0x1p-16})
        if (t + d > 0 && t + d < 1) at.push_back(t + d);
    }
    return at;
  };
  add_all(b.min, {w, 0}, {0, 1}, crossed(false, b.min.y, b.min.x, w));
  add_all({b.min.x, b.max.y}, {w, 0}, {0, -1}, crossed(false, b.max.y, b.min.x, w));
  add_all(b.min, {0, h}, {1, 0}, crossed(true, b.min.x, b.min.y, h));
  add_all({b.max.x, b.min.y}, {0, h}, {-1, 0}, crossed(true, b.max.x, b.min.y, h));
  return places;
}

TEST(RoomGoal, IsNoFartherThanAnyPlaceInIt) {
  std::mt19937 draw(1);
  for (int k = 0; k < 400; ++k) {
    const Drawn drawn(draw);
    const FreeSpace space = drawn.world.space();
    if (!space.holds(drawn.from)) continue;
    const auto path = shortest_path(space, drawn.from, room(drawn.box));
    const auto same = by_graph(space, drawn.from, room(drawn.box));
    ASSERT_EQ(path.has_value(), same.has_value()) << k;
    if (path) {
      EXPECT_EQ(path->length, same->length) << k;
      EXPECT_TRUE(verify(*path, space, drawn.from, room(drawn.box)).valid) << k;
    }
    for (const Point p : places_within(drawn)) {
      const auto there = space.holds(p) ? shortest_path(space, drawn.from, p) : std::nullopt;
      if (!there) continue;
      ASSERT_TRUE(path) << k;
      EXPECT_LE(path->length.value(), there->length.value() + 1e-12) << k << " " << p.x << " " << p.y;
    }
  }
}

}  // namespace
}  // namespace taut
