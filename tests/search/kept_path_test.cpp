#include <taut/search/kept_path.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include <taut/roadmaps/disc_places.h>
#include <taut/search/arc_search.h>

#include "support/random_world.h"
#include "support/small_world.h"

namespace taut {
namespace {

using test::SmallWorld;
using Status = KeptPath::Status;

PassageIndex room(const std::vector<Segment>& walls) {
  return PassageIndex(FreeSpace(SmallWorld{.walls = walls, .solids = {}}.bounded(Boundary::walled)));
}

std::vector<double> radii(const KeptPath& path) {
  std::vector<double> all;
  for (const ArcPath& part : path.parts) all.push_back(part.radius);
  return all;
}

//   +-------------+
//   |             |
//   |  .-------.  |    both ends are 1/4 from the floor: up to 1, along, down again
//   +--s-------g--+
TEST(KeptPath, LeavesAWallByTheShortestWayAndComesBackSo) {
  const PassageIndex index = room({});
  const KeptPath path = kept_path(index, {2, 0.25}, {8, 0.25}, 1);
  ASSERT_EQ(path.status, Status::found);
  EXPECT_EQ(radii(path), (std::vector<double>{0.25, 1, 0.25}));
  EXPECT_EQ(path.parts[1].start, (Point{2, 1}));
  EXPECT_EQ(path.parts[1].goal, (Point{8, 1}));
  EXPECT_NEAR(path.length.middle(), 0.75 + 6 + 0.75, 1e-12);
  EXPECT_EQ(kept_path_fault(path, index, {2, 0.25}, {8, 0.25}), "");
}

TEST(KeptPath, OfEndsThatAreNearToEachOtherIsStraight) {
  const PassageIndex index = room({});
  const KeptPath path = kept_path(index, {2, 0.25}, {3, 0.5}, 1);
  ASSERT_EQ(path.status, Status::found);
  EXPECT_EQ(radii(path), std::vector<double>{0.25});
  EXPECT_EQ(path.first, path.last);
  EXPECT_EQ(kept_path_fault(path, index, {2, 0.25}, {3, 0.5}), "");
}

TEST(KeptPath, BetweenPlacesIsThatOfTheDisc) {
  const PassageIndex index = room({{{0, 5}, {5, 5}}});
  const KeptPath path = kept_path(index, {2, 2}, {2, 8}, 1);
  ASSERT_EQ(path.status, Status::found);
  ASSERT_EQ(path.parts.size(), 1U);
  EXPECT_EQ(path.parts[0].bends, (std::vector<ArcBend>{{{5, 5}, 1}}));
}

TEST(KeptPath, StartsOnAWall) {
  const PassageIndex index = room({});
  const KeptPath path = kept_path(index, {4, 0}, {4, 5}, 1);
  ASSERT_EQ(path.status, Status::found);
  EXPECT_EQ(radii(path), (std::vector<double>{0, 1}));
  EXPECT_EQ(path.length.middle(), 5);
  EXPECT_EQ(kept_path_fault(path, index, {4, 0}, {4, 5}), "");
}

//   +------+      a corridor 1 wide, bent; s stands 1/4 from its wall: first to the middle, by the disc of 1/2 around
//   |   g  |      the bend to the mouth, where there is room for 1
//   +--+ +-+
//   |s     |
//   +------+
TEST(KeptPath, GetsOutOfAPocketByTheLargestDiscThatFits) {
  const PassageIndex index = room({{{0, 1}, {4, 1}}, {{5, 1}, {10, 1}}});
  const Point s{1, 0.25}, g{5, 6};
  const KeptPath path = kept_path(index, s, g, 1);
  ASSERT_EQ(path.status, Status::found);
  EXPECT_EQ(radii(path), (std::vector<double>{0.25, 0.5, 1}));
  EXPECT_EQ(path.parts[0].goal, (Point{1, 0.5}));
  // Above the gate's middle, 1 away from both its ends.
  EXPECT_NEAR(path.parts[2].start.x, 4.5, 1e-12);
  EXPECT_NEAR(path.parts[2].start.y, 1 + std::sqrt(0.75), 1e-12);
  EXPECT_EQ(kept_path_fault(path, index, s, g), "");
}

TEST(KeptPath, IsNoneWhereADoorBetweenPlacesIsTooNarrow) {
  EXPECT_EQ(kept_path(room({{{0, 5}, {4, 5}}, {{5, 5}, {10, 5}}}), {5, 2}, {5, 8}, 1).status, Status::none);
}

TEST(KeptPath, HasNoEndOutside) {
  EXPECT_EQ(kept_path(room({}), {11, 2}, {5, 8}, 1).status, Status::start_blocked);
  EXPECT_EQ(kept_path(room({}), {5, 2}, {5, 11}, 1).status, Status::goal_blocked);
}

TEST(KeptPath, IsFaultyWhenAPartComesTooNear) {
  const PassageIndex index = room({});
  KeptPath path = kept_path(index, {2, 0.25}, {8, 0.25}, 1);
  path.parts[0].radius = 0.375;
  EXPECT_NE(kept_path_fault(path, index, {2, 0.25}, {8, 0.25}), "");
}

RC_GTEST_PROP(KeptPath, KeepsWhatItSaysAndIsTheDiscsPathBetweenPlaces, ()) {
  const SmallWorld small = test::any_world({.side = 6, .walls = 6, .solids = 2});
  const PassageIndex index(FreeSpace(small.bounded(test::any(0, 1) ? Boundary::walled : Boundary::open)));
  const Point s = test::any(0, 2) ? test::any_fine_point(6) : test::any_lattice_point(6), g = test::any_fine_point(6);
  const double c = test::any(5, 80) / 100.0;
  RC_LOG(test::show(small) + fmt::format(" s {} g {} c {}\n", test::show(s), test::show(g), c));
  const KeptPath path = kept_path(index, s, g, c);
  const bool found = path.status == Status::found;
  if (found) RC_ASSERT(kept_path_fault(path, index, s, g) == "");
  const DiscPlaces places(index.gates().space(), c);
  if (places.is_free(s) && places.is_free(g)) {
    RC_ASSERT(found == (index.passes(s, g, c) == DiscStatus::found));
    if (!found) return;
    const ArcSearchResult disc = arc_search(TangentGraph(index.gates().space(), c), s, g);
    RC_ASSERT(std::abs(disc.path.value() - path.length.middle()) <= 1e-9);
  } else if (found && path.first > 0 && path.first != path.last) {
    const auto nearest = places.nearest(s);
    RC_ASSERT(nearest.has_value());
    double left = 0;
    for (std::size_t i = 0; i < path.first; ++i) left += path.parts[i].value();
    RC_ASSERT(left >= nearest->distance - nearest->rounding - 1e-9);
  }
}

}  // namespace
}  // namespace taut
