#include <taut/roadmaps/all_radii.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <memory>

#include <taut/geometry/maze_generator.h>
#include <taut/io/worlds/read_world.h>
#include <taut/roadmaps/exact/all_radii_parts.h>

#include "support/radii_worlds.h"
#include "support/random_world.h"
#include "support/small_world.h"

namespace taut {
namespace {

/// What two graphs differ in; empty when they are the same.
std::string difference(const TangentGraph& ours, const TangentGraph& theirs) {
  const TangentParts &a = ours.parts(), &b = theirs.parts();
  const auto same_end = [](const TangentEnd& p, const TangentEnd& q) {
    return p.centre == q.centre && p.side == q.side;
  };
  const auto same_leg = [](const TangentLeg& p, const TangentLeg& q) {
    return p.from == q.from && p.to == q.to && p.from_side == q.from_side && p.to_side == q.to_side &&
           p.length.lo <= q.length.hi && q.length.lo <= p.length.hi;
  };
  if (a.legs.size() != b.legs.size()) return fmt::format("{} ends of legs for {}", a.legs.size(), b.legs.size());
  if (a.site_of != b.site_of || a.first_point != b.first_point) return "points";
  for (std::size_t i = 0; i < a.points.size(); ++i)
    if (!same_end(a.points[i].here, b.points[i].here) || !same_end(a.points[i].other, b.points[i].other))
      return fmt::format("point {}", i);
  for (std::size_t i = 0; i < a.legs.size(); ++i)
    if (!same_leg(a.legs[i], b.legs[i])) return fmt::format("leg {}", i);
  if (a.first_leg != b.first_leg || a.arc_is_free != b.arc_is_free || a.arcs != b.arcs) return "arcs";
  return "";
}

void is_as_one_radius(const AllRadii& all, double r) {
  RC_LOG(fmt::format("r {}\n", r));
  RC_ASSERT(difference(all.at_radius(r), TangentGraph(all.space(), r)) == "");
}

/// At events, just below and just above them, and anywhere; `most` events of the world, spread.
void agrees_with_single_radii(const World& world, std::size_t most) {
  const AllRadii all{FreeSpace(world)};
  for (const double r : test::radii_to_ask(all, most)) is_as_one_radius(all, r);
}

std::size_t events_a_world() { return std::getenv("TAUT_RADII_HEAVY") ? 1000 : 4; }

World world_of_text(const std::string& text) { return read_world(text, {}); }

//  FIELD-NOTES' kind of world: a wall stands beside the inner tangent where it is neither flat nor steep.
constexpr const char* kComingAndGoing =
    "boundary -6 -6 8 6\nstart -5 0\ngoal 7 0\n0 0 -1 1\n2 0 3 -1\n0.6 -1.04 0.6 -3\n";

TEST(AllRadii, HasAnInnerTangentThatGoesAndComesBack) {
  const AllRadii all{FreeSpace(world_of_text(kComingAndGoing))};
  std::vector<RadiusSpan> certain;
  for (std::size_t i = 0; i < all.leg_count(); ++i) {
    const RadiiLeg leg = all.leg(i);
    const bool forward = leg.from == Point{0, 0} && leg.to == Point{2, 0} && leg.from_side == 1 && leg.to_side == -1;
    const bool backward = leg.from == Point{2, 0} && leg.to == Point{0, 0} && leg.from_side == 1 && leg.to_side == -1;
    if (!forward && !backward) continue;
    for (const RadiusSpan& span : leg.spans)
      if (span.certain) certain.push_back(span);
  }
  ASSERT_EQ(certain.size(), 2u);
  EXPECT_NEAR(certain[0].to, 0.6052, 0.0001);
  EXPECT_NEAR(certain[1].from, 0.992, 0.0005);
  EXPECT_NEAR(certain[1].to, 1, 1e-6);
  for (const double r : test::radii_to_ask(all, 1000))
    EXPECT_EQ(difference(all.at_radius(r), TangentGraph(all.space(), r)), "") << r;
}

TEST(AllRadii, DecidesARadiusAtAnEventExactly) {
  // A door 2 wide: the disc of radius 1 touches both posts.
  const World world =
      test::SmallWorld{.walls = {{{0, 5}, {4, 5}}, {{6, 5}, {10, 5}}}, .solids = {}}.bounded(Boundary::walled);
  const AllRadii all{FreeSpace(world)};
  for (const double r : {1.0, std::nextafter(1, 0), std::nextafter(1, 2), 0.1, 0.3, 1e-7, 2.5, 40.0, 1000.0})
    EXPECT_EQ(difference(all.at_radius(r), TangentGraph(all.space(), r)), "") << r;
}

TEST(AllRadii, IsTheSameEachTime) {
  const FreeSpace space(world_of_text(kComingAndGoing));
  const AllRadii a(space), b(space);
  EXPECT_EQ(a.parts().legs, b.parts().legs);
  EXPECT_EQ(a.parts().spans, b.parts().spans);
}

RC_GTEST_PROP(AllRadii, AgreesWithTheGraphOfEachRadiusInMessyWorlds, ()) {
  const test::SmallWorld small =
      test::any_world({.side = 6, .walls = 7, .solids = 2, .straight = test::any(0, 1) == 1});
  const Boundary boundary = std::array{Boundary::walled, Boundary::limit, Boundary::open}[test::any(0, 2)];
  RC_LOG(test::show(small) + fmt::format(" boundary {}\n", int(boundary)));
  agrees_with_single_radii(small.bounded(boundary), events_a_world());
}

RC_GTEST_PROP(AllRadii, AgreesWithTheGraphOfEachRadiusInMazes, ()) {
  const int width = test::any(2, 6), height = test::any(2, 6), seed = test::any(0, 1 << 20);
  auto maze = std::make_shared<GridMaze>(generate_backtracker(width, height, seed));
  open_walls(*maze, test::any(0, 8) / 10.0, seed);
  RC_LOG(fmt::format("{} x {} seed {}\n", width, height, seed));
  agrees_with_single_radii(world_of(maze), events_a_world() / 2);
}

}  // namespace
}  // namespace taut
