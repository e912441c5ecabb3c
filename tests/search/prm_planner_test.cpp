#include <taut/search/prm_planner.h>

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <taut/geometry/errors.h>
#include <taut/geometry/maze_generator.h>
#include <taut/io/worlds/read_world.h>
#include <taut/search/funnel.h>
#include <taut/search/shortest_path.h>
#include <taut/search/verify.h>

#include "support/paths.h"
#include "support/random_world.h"

namespace taut {
namespace {

using test::any;
using test::any_world;
using test::SmallWorld;

PrmPlan lattice_plan() {
  PrmPlan plan;
  plan.roadmap.sampler = PrmSampler::lattice;
  return plan;
}

/// The length of a lattice path through a maze, once it has passed the check.
std::string lattice_length(const std::filesystem::path& file, std::size_t lattice_points) {
  const World world = read_world_file(file.string());
  const FreeSpace space(world);
  const PrmResult result = prm_path(space, *world.start(), world.goal(), lattice_plan());
  EXPECT_EQ(result.search.status, SearchStatus::found);
  EXPECT_EQ(verify(result.search.path, space, *world.start(), world.goal()).reason, "");
  EXPECT_EQ(result.counts.drawn, lattice_points) << "the integer lattice was enough";
  EXPECT_GE(result.search.path.length, shortest_path(space, *world.start(), world.goal())->length);
  return result.search.path.length.decimals(6);
}

TEST(PrmPath, SolvesASmallMazeOnTheLattice) {
  EXPECT_EQ(lattice_length(test::data_dir() / "maze_5x7.txt", 35), "10.478709");
  if (const auto shared = test::shared_data_dir()) {
    EXPECT_EQ(lattice_length(*shared / "prm" / "maze_5x7_s1.txt", 35), "8.860675");
  }
}

TEST(PrmPath, SolvesALargeMazeOnTheLattice) {
  EXPECT_EQ(lattice_length(test::data_dir() / "maze_45x45.txt", 2025), "116.868897");
  if (const auto shared = test::shared_data_dir()) {
    EXPECT_EQ(lattice_length(*shared / "prm" / "maze_41x41_s1.txt", 1681), "88.442817");
  }
}

TEST(PrmPath, IsFoundByFiveHundredSamplesThatKeepATenthFromTheWalls) {
  std::vector<std::filesystem::path> files{test::data_dir() / "maze_5x7.txt"};
  if (const auto shared = test::shared_data_dir()) files.push_back(*shared / "prm" / "maze_5x7_s1.txt");
  for (const auto& file : files) {
    const World world = read_world_file(file.string());
    const FreeSpace space(world);
    const Roadmap roadmap = prm(space, {.samples = 500, .seed = 1, .clearance = 0.1});
    const GraphQuery query = prm_query(space, roadmap, *world.start(), world.goal(), 0.1);
    const GraphSearchResult result = graph_search(roadmap, query);
    ASSERT_EQ(result.status, SearchStatus::found) << file;
    EXPECT_EQ(verify(result.path, space, *world.start(), world.goal()).reason, "") << file;
  }
}

TEST(PrmPath, IsFoundByUniformSamplesInALargeMaze) {
  const World world = world_of(std::make_shared<GridMaze>(generate_biased_maze(25, 25, 1)));
  const FreeSpace space(world);
  for (const bool lazy : {false, true}) {
    PrmPlan plan;
    plan.lazy = lazy;
    const PrmResult result = prm_path(space, *world.start(), world.goal(), plan);
    ASSERT_EQ(result.search.status, SearchStatus::found);
    EXPECT_EQ(verify(result.search.path, space, *world.start(), world.goal()).reason, "");
    EXPECT_GT(result.coverage, 0);
    EXPECT_LE(result.coverage, 1);
  }
}

// Uniform samples, no lattice.
void expect_all_seeds_to_solve(const World& world, int seeds) {
  const FreeSpace space(world);
  const Length optimum = shortest_path(space, *world.start(), world.goal())->length;
  for (int seed = 1; seed <= seeds; ++seed) {
    PrmPlan plan;
    plan.roadmap.seed = static_cast<std::uint64_t>(seed);
    plan.roadmap.connection.rule = PrmConnection::Rule::visible;
    const PrmResult result = prm_path(space, *world.start(), world.goal(), plan);
    ASSERT_EQ(result.search.status, SearchStatus::found) << "seed " << seed;
    EXPECT_EQ(verify(result.search.path, space, *world.start(), world.goal()).reason, "") << "seed " << seed;
    EXPECT_EQ(shortened(space, result.search.path)->length, optimum) << "seed " << seed;
  }
}

TEST(PrmPath, IsFoundWithTwentyOfTwentySeedsAt41And61) {
  for (const int side : {41, 61})
    expect_all_seeds_to_solve(world_of(std::make_shared<GridMaze>(generate_biased_maze(side, side, 1))), 20);
  if (const auto shared = test::shared_data_dir())
    for (const char* name : {"maze_41x41_s1.txt", "maze_45x45_s1.txt"})
      expect_all_seeds_to_solve(read_world_file((*shared / "prm" / name).string()), 20);
}

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

PrmPlan any_plan() {
  PrmPlan plan;
  plan.roadmap.sampler = PrmSampler(any(0, 6));
  plan.roadmap.samples = static_cast<std::size_t>(any(0, 600));
  plan.roadmap.seed = static_cast<std::uint64_t>(any(0, 1000));
  plan.roadmap.connection.rule = any(0, 1) ? PrmConnection::Rule::nearest : PrmConnection::Rule::star;
  return plan;
}

RC_GTEST_PROP(PrmPath, PassesTheCheckAndIsNeverShorterThanTheShortest, ()) {
  const SmallWorld world = any_world();
  RC_LOG() << test::show(world) << '\n';
  const FreeSpace space = world.space();
  const Ends ends = any_free_ends(space);
  PrmPlan plan = any_plan();
  plan.lazy = any(0, 1);
  plan.roadmap.clearance = any(0, 1) / 8.0;
  const PrmResult result = prm_path(space, ends.from, Goal{ends.to, {}}, plan);
  const auto shortest = shortest_path(space, ends.from, ends.to);
  RC_ASSERT((result.search.status == SearchStatus::none) <= !shortest);
  if (result.search.status != SearchStatus::found) return;
  RC_TAG("found");
  const Verdict verdict = verify(result.search.path, space, ends.from, Goal{ends.to, {}});
  RC_ASSERT(verdict.reason == "");
  RC_ASSERT(result.search.path.length >= shortest->length);
  const bool ends_clear =
      std::min(space.clearance(ends.from).distance, space.clearance(ends.to).distance) >= plan.roadmap.clearance;
  if (ends_clear) RC_ASSERT(verdict.clearance >= plan.roadmap.clearance);
}

RC_GTEST_PROP(PrmPath, IsAsLongWhenEdgesAreTestedLazily, ()) {
  const SmallWorld world = any_world({.walls = 14});
  RC_LOG() << test::show(world) << '\n';
  const FreeSpace space = world.space();
  const Ends ends = any_free_ends(space);
  PrmPlan plan = any_plan();
  if (any(0, 1)) plan.roadmap.sampler = PrmSampler::lattice;  // where many ways are equally long, some of them blocked
  const PrmResult eager = prm_path(space, ends.from, Goal{ends.to, {}}, plan);
  plan.lazy = true;
  const PrmResult lazy = prm_path(space, ends.from, Goal{ends.to, {}}, plan);
  RC_ASSERT(lazy.search.status == eager.search.status);
  RC_ASSERT(lazy.search.path.length == eager.search.path.length);
  RC_ASSERT(lazy.counts.drawn == eager.counts.drawn);
  RC_ASSERT(lazy.counts.edges_tested <= eager.counts.edges_tested);
  if (lazy.search.status == SearchStatus::found)
    RC_ASSERT(verify(lazy.search.path, space, ends.from, Goal{ends.to, {}}).reason == "");
}

TEST(PrmPath, TestsEveryEdgeOfAWayThatTiesWithAnotherOne) {
  // The quick lazy search ends before it has looked at the blocked one of two equally long ways.
  const SmallWorld world{.walls = {{{2, 5}, {4, 2}}, {{5, 2}, {3, 5}}, {{3, 4}, {6, 2}}, {{2, 4}, {0, 0}}},
                         .solids = {},
                         .area = test::box_ring(0, 0, 6, 6)};
  PrmPlan plan = lattice_plan();
  plan.roadmap.connection.rule = PrmConnection::Rule::star;
  plan.roadmap.samples = 37;
  plan.lazy = true;
  const Goal goal{Point{0.25, 4.5}, {}};
  const PrmResult result = prm_path(world.space(), {6, 1}, goal, plan);
  ASSERT_EQ(result.search.status, SearchStatus::found);
  EXPECT_EQ(verify(result.search.path, world.space(), {6, 1}, goal).reason, "");
}

const SmallWorld kSlit{.walls = {{{5, 0}, {5, 4.9}}, {{5, 5.1}, {5, 10}}}, .solids = {}};

TEST(PrmPath, IsProvenAbsentWhenTheGoalIsSealed) {
  const SmallWorld sealed{.walls = {{{5, 0}, {5, 10}}}, .solids = {}};
  const PrmResult result = prm_path(sealed.space(), {2, 2}, Goal{Point{8, 2}, {}});
  EXPECT_EQ(result.search.status, SearchStatus::none);
  EXPECT_EQ(result.counts.drawn, 0u);
}

TEST(PrmPath, StopsWhenTheSamplesAreUsedUp) {
  PrmPlan plan;
  plan.roadmap.clearance = 0.2;  // the slit is too narrow
  plan.roadmap.samples = 1000;
  for (plan.lazy = false;; plan.lazy = true) {
    const PrmResult result = prm_path(kSlit.space(), {2, 2}, Goal{Point{8, 2}, {}}, plan);
    EXPECT_EQ(result.search.status, SearchStatus::stopped);
    EXPECT_TRUE(result.search.path.points.empty());
    EXPECT_EQ(result.counts.drawn, 1000u);
    if (plan.lazy) break;
  }
}

TEST(PrmPath, StopsWhenTheTimeIsUp) {
  PrmPlan plan;
  plan.roadmap.clearance = 0.2;
  plan.seconds = 0.01;
  EXPECT_EQ(prm_path(kSlit.space(), {2, 2}, Goal{Point{8, 2}, {}}, plan).search.status, SearchStatus::stopped);
}

TEST(PrmPath, StopsWhenItsWatcherSaysSo) {
  PrmPlan plan;
  plan.roadmap.clearance = 0.2;
  std::vector<std::size_t> drawn;
  plan.progress = [&](const PrmProgress& progress) {
    drawn.push_back(progress.counts.drawn);
    return drawn.size() < 3;
  };
  const PrmResult result = prm_path(kSlit.space(), {2, 2}, Goal{Point{8, 2}, {}}, plan);
  EXPECT_EQ(result.search.status, SearchStatus::stopped);
  EXPECT_EQ(drawn, (std::vector<std::size_t>{64, 128, 192}));
}

TEST(PrmPath, RefinesTheLatticeUntilItFitsThroughASlit) {
  PrmPlan plan = lattice_plan();
  plan.roadmap.clearance = 0.09;
  plan.roadmap.lattice = PrmLattice{{0.5, 0.5}, 1};
  const PrmResult result = prm_path(kSlit.space(), {2, 2}, Goal{Point{8, 2}, {}}, plan);
  ASSERT_EQ(result.search.status, SearchStatus::found);
  EXPECT_GE(verify(result.search.path, kSlit.space(), {2, 2}, Goal{Point{8, 2}, {}}).clearance, 0.09);
  EXPECT_GT(result.counts.drawn, 100u);
}

TEST(PrmPath, GoesStraightWhenTheEndsSeeEachOther) {
  for (const bool lazy : {false, true}) {
    PrmPlan plan;
    plan.lazy = lazy;
    const PrmResult result = prm_path(kSlit.space(), {2, 5}, Goal{Point{8, 5}, {}}, plan);
    EXPECT_EQ(result.search.path.length.decimals(0), "6");
    EXPECT_EQ(result.counts.drawn, 0u);
  }
}

TEST(PrmPath, EndsInARoom) {
  GridMaze maze = generate_backtracker(9, 9, 1);
  open_centre_room(maze);
  const World world = world_of(std::make_shared<GridMaze>(maze));
  const FreeSpace space(world);
  const PrmResult result = prm_path(space, *world.start(), world.goal());
  ASSERT_EQ(result.search.status, SearchStatus::found);
  EXPECT_EQ(verify(result.search.path, space, *world.start(), world.goal()).reason, "");
  EXPECT_EQ(prm_path(space, {4.25, 4.25}, world.goal()).search.path.points.size(), 1u) << "it starts in the room";
}

TEST(PrmPath, RefusesEndsInObstacles) {
  const SmallWorld world{.walls = {}, .solids = {test::box_ring(4, 4, 6, 6)}};
  EXPECT_THROW(prm_path(world.space(), {5, 5}, Goal{Point{8, 2}, {}}), InputError);
  EXPECT_THROW(prm_path(world.space(), {2, 2}, Goal{Point{12, 2}, {}}), InputError);
}

}  // namespace
}  // namespace taut
