#include <taut/io/worlds/free_space_text.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <taut/search/shortest_path.h>

#include "support/random_world.h"
#include "support/small_world.h"

namespace taut {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

FreeSpace read_back(const FreeSpace& space, Format format) {
  return FreeSpace(read_world(write_free_space(space, format)));
}

FreeSpace any_space() {
  const auto small = test::any_world({.walls = 6, .solids = 2, .thickness = test::any(0, 2) / 5.0});
  RC_LOG(test::show(small));
  const World world = small.bounded(test::any(0, 1) ? Boundary::walled : Boundary::limit);
  const int robot = test::any(0, 2);
  return FreeSpace(world, robot == 0   ? Footprint::point()
                          : robot == 1 ? Footprint::disc(test::any(1, 8) / 16.0)
                                       : Footprint::square(test::any(1, 8) / 10.0));
}

RC_GTEST_PROP(FreeSpaceText, IsTheSameFreeSpaceReadBack, ()) {
  const FreeSpace space = any_space();
  RC_PRE(!space.polygons().empty());
  for (const Format format : {Format::wkt, Format::geojson}) {
    const FreeSpace again = read_back(space, format);
    RC_ASSERT(again.polygons() == space.polygons());
    RC_ASSERT(size_of(again).area == size_of(space).area);
  }
}

RC_GTEST_PROP(FreeSpaceText, HasThePathsOfTheRobotForAPoint, ()) {
  const FreeSpace space = any_space();
  RC_PRE(!space.polygons().empty());
  const FreeSpace again = read_back(space, Format::wkt);
  for (int n = 0; n < 4; ++n) {
    const Point p = test::any_fine_point(6), q = test::any_fine_point(6);
    RC_ASSERT(space.locate(p).kind == again.locate(p).kind);
    if (space.locate(p).kind == Location::Kind::outside || space.locate(q).kind == Location::Kind::outside) continue;
    const auto path = shortest_path(space, p, q), same = shortest_path(again, p, q);
    RC_ASSERT(path.has_value() == same.has_value());
    if (path) RC_ASSERT(path->length == same->length);
  }
}

TEST(FreeSpaceText, KeepsWallsOfZeroThickness) {
  const test::SmallWorld room{.walls = {{{4, 5}, {6, 5}}}};
  const FreeSpace space(room.bounded(Boundary::walled));
  EXPECT_EQ(write_free_space(space, Format::wkt), "POLYGON ((0 0, 10 0, 10 10, 0 10, 0 0))\nLINESTRING (4 5, 6 5)\n");
  const FreeSpaceSize size = size_of(space);
  EXPECT_EQ(size.polygons, 1u);
  EXPECT_EQ(size.holes, 0u);
  EXPECT_EQ(size.corners, 4u);
  EXPECT_EQ(size.walls, 1u);
  EXPECT_EQ(size.area, 100);
}

TEST(FreeSpaceText, SaysThatNothingIsFree) {
  const FreeSpace space(test::SmallWorld{}.bounded(Boundary::walled), Footprint::square(6));
  EXPECT_EQ(write_free_space(space, Format::wkt), "POLYGON EMPTY\n");
  EXPECT_THAT(write_free_space(space, Format::geojson), HasSubstr("\"features\": []"));
  EXPECT_EQ(size_of(space).polygons, 0u);
}

}  // namespace
}  // namespace taut
