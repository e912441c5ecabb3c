// What a PRM does after a path is found, and how its ends are joined.
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <span>

#include <taut/geometry/maze_generator.h>
#include <taut/search/detail/prm_end.h>
#include <taut/search/prm_request.h>
#include <taut/search/shortest_path.h>
#include <taut/search/verify.h>

#include "support/random_world.h"

namespace taut {
namespace {

using test::any;
using test::any_world;
using test::SmallWorld;

struct Ends {
  Point from, to;
};

Ends any_free_ends(const FreeSpace& space) {
  const auto any_quarter_point = [] {
    const int x = any(0, 24), y = any(0, 24);
    return Point{x / 4.0, y / 4.0};
  };
  const Ends ends{any_quarter_point(), any_quarter_point()};
  RC_PRE(space.locate(ends.from).kind != Location::Kind::outside);
  RC_PRE(space.locate(ends.to).kind != Location::Kind::outside);
  return ends;
}

RC_GTEST_PROP(PrmPath, IsNotLongerRefined, ()) {
  const SmallWorld world = any_world({.walls = 14});
  RC_LOG() << test::show(world) << '\n';
  const FreeSpace space = world.space();
  const Ends ends = any_free_ends(space);
  PrmPlan plan;
  plan.roadmap.sampler = PrmSampler(any(0, 6));
  plan.roadmap.seed = static_cast<std::uint64_t>(any(0, 1000));
  plan.roadmap.connection.rule = any(0, 1) ? PrmConnection::Rule::visible : PrmConnection::Rule::star;
  plan.roadmap.samples = static_cast<std::size_t>(any(300, 600));
  plan.lazy = any(0, 1);
  const PrmResult plain = prm_path(space, ends.from, Goal{ends.to, {}}, plan);
  plan.refine = any(1, 8) / 4.0;
  const PrmResult refined = prm_path(space, ends.from, Goal{ends.to, {}}, plan);
  RC_ASSERT(refined.search.status == plain.search.status);
  RC_ASSERT(refined.counts.drawn >= plain.counts.drawn && refined.counts.drawn <= *plan.roadmap.samples);
  if (refined.search.status != SearchStatus::found) return;
  RC_ASSERT(refined.search.path.length <= plain.search.path.length);
  const GraphQuery query = prm_query(space, refined.roadmap, ends.from, Goal{ends.to, {}});
  RC_ASSERT(graph_search(refined.roadmap, query).path.length == refined.search.path.length);
  RC_ASSERT(verify(refined.search.path, space, ends.from, Goal{ends.to, {}}).reason == "");
}

TEST(PrmPath, IsRefinedWithFewSamplesAFarWayShorter) {
  const World world = world_of(std::make_shared<GridMaze>(generate_biased_maze(25, 25, 1)));
  const FreeSpace space(world);
  PrmPlan plan;
  plan.roadmap.connection.rule = PrmConnection::Rule::visible;
  const PrmResult plain = prm_path(space, *world.start(), world.goal(), plan);
  plan.refine = 1;
  const PrmResult refined = prm_path(space, *world.start(), world.goal(), plan);
  EXPECT_EQ(refined.counts.drawn, 2 * plain.counts.drawn);
  EXPECT_LT(refined.counts.kept, 1.5 * static_cast<double>(plain.counts.kept));
  const double optimum = shortest_path(space, *world.start(), world.goal())->length.value();
  EXPECT_LT(refined.search.path.length.value() - optimum, 0.8 * (plain.search.path.length.value() - optimum));
}

RC_GTEST_PROP(PrmEnd, IsJoinedToTheNearestThatItSeesWhileVerticesAreAdded, ()) {
  const SmallWorld world = any_world({.walls = 14});
  RC_LOG() << test::show(world) << '\n';
  const FreeSpace space = world.space();
  const Point p = any_free_ends(space).from;
  const double clearance = any(0, 2) / 8.0;
  const Roadmap roadmap = prm(space, {.samples = static_cast<std::size_t>(any(0, 120)), .clearance = clearance});
  const PrmClear clear(space, clearance);
  detail::PrmEnd end(clear, p, 8);
  for (std::size_t n = 0; n < roadmap.vertex_count(); n += static_cast<std::size_t>(any(1, 40)))
    end.joined(std::span(roadmap.points()).first(n));
  RC_ASSERT(end.joined(roadmap.points()) == nearest_visible(space, roadmap, p, 8, clearance));
}

TEST(PrmRequest, IsRefinedUnlessItIsALatticeAForestOrSoManySamplesExactly) {
  EXPECT_EQ(plan_of({}, PrmSampler::sobol, 1, true).refine, 1);
  EXPECT_EQ(plan_of({}, PrmSampler::lattice, 1, true).refine, 0);
  EXPECT_EQ(plan_of({.samples = 500, .exactly = true}, PrmSampler::sobol, 1, true).refine, 0);
  EXPECT_EQ(plan_of({.connection = PrmConnection{PrmConnection::Rule::forest}}, PrmSampler::sobol, 1, true).refine, 0);
}

}  // namespace
}  // namespace taut
