#include <algorithm>

#include <gtest/gtest.h>

#include <taut/geometry/free_space.h>

#include "support/small_world.h"

namespace taut {
namespace {

using test::box_ring;
using test::SmallWorld;

/// Each piece starts where one before it ended.
void expect_closed(const std::vector<Constraint>& chain) {
  ASSERT_FALSE(chain.empty());
  const auto share_an_end = [](const Constraint& c, const Constraint& d) {
    return c.a == d.a || c.a == d.b || c.b == d.a || c.b == d.b;
  };
  for (std::size_t i = 0; i < chain.size(); ++i)
    EXPECT_TRUE(share_an_end(chain[i], chain[(i + 1) % chain.size()])) << i;
}

TEST(Separation, IsTheClosedChainAroundAPen) {
  const FreeSpace space = SmallWorld{
      .walls = {{{3, 3}, {6, 3}}, {{6, 3}, {6, 6}}, {{6, 6}, {3, 6}}, {{3, 6}, {3, 3}}},
      .solids = {}}.space();
  for (const auto& chain : {space.separation({1, 1}, {5, 5}), space.separation({5, 5}, {1, 1})}) {
    expect_closed(chain);
    EXPECT_EQ(chain.size(), 4u);
    for (const Constraint& c : chain) EXPECT_TRUE(c.is_wall());
  }
}

TEST(Separation, IsEmptyBetweenConnectedPlaces) {
  const FreeSpace space = SmallWorld{.walls = {{{3, 3}, {6, 3}}}, .solids = {}}.space();
  EXPECT_TRUE(space.separation({1, 1}, {5, 5}).empty());
}

TEST(Separation, RunsAlongTheOutlineOfTheSmallerPart) {
  const FreeSpace space = SmallWorld{.walls = {{{0, 9}, {10, 9}}}, .solids = {box_ring(2, 2, 4, 4)}}.space();
  const auto chain = space.separation({5, 5}, {5, 9.5});
  expect_closed(chain);
  EXPECT_TRUE(std::any_of(chain.begin(), chain.end(), [](const Constraint& c) { return c.is_wall(); }));
}

TEST(Separation, FindsTheHoleAroundANestedPlace) {
  // A ring of blocks inside a larger pen: the inner one's outline is shorter.
  SmallWorld world{.walls = {{{1, 1}, {9, 1}}, {{9, 1}, {9, 9}}, {{9, 9}, {1, 9}}, {{1, 9}, {1, 1}}},
                   .solids = {box_ring(3, 3, 7, 4), box_ring(3, 6, 7, 7), box_ring(3, 3, 4, 7), box_ring(6, 3, 7, 7)}};
  const auto chain = world.space().separation({2, 2}, {5, 5});
  expect_closed(chain);
  for (const Constraint& c : chain) EXPECT_FALSE(c.is_wall());
}

}  // namespace
}  // namespace taut
