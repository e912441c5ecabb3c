#include <taut/search/radius_queries.h>

#include <gtest/gtest.h>

#include "support/small_world.h"

namespace taut {
namespace {

using test::SmallWorld;

// A door 1 wide in the wall x = 4.
RadiusQueries door() {
  const SmallWorld room{.walls = {{{4, 0}, {4, 2}}, {{4, 3}, {4, 5}}}, .area = test::box_ring(0, 0, 8, 5)};
  return RadiusQueries(AllRadii(room.space()));
}

TEST(RadiusQueries, MakeNoGraphForARadiusThatIsAskedAboutOnce) {
  RadiusQueries queries = door();
  for (const double r : {0.1, 0.2, 0.3, 0.6}) queries.find(r, {2, 1}, {6, 1});
  EXPECT_EQ(queries.graphs_made(), 0U);
  EXPECT_EQ(queries.graph(0.4), nullptr);
}

TEST(RadiusQueries, AnswerAlikeWithTheGraphAndWithout) {
  RadiusQueries queries = door();
  for (const double r : {0.25, 0.5, 0.75}) {
    const ArcSearchResult first = queries.find(r, {2, 1}, {6, 1}), second = queries.find(r, {2, 1}, {6, 1});
    EXPECT_EQ(first.status, r > 0.5 ? DiscStatus::none : DiscStatus::found) << r;
    EXPECT_EQ(second.status, first.status) << r;
    EXPECT_NEAR(second.path.value(), first.path.value(), 1e-12) << r;
  }
  EXPECT_EQ(queries.graphs_made(), 3U);
}

TEST(RadiusQueries, KeepTheGraphsOfSixteenRadii) {
  RadiusQueries queries = door();
  const auto ask_twice = [&](int sixtyfourths) {
    for (int i = 0; i < 2; ++i) queries.find(sixtyfourths / 64.0, {2, 1}, {6, 1});
  };
  for (int n = 1; n <= 16; ++n) ask_twice(n);
  ask_twice(1);
  EXPECT_EQ(queries.graphs_made(), 16U);
  ask_twice(17);  // for which that of 2 goes
  ask_twice(1);
  EXPECT_EQ(queries.graphs_made(), 17U);
  ask_twice(2);
  EXPECT_EQ(queries.graphs_made(), 18U);
}

}  // namespace
}  // namespace taut
