// Walls that come and go on a prepared world: each query as on a world built anew.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <optional>
#include <vector>

#include <taut/geometry/errors.h>
#include <taut/geometry/written.h>
#include <taut/search/changing_world.h>
#include <taut/search/polyanya.h>
#include <taut/search/verify.h>

#include "support/random_world.h"
#include "support/small_world.h"

namespace taut {
namespace {

using namespace test;
using testing::ElementsAre;

TEST(ChangingWorld, GoesAroundAWallThatWasAddedAndThroughAgain) {
  ChangingWorld world{SmallWorld{}.space()};
  world.add({{5, 0}, {5, 8}});
  EXPECT_EQ(world.find({4, 1}, {6, 1}), SearchStatus::found);
  EXPECT_THAT(world.points(), ElementsAre(Point{4, 1}, Point{5, 8}, Point{6, 1}));
  EXPECT_TRUE(world.remove({{5, 8}, {5, 0}}));
  world.find({4, 1}, {6, 1});
  EXPECT_THAT(world.points(), ElementsAre(Point{4, 1}, Point{6, 1}));
  EXPECT_DOUBLE_EQ(world.length(), 2);
}

TEST(ChangingWorld, TakesADoorOutOfAWall) {
  ChangingWorld world{SmallWorld{.walls = {{{5, 0}, {5, 10}}}}.space()};
  EXPECT_EQ(world.find({4, 1}, {6, 1}), SearchStatus::none);
  EXPECT_FALSE(world.remove({{5, 4}, {5, 11}})) << "it does not lie on the wall";
  EXPECT_FALSE(world.remove({{5, 4}, {5, 4}}));
  EXPECT_TRUE(world.remove({{5, 4}, {5, 3}}));
  EXPECT_EQ(world.find({4, 1}, {6, 1}), SearchStatus::found);
  EXPECT_THAT(world.points(), ElementsAre(Point{4, 1}, Point{5, 3}, Point{6, 1}));
  world.add({{5, 3}, {5, 4}});
  EXPECT_EQ(world.find({4, 1}, {6, 1}), SearchStatus::none);
}

TEST(ChangingWorld, PreparesNothingForAWallThatNoPathTouches) {
  ChangingWorld world{SmallWorld{.walls = {{{7, 1}, {8, 2}}}}.space()};
  for (int i = 0; i < 9; ++i) world.add({{i + 0.5, 9}, {i + 0.5, 10}});
  EXPECT_EQ(world.find({0, 1}, {9, 2}), SearchStatus::found);
  EXPECT_EQ(world.rebuilds(), 0u);
  world.find({0, 9.5}, {9, 9.5});
  EXPECT_EQ(world.rebuilds(), 1u);
  world.find({0, 9.5}, {9, 9.5});
  EXPECT_EQ(world.rebuilds(), 1u);
}

TEST(ChangingWorld, PreparesNothingWhereAllIsAxisParallel) {
  ChangingWorld world{SmallWorld{}.space()};
  for (int i = 0; i < 9; ++i) {
    world.add({{i + 0.5, 1}, {i + 0.5, 10}});
    EXPECT_EQ(world.find({0, 9.5}, {9, 9.5}), SearchStatus::found);
  }
  EXPECT_TRUE(world.is_among_cells());
  world.add({{2, 3}, {3, 4}});
  EXPECT_FALSE(world.is_among_cells());
  EXPECT_TRUE(world.remove({{2, 3}, {3, 4}}));
  EXPECT_TRUE(world.is_among_cells());
  EXPECT_EQ(world.find({0, 9.5}, {9, 9.5}), SearchStatus::found);
  EXPECT_EQ(world.rebuilds(), 0u);
}

TEST(ChangingWorld, KeepsAnIndexUntilSomethingThatItKnowsIsTakenAway) {
  ChangingWorld world{Index(SmallWorld{.walls = {{{5, 0}, {5, 8}}}}.space())};
  world.add({{2, 0}, {2, 5}});
  world.find({1, 1}, {3, 1});
  EXPECT_THAT(world.points(), ElementsAre(Point{1, 1}, Point{2, 5}, Point{3, 1}));
  EXPECT_TRUE(world.remove({{2, 0}, {2, 5}}));
  EXPECT_TRUE(world.has_index());
  EXPECT_TRUE(world.remove({{5, 7}, {5, 8}}));
  EXPECT_FALSE(world.has_index());
  world.find({4, 1}, {6, 1});
  EXPECT_THAT(world.points(), ElementsAre(Point{4, 1}, Point{5, 7}, Point{6, 1}));
}

TEST(ChangingWorld, RefusesWallsOutsideAndNoPlaces) {
  ChangingWorld world{SmallWorld{}.space()};
  EXPECT_THROW(world.add({{5, 0}, {5, 11}}), InputError);
  EXPECT_THROW(world.add({{5, 0}, {5, 1}, -1}), InputError);
  EXPECT_THROW(world.find({-1, 0}, {5, 1}), InputError);
}

std::optional<FreeSpace> built(const WorldParts& parts, const std::vector<Point>& ends = {}) {
  try {
    return FreeSpace(World(parts), Footprint::point(), ends);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

/// As written: a point in line adds some to the sum of its legs' doubles.
Length straight_length(const std::vector<Point>& points) {
  std::vector<Point> kept;
  for (const Point p : points) {
    if (kept.size() > 1 && written::on_segment(kept.back(), kept[kept.size() - 2], p)) kept.pop_back();
    kept.push_back(p);
  }
  return Length(kept);
}

class Model {
 public:
  explicit Model(const SmallWorld& world) : parts_(world.parts()) {}

  void change(ChangingWorld& world, const RandomWorld& kind) {
    if (parts_.walls.empty() || any(0, 2) > 0) {
      const Segment s = any_wall(kind);
      if (s.a == s.b) return;
      world.add({s.a, s.b, 0, 0});
      parts_.walls.push_back({s.a, s.b, 0, 0});
      return;
    }
    const Wall wall = parts_.walls[static_cast<std::size_t>(any(0, static_cast<int>(parts_.walls.size()) - 1))];
    const Point middle = written::middle(Segment{wall.a, wall.b});
    const Segment stretch = any(0, 1) == 0 ? Segment{wall.b, wall.a} : Segment{wall.a, middle};
    RC_ASSERT(world.remove(stretch) == take_out(stretch));
  }

  const WorldParts& parts() const { return parts_; }

 private:
  bool take_out(const Segment& stretch) {
    std::vector<Wall> left;
    bool is_there = false;
    for (const Wall& wall : parts_.walls) {
      const auto holds = [&](Point p) { return written::on_segment(p, wall.a, wall.b); };
      if (stretch.a == stretch.b || !holds(stretch.a) || !holds(stretch.b)) {
        left.push_back(wall);
        continue;
      }
      is_there = true;
      const auto along = [&](Point p) { return std::abs(p.x - wall.a.x) + std::abs(p.y - wall.a.y); };
      const auto [near, far] =
          along(stretch.a) < along(stretch.b) ? std::pair(stretch.a, stretch.b) : std::pair(stretch.b, stretch.a);
      if (near != wall.a) left.push_back({wall.a, near, 0, 0});
      if (far != wall.b) left.push_back({far, wall.b, 0, 0});
    }
    parts_.walls = left;
    return is_there;
  }

  WorldParts parts_;
};

std::string fault(ChangingWorld& world, const FreeSpace& space, Point from, Point to) {
  PolyanyaSearch cones{Polyanya(space)};
  const SearchStatus expected = cones.find(from, to), found = world.find(from, to);
  if (found != expected) return "one finds a path, the other none";
  if (found != SearchStatus::found) return "";
  const Length length = straight_length(world.points()), shortest = straight_length(cones.points());
  const bool is_rounded = space.report().displacement > 0;
  if (is_rounded ? std::abs(length.value() - shortest.value()) > 1e-9 : length != shortest)
    return fmt::format("{} instead of {}", length.value(), shortest.value());
  if (is_rounded) return "";
  return verify({world.points(), Length(world.points())}, space, from, {to, {}}).valid ? "" : "through a wall";
}

void agree_in(const RandomWorld& kind) {
  const SmallWorld first = any_world(kind);
  const auto space = built(first.parts());
  if (!space) return;
  ChangingWorld world = any(0, 1) == 0 ? ChangingWorld(*space) : ChangingWorld(Index(*space));
  Model model(first);
  for (int n = 0; n < 25; ++n) {
    model.change(world, kind);
    if (any(0, 1) == 0) continue;
    const Point from = any_lattice_point(2 * kind.side), to = any_lattice_point(2 * kind.side);
    const Point p{from.x / 2, from.y / 2}, q{to.x / 2, to.y / 2};
    const auto anew = built(model.parts(), {p, q});
    if (!anew) return;
    if (anew->locate(p).kind == Location::Kind::outside || anew->locate(q).kind == Location::Kind::outside) continue;
    if (const std::string wrong = fault(world, *anew, p, q); !wrong.empty())
      RC_FAIL(fmt::format("{} after {} changes, from {} to {}: {}", show(first), n + 1, show(p), show(q), wrong));
  }
}

RC_GTEST_PROP(ChangingWorldProperty, AnswersAsAWorldBuiltAnew, ()) {
  agree_in({.side = 8, .walls = 12, .solids = 2, .straight = true});
}

RC_GTEST_PROP(ChangingWorldProperty, AnswersAsAWorldBuiltAnewAmongSlopedWalls, ()) {
  agree_in({.side = 6, .walls = 6, .solids = 2});
}

}  // namespace
}  // namespace taut
