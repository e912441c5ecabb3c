// Plans that were turned: what touched, touches but for rounding, and the answers are those of before.
#include <gtest/gtest.h>

#include <random>
#include <string>

#include <support/paths.h>
#include <support/small_world.h>
#include <support/turned.h>
#include <taut/geometry/snap.h>
#include <taut/io/worlds/read_world.h>
#include <taut/search/corner_count.h>
#include <taut/search/shortest_path.h>
#include <taut/search/verify.h>

namespace taut {
namespace {

using test::box_ring;
using test::kSurvey;
using test::Turn;
using test::turns;

struct Answer {
  double length = -1;  // none
  std::size_t corners = 0;
};

Answer answer(const World& world) {
  const FreeSpace space(world);
  const auto path = shortest_path(space, *world.start(), world.goal());
  if (!path) return {};
  EXPECT_TRUE(verify(*path, space, *world.start(), world.goal()).valid);
  return {path->length.value(), corner_count(path->points, world.uncertainty())};
}

/// As readers make it.
Answer answer(const WorldParts& parts) { return answer(snapped_world(parts).world); }

void expect_same(const Answer& turned, const Answer& flat, Point moved_to) {
  // An end's coordinates are off by half a unit in the last place.
  EXPECT_NEAR(turned.length, flat.length, moved_to == Point{} ? 1e-9 : 1e-6);
  EXPECT_EQ(turned.corners, flat.corners);
}

void expect_same_at_all_angles(const WorldParts& parts, const Answer& flat, int usual, double step) {
  for (const Point to : {Point{}, kSurvey})
    for (int i = 0; i < turns(usual); ++i) {
      SCOPED_TRACE("turned by " + std::to_string((i + 1) * step) + " degrees" + (to == Point{} ? "" : ", survey"));
      expect_same(answer(Turn((i + 1) * step, to)(parts)), flat, to);
    }
}

class TurnedMazeFile : public testing::TestWithParam<const char*> {};

TEST_P(TurnedMazeFile, HasTheLengthAndTheCornersThatItHadWithoutABoundaryLine) {
  const World flat = read_world_file((test::data_dir() / GetParam()).string());
  WorldParts parts;
  parts.walls = flat.walls();
  const Answer right = answer(flat);
  ASSERT_GT(right.length, 0);
  expect_same_at_all_angles(parts, right, 5, 31.7);  // ends at its two openings
  parts.start = flat.start();
  parts.goal = flat.goal();
  expect_same_at_all_angles(parts, right, 5, 3.6);
}

INSTANTIATE_TEST_SUITE_P(OfThisProject, TurnedMazeFile, testing::Values("maze_25x25.txt", "maze_45x45.txt"));

/// A corridor with eight rooms, whose corners lie on its long side.
WorldParts corridor() {
  WorldParts parts;
  parts.boundary = Boundary::walled;
  parts.areas.push_back({{box_ring(0, 0, 40, 2), {}}, 0});
  for (int i = 0; i < 8; ++i) {
    const double x = 5 * i, door = x + (i % 2 == 0 ? 3 : 1);
    parts.areas.push_back({{box_ring(x, 2, x + 5, 6), {}}, 0});
    parts.walls.push_back({{x + 5, 2}, {x + 5, 6}});
    parts.walls.push_back({{x, 2}, {door, 2}});
    parts.walls.push_back({{door + 1, 2}, {x + 5, 2}});
  }
  parts.start = Point{1, 5};
  parts.goal.point = Point{39, 4};
  return parts;
}

TEST(TurnedCorridor, HasItsEightRooms) {
  const Answer right = answer(World(corridor()));
  ASSERT_GT(right.length, 38);
  expect_same_at_all_angles(corridor(), right, 12, 7);
}

class Draw {
 public:
  explicit Draw(unsigned seed) : engine_(seed) {}
  double upto(int n) { return static_cast<double>(engine_() % static_cast<unsigned>(n + 1)); }
  Ring box(int most) {
    const double x = upto(16), y = upto(16);
    const double width = 1 + upto(most), height = 1 + upto(most);
    return box_ring(x, y, x + width, y + height);
  }

 private:
  std::mt19937 engine_;
};

WorldParts plan(unsigned seed) {
  Draw draw(seed);
  WorldParts parts;
  if (seed % 2 == 0) parts.boundary = Boundary::walled;
  if (seed % 2 != 0) parts.areas.push_back({{box_ring(0, 0, 20, 20), {}}, 0});
  for (int i = 0; i < 30; ++i) (seed % 2 == 0 ? parts.areas : parts.solids).push_back({{draw.box(3), {}}, 0});
  for (int i = 0; i < 20; ++i) {
    const Ring box = draw.box(2);
    parts.walls.push_back({box[0], box[i % 2 == 0 ? 1 : 3]});
  }
  const auto inside = [&](std::size_t i) { return parts.areas[i % parts.areas.size()].polygon.outer[0]; };
  parts.start = Point{inside(0).x + 0.5, inside(0).y + 0.5};
  parts.goal.point = seed % 2 == 0 ? Point{inside(1).x + 0.5, inside(1).y + 0.5} : Point{19.5, 19.5};
  return parts;
}

TEST(TurnedPlan, OfRoomsOrHousesThatTouchAndOverlapAnswersAsBefore) {
  const int wanted = turns(12);
  for (int seed = 0; seed < wanted; ++seed) {
    SCOPED_TRACE("plan " + std::to_string(seed));
    const WorldParts flat = plan(static_cast<unsigned>(seed));
    const World world(flat);
    if (FreeSpace(world).locate(*flat.start).kind == Location::Kind::outside) continue;
    const Answer right = answer(world);
    for (const Point to : {Point{}, kSurvey}) expect_same(answer(Turn(11.3 + seed, to)(flat)), right, to);
  }
}

TEST(TurnedPlan, IsNotRefusedForADiscWhereItWasNotBefore) {
  const FreeSpace flat(World(corridor()), Footprint::disc(0.2));
  for (int i = 0; i < turns(3); ++i) {
    const Turn turn(4.5 + 7 * i);
    const World world = snapped_world(turn(corridor())).world;
    const FreeSpace space(world, Footprint::disc(0.2));
    const auto path = shortest_path(space, *world.start(), world.goal());
    ASSERT_TRUE(path);
    // The polygon around the disc does not turn along.
    EXPECT_NEAR(path->length.value(), shortest_path(flat, {1, 5}, Point{39, 4})->length.value(), 1e-3);
  }
}

}  // namespace
}  // namespace taut
