#include <taut/search/passage.h>

#include <gtest/gtest.h>

#include <taut/geometry/walled_world.h>
#include <taut/io/worlds/read_world.h>
#include <taut/search/arc_pinch.h>
#include <taut/search/arc_search.h>

namespace taut {
namespace {

// Two rooms; from the left to the right one a door of width 1 at the bottom, one of width 3 at the top.
constexpr const char* kTwoDoors =
    "0 0 20 0\n20 0 20 20\n20 20 0 20\n0 20 0 0\n10 0 10 2\n10 3 10 16\n10 19 10 20\nstart 5 5\ngoal 15 5\n";

TEST(DiscPassageAnswer, SaysHowLargeADiscMayBeAndWhatStopsALargerOne) {
  const Gates gates{FreeSpace(read_world(kTwoDoors))};
  const Passage any = passage(gates, {5, 5}, {{15, 5}});
  EXPECT_TRUE(any.gets_through());
  ASSERT_TRUE(any.widest);
  EXPECT_EQ(any.widest->radius, 1.5);
  ASSERT_EQ(any.barrier.gates.size(), 2U);
  EXPECT_EQ(any.barrier.gates[0].width_text, "3") << "the widest first";
}

TEST(DiscPassageAnswer, OfADiscIsNoneWithTheGatesThatAreTooNarrow) {
  const Gates gates{FreeSpace(read_world(kTwoDoors))};
  EXPECT_TRUE(passage(gates, {5, 5}, {{15, 5}}, 1.5).gets_through());
  const Passage none = passage(gates, {5, 5}, {{15, 5}}, 1.6);
  EXPECT_FALSE(none.gets_through());
  EXPECT_TRUE(none.is_proven());
  EXPECT_EQ(none.barrier.gates.size(), 2U);
}

TEST(DiscPassageAnswer, GoesToTheGoalThatTheLargestDiscReaches) {
  const Gates gates{FreeSpace(read_world(kTwoDoors))};
  EXPECT_EQ(passage(gates, {5, 5}, {{15, 19.9}, {15, 5}}).goal, (Point{15, 5}));
}

TEST(WalledWorld, HasADeadEndBehindADoorThatAnEndStandsOn) {
  const World open = read_world("0 0 4 0\n4 0 4 1\n4 2 4 3\n4 3 0 3\n0 3 0 0\nstart 1 1.5\ngoal 4 1.5\n");
  ASSERT_EQ(open.openings().size(), 1U);
  EXPECT_EQ(walled_world(open, {{4, 1.5}}).boundary(), Boundary::walled);
  const FreeSpace with_porch(walled_world(open, {{4, 1.5}})), without(walled_world(open, {{1, 1.5}}));
  EXPECT_NE(with_porch.locate({4.5, 1.5}).kind, Location::Kind::outside);
  EXPECT_EQ(without.locate({4.5, 1.5}).kind, Location::Kind::outside);
}

TEST(NarrowestGate, IsTheNarrowestOfThoseThatTheWayOfADiscPasses) {
  const FreeSpace space(read_world(kTwoDoors));
  const Gates gates{space};
  const auto way = [&](double r) { return arc_search(TangentGraph(space, r), {5, 5}, {15, 5}).path; };
  const auto small = narrowest_gate(gates, way(0.25)), large = narrowest_gate(gates, way(1));
  ASSERT_TRUE(small && large);
  EXPECT_EQ(small->gate.width, 1);
  EXPECT_EQ(large->gate.width, 3);
  EXPECT_NEAR(small->at.x, 10, 1e-3);
  EXPECT_GE(small->at.y, 2.25);
  EXPECT_LE(small->at.y, 2.75 + 1e-9);
}

}  // namespace
}  // namespace taut
