#include <taut/roadmaps/voronoi.h>

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include <taut/geometry/maze_generator.h>
#include <taut/geometry/segment_distance.h>

#include "support/random_world.h"
#include "support/small_world.h"

namespace taut {
namespace {

using test::box_ring;
using test::SmallWorld;

constexpr double kRounding = 1e-12;  // of distances in worlds of this size

/// The distance of p from a site and from all constraints differ by no more than the errors of the edge's ends.
double slack(const VoronoiRoadmap& map, const VoronoiEdge& e) {
  return kRounding + 4 * std::max(map.vertices()[e.from].error, map.vertices()[e.to].error);
}

/// What is wrong with the diagram, by the triangulation; empty when nothing is.
std::string fault(const VoronoiRoadmap& map) {
  const FreeSpace& space = map.space();
  if (!(map.max_error() < 1e-9)) return fmt::format("error {}", map.max_error());
  for (const VoronoiVertex& v : map.vertices()) {
    if (space.locate(v.at).kind == Location::Kind::outside && v.clearance_squared > 1e-18)
      return "vertex outside at " + test::show(v.at);
    if (space.locate(v.at).kind == Location::Kind::outside) continue;
    if (std::abs(space.clearance(v.at).distance - std::sqrt(v.clearance_squared)) > v.error + kRounding)
      return "clearance of vertex at " + test::show(v.at);
  }
  for (const VoronoiEdge& e : map.edges()) {
    for (int i = 1; i < 8; ++i) {
      const Bezier c = map.curve(e);
      const double t = i / 8.0, s = 1 - t;
      const Point p{s * s * c.from.x + 2 * s * t * c.control.x + t * t * c.to.x,
                    s * s * c.from.y + 2 * s * t * c.control.y + t * t * c.to.y};
      if (space.locate(p).kind == Location::Kind::outside) {
        if (segment_distance({p, p}, map.segment(e.sites[0])) < slack(map, e)) continue;  // rounded
        return "edge outside at " + test::show(p);
      }
      const double clearance = space.clearance(p).distance;
      if (clearance < e.clearance - slack(map, e)) return "clearance of edge at " + test::show(p);
      for (const std::uint32_t s2 : e.sites) {
        const Segment site = map.segment(s2);
        if (std::abs(segment_distance({p, p}, site) - clearance) > slack(map, e))
          return "sites of edge at " + test::show(p);
      }
    }
  }
  return {};
}

TEST(Voronoi, OfASquareRoomIsItsDiagonals) {
  const VoronoiRoadmap map(SmallWorld{}.space());
  EXPECT_EQ(fault(map), "");
  ASSERT_EQ(map.edges().size(), 4u);  // the five points are unmistakable here
  const auto& middle = map.vertices()[2];
  EXPECT_EQ(middle.at, (Point{5, 5}));
  EXPECT_EQ(middle.clearance_squared, 25);
  for (const VoronoiEdge& e : map.edges()) {
    EXPECT_EQ(e.kind, VoronoiEdge::Kind::line);
    EXPECT_EQ(e.gate, VoronoiEdge::Gate::none);
    EXPECT_EQ(e.clearance, 0);
    EXPECT_NEAR(e.length, 5 * std::sqrt(2), 1e-14);
  }
}

TEST(Voronoi, OfACorridorRunsAlongItsMiddleWithHalfItsWidth) {
  const VoronoiRoadmap map(SmallWorld{.walls = {}, .solids = {}, .area = box_ring(0, 0, 10, 3)}.space());
  EXPECT_EQ(fault(map), "");
  const auto along = std::find_if(map.edges().begin(), map.edges().end(),
                                  [](const VoronoiEdge& e) { return e.gate == VoronoiEdge::Gate::parallel; });
  ASSERT_NE(along, map.edges().end());
  EXPECT_EQ(map.vertices()[along->from].at, (Point{1.5, 1.5}));
  EXPECT_EQ(map.vertices()[along->to].at, (Point{8.5, 1.5}));
  EXPECT_EQ(along->clearance, 1.5);
  EXPECT_EQ(along->length, 7);
}

TEST(Voronoi, BendsAroundTheEndOfAWallInAParabola) {
  // A wall ends 2 above the floor of a wide room: the arc between its end and the floor.
  const VoronoiRoadmap map(SmallWorld{.walls = {{{5, 10}, {5, 2}}}, .solids = {}}.space());
  EXPECT_EQ(fault(map), "");
  int arcs = 0;
  for (const VoronoiEdge& e : map.edges()) {
    if (e.kind != VoronoiEdge::Kind::parabola || e.gate != VoronoiEdge::Gate::foot) continue;
    ++arcs;
    EXPECT_EQ(e.clearance, 1);
    const auto posts = map.posts(e);
    EXPECT_EQ(std::min(posts[0], posts[1]), (Point{5, 0}));
    EXPECT_EQ(std::max(posts[0], posts[1]), (Point{5, 2}));
    // y = 1 + (x - 5)^2 / 4, over x - 5 = -h .. h with the same h on both sides.
    const double h = map.vertices()[e.to].at.x - 5;
    EXPECT_NEAR(e.length, h * std::hypot(1, h / 2) + 2 * std::asinh(h / 2), 1e-12);
  }
  EXPECT_EQ(arcs, 1);
}

TEST(Voronoi, LeavesOutWhatLiesInBlocks) {
  const VoronoiRoadmap map(SmallWorld{.walls = {}, .solids = {box_ring(2, 2, 8, 8)}}.space());
  EXPECT_EQ(fault(map), "");
  for (const VoronoiVertex& v : map.vertices()) EXPECT_LE(v.clearance_squared, 4);
}

/// Found by the gates (tests/search/clearance_agreement_test.cpp): doubles have no answer for the vertex of three
/// nearly parallel sites.
TEST(Voronoi, KnowsVerticesBesideWallsThatRoundingLeftNearlyParallel) {
  const VoronoiRoadmap map(SmallWorld{.walls = {{{6, 5}, {2, 3}}, {{0, 0}, {2, 4}}, {{5, 5}, {6, 0}}},
                                      .solids = {{{5, 0}, {2, 1}, {2, 0}}, box_ring(4, 5, 5, 6)},
                                      .area = box_ring(0, 0, 6, 6)}
                               .space());
  EXPECT_EQ(fault(map), "");
  for (const VoronoiVertex& v : map.vertices()) EXPECT_TRUE(v.at != (Point{0, 0}) || map.edges_at(0).size() == 1);
}

TEST(Voronoi, JoinsAPointStraightAwayFromItsNearestWall) {
  const VoronoiRoadmap map(SmallWorld{.walls = {}, .solids = {}, .area = box_ring(0, 0, 10, 3)}.space());
  const auto in_the_middle = map.join({4, 1});
  ASSERT_EQ(in_the_middle.size(), 1u);
  EXPECT_EQ(in_the_middle[0].at, (Point{4, 1.5}));
  const auto near_the_corner = map.join({0.25, 1});
  ASSERT_EQ(near_the_corner.size(), 1u);
  EXPECT_EQ(near_the_corner[0].at, (Point{1, 1}));
}

TEST(Voronoi, JoinsAPointOnAWallOnBothSides) {
  const VoronoiRoadmap map(SmallWorld{.walls = {{{5, 0}, {5, 9}}}, .solids = {}}.space());
  EXPECT_EQ(map.join({5, 4}).size(), 2u);
  EXPECT_EQ(map.join({0, 4}).size(), 1u);
}

TEST(Voronoi, OrdersGatesExactly) {
  const VoronoiRoadmap map(SmallWorld{
      .walls = {{{3, 0}, {3, 4}}, {{3, 5}, {3, 10}}, {{7, 0}, {7, 4}}, {{7, 6}, {7, 10}}},
      .solids = {}}.space());
  EXPECT_EQ(map.first_rank(0), 0u);
  EXPECT_EQ(map.first_rank(0.5), 0u);
  EXPECT_GT(map.first_rank(std::nextafter(0.5, 1)), 0u);
  EXPECT_EQ(map.first_rank(0.75), map.first_rank(1));
}

TEST(Voronoi, IsTheSameEveryTime) {
  const FreeSpace space(world_of(std::make_shared<GridMaze>(generate_backtracker(9, 9, 3))));
  const VoronoiRoadmap one(space), other(space);
  ASSERT_EQ(one.edges().size(), other.edges().size());
  for (std::size_t i = 0; i < one.vertices().size(); ++i) EXPECT_EQ(one.vertices()[i].at, other.vertices()[i].at);
}

TEST(Voronoi, HoldsInGridMazesHoweverManyWallsAreOpen) {
  for (const double opened : {0.0, 0.2, 0.5, 0.8, 1.0}) {
    auto grid = std::make_shared<GridMaze>(generate_backtracker(8, 8, 5));
    open_walls(*grid, opened, 5);
    EXPECT_EQ(fault(VoronoiRoadmap(FreeSpace(world_of(grid)))), "") << opened;
  }
}

RC_GTEST_PROP(Voronoi, HoldsInMessyWorlds, ()) {
  const SmallWorld world = test::any_world();
  RC_LOG() << test::show(world);
  RC_ASSERT(fault(VoronoiRoadmap(world.space())) == "");
}

RC_GTEST_PROP(Voronoi, HoldsInMessyRightAngledWorlds, ()) {
  const SmallWorld world = test::any_world({.walls = 20, .straight = true});
  RC_LOG() << test::show(world);
  RC_ASSERT(fault(VoronoiRoadmap(world.space())) == "");
}

/// The leg from p to where it comes to the diagram: how much clearance grows on it, less its length.
double growth_beyond_way(const FreeSpace& space, Point p) {
  const std::vector<VoronoiJunction> junctions = VoronoiRoadmap(space).join(p);
  if (junctions.size() != 1) return HUGE_VAL;
  const Point at = junctions.front().at;
  return space.clearance(at).distance - space.clearance(p).distance - std::hypot(at.x - p.x, at.y - p.y);
}

TEST(Voronoi, JoinsAPointStraightOffAJointAtTheFarEndOfTheEdgeThere) {
  const SmallWorld world{{{{0, 6}, {6, 0}}, {{5, 5}, {4, 1}}}, {{{0, 0}, {5, 1}, {0, 1}}}, box_ring(0, 0, 6, 6), 0};
  EXPECT_NEAR(growth_beyond_way(world.space(), {5.375, 1.375}), 0, 1e-12);
}

TEST(Voronoi, FindsTheVertexOfTwoPointsAndAPieceThatIsParallelUpToRounding) {
  const SmallWorld world{{{{1, 2}, {0, 1}}, {{3, 2}, {1, 3}}, {{3, 5}, {0, 1}}},
                         {{{0, 2}, {1, 2}, {1, 3}, {0, 3}}, {{3, 0}, {4, 0}, {3, 1}}},
                         box_ring(0, 0, 6, 6),
                         0};
  const FreeSpace space = world.space();
  const VoronoiRoadmap map(space);
  for (const VoronoiVertex& v : map.vertices()) EXPECT_LT(std::hypot(v.at.x, v.at.y), 9);
  EXPECT_NEAR(growth_beyond_way(space, {1.75, 1.375}), 0, 1e-12);
}

/// On the way from any free point straight to its junction, clearance grows as fast as the way does.
RC_GTEST_PROP(Voronoi, JoinsEveryPointByAWayOfGrowingClearance, ()) {
  const SmallWorld world = test::any_world();
  RC_LOG() << test::show(world);
  const FreeSpace space = world.space();
  const VoronoiRoadmap map(space);
  for (int i = 0; i < 10; ++i) {
    const Point p{test::any(0, 48) / 8.0, test::any(0, 48) / 8.0};
    if (space.locate(p).kind == Location::Kind::outside) continue;
    const double clearance = space.clearance(p).distance;
    const auto junctions = map.join(p);
    RC_LOG() << " from " << test::show(p);
    RC_ASSERT(!junctions.empty());
    for (const VoronoiJunction& j : junctions) {
      const double way = std::hypot(j.at.x - p.x, j.at.y - p.y);
      if (space.locate(j.at).kind == Location::Kind::outside) continue;  // a corner, rounded
      RC_ASSERT(std::abs(space.clearance(j.at).distance - clearance - way) < 1e-9);
      RC_ASSERT(way < 1e-9 || space.sees(p, j.at));
    }
  }
}

}  // namespace
}  // namespace taut
