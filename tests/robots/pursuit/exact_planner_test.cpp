#include <taut/robots/pursuit/exact_planner.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include <taut/geometry/draws.h>
#include <taut/io/worlds/read_chase_map.h>
#include <taut/io/worlds/read_world.h>
#include <taut/robots/pursuit/chase_generator.h>
#include <taut/robots/pursuit/detail/reduced.h>

#include "robots/pursuit/full_programme.h"
#include "support/paths.h"

namespace taut::pursuit {
namespace {

using taut::Draws;
using taut::test::least_cost;

/// Few cells, many seconds or few, costs of a kind that makes one part of the method or the other matter.
ChaseMap random_map(Draws& draws) {
  const auto any = [&](int lo, int hi) {
    return lo + static_cast<int>(draws.below(static_cast<std::uint32_t>(hi - lo + 1)));
  };
  ChaseMap::Parts parts;
  parts.x_size = any(1, 12);
  parts.y_size = any(1, 12);
  const int kind = any(0, 5), walls = any(0, 40), dearest = any(1, 3) == 1 ? 1000 : any(2, 60);
  for (int i = 0; i < parts.x_size * parts.y_size; ++i) {
    const int cost = kind == 0   ? 1
                     : kind == 1 ? any(0, 1) * dearest
                     : kind == 2 ? (any(0, 3) ? dearest : any(0, 5))
                                 : any(kind == 3, dearest);
    parts.costs.push_back(any(0, 99) < walls ? ChaseMap::kObstacle : static_cast<std::uint32_t>(cost));
  }
  const auto place = [&] {
    const int x = any(1, parts.x_size);
    return Cell{x, any(1, parts.y_size)};
  };
  parts.start = place();
  std::uint32_t& here = parts.costs[static_cast<std::size_t>((parts.start.x - 1) * parts.y_size + parts.start.y - 1)];
  if (here == ChaseMap::kObstacle) here = static_cast<std::uint32_t>(dearest);
  parts.target = {place()};
  const int seconds = any(1, any(0, 1) ? 12 : 40), still = any(0, 2);
  while (static_cast<int>(parts.target.size()) < seconds) {
    Cell c = parts.target.back();
    if (still != 0 && any(0, still) != 0)
      c = {std::clamp(c.x + any(-1, 1), 1, parts.x_size), std::clamp(c.y + any(-1, 1), 1, parts.y_size)};
    parts.target.push_back(c);
  }
  return ChaseMap(parts);
}

TEST(ExactPlan, CostsWhatTheFullProgrammeSays) {
  Draws draws(1);
  std::size_t found = 0, labelled = 0;
  for (int i = 0; i < 20'000; ++i) {
    const ChaseMap map = random_map(draws);
    for (const Clock clock : {Clock::zero, Clock::one}) {
      const Chase chase = chase_of(map, clock);
      PlanEffort effort;
      const ChasePlan plan = exact_plan(chase, {}, &effort);
      const auto least = least_cost(map, clock);
      ASSERT_EQ(plan.status == SearchStatus::found, least.has_value()) << chase_map_text(map);
      ASSERT_EQ(verify_plan(plan, chase), "") << chase_map_text(map);
      if (!least) {
        ASSERT_NE(plan.reason, "");
        continue;
      }
      ++found;
      labelled += effort.labels > 0;
      ASSERT_TRUE(plan.optimal);
      ASSERT_EQ(plan.cost, *least) << chase_map_text(map);
    }
  }
  EXPECT_GT(found, 10'000U);
  EXPECT_GT(labelled, 10U);
}

constexpr Cost kDear = 1'000'000'000;

/// The optimum by the search with two criteria alone, one value of the cheapest cell's cost after the other.
Cost least_by_labels(const Chase& chase, Cost u, std::size_t most_labels) {
  detail::Workspace work;
  work.chase = &chase;
  work.steps = detail::neighbour_steps(*chase.map);
  work.bits = static_cast<int>(std::bit_width(static_cast<unsigned>(chase.meetings.back().second))) + 1;
  work.hops = detail::hops_from(*chase.map, chase.from, detail::kNoLimit);
  work.latest = work.latest_for(chase.meetings, 0);
  work.is_target.assign(chase.map->index_count(), 0);
  for (const Meeting& m : chase.meetings) work.is_target[m.cell] = 1;
  std::set<std::uint32_t> values(chase.map->costs().begin(), chase.map->costs().end());
  values.erase(ChaseMap::kObstacle);
  work.choose_parts(*values.rbegin());
  Cost least = kDear;
  for (const std::uint32_t value : values) {
    if (value > chase.map->cost(chase.from)) break;
    detail::Worker worker{work};
    worker.best.cost = kDear;
    EXPECT_TRUE(detail::search_labels(worker, {value, value}, chase.meetings, u, most_labels));
    least = std::min(least, worker.upper());
  }
  return least;
}

TEST(LabelSearch, CostsWhatTheFullProgrammeSays) {
  Draws draws(3);
  for (int i = 0; i < 2'000; ++i) {
    const ChaseMap map = random_map(draws);
    const Chase chase = chase_of(map, Clock::one);
    if (chase.meetings.empty()) continue;
    ASSERT_EQ(least_by_labels(chase, -static_cast<Cost>(draws.below(100)), 1'000'000),
              least_cost(map, Clock::one).value_or(kDear))
        << chase_map_text(map);
  }
}

TEST(ExactPlan, BoundsTheOptimumWhenItHasTooFewLabels) {
  Draws draws(2);
  std::size_t unproven = 0;
  for (int i = 0; i < 4'000; ++i) {
    const ChaseMap map = random_map(draws);
    const Chase chase = chase_of(map, Clock::zero);
    PlanLimits limits;
    limits.most_labels = 8;
    const ChasePlan plan = exact_plan(chase, limits);
    const auto least = least_cost(map, Clock::zero);
    ASSERT_EQ(plan.status == SearchStatus::found, least.has_value()) << chase_map_text(map);
    ASSERT_EQ(verify_plan(plan, chase), "") << chase_map_text(map);
    if (!least) continue;
    ASSERT_LE(plan.bound, *least) << chase_map_text(map);
    ASSERT_GE(plan.cost, *least) << chase_map_text(map);
    unproven += !plan.optimal;
  }
  EXPECT_GT(unproven, 0U);
}

struct Published {
  std::filesystem::path file;
  Cost zero, one;
};

TEST(ExactPlan, FindsTheOptimaOfFiles) {
  std::vector<Published> published{{test::data_dir() / "town_60x40.chase", 71, 72}};
  if (const auto shared = test::shared_data_dir())
    for (const Published& p : {Published{"map3.txt.gz", 241, 240}, Published{"map4.txt.gz", 375, 376},
                               Published{"map5.txt", 1063, 1015}, Published{"map12.txt.gz", 101, 102}})
      published.push_back({*shared / "pursuit" / p.file, p.zero, p.one});
  for (const Published& p : published) {
    SCOPED_TRACE(p.file);
    const ChaseMap map = read_chase_map(read_bytes(p.file.string()), p.file.string());
    EXPECT_EQ(exact_plan(chase_of(map, Clock::zero)).cost, p.zero);
    EXPECT_EQ(exact_plan(chase_of(map, Clock::one)).cost, p.one);
  }
}

// The start is dear, one cell aside is cheap, the target comes by late: wait there, not at its cell.
TEST(ExactPlan, WaitsAtTheCheapestCellOnTheWay) {
  const ChaseMap map = read_chase_map("N 1,5 C 100 R 1,1 T 1,5 1,5 1,5 1,5 1,5 1,5 1,5 1,5 1,5 1,4 M 9,1,9,9,100");
  const ChasePlan plan = exact_plan(chase_of(map, Clock::zero));
  ASSERT_EQ(plan.status, SearchStatus::found);
  EXPECT_EQ(plan.cost, 9 + 7 * 1 + 9);
  EXPECT_TRUE(plan.optimal);
}

TEST(ExactPlan, SaysWhyNobodyCanCatchTheTarget) {
  const auto reason = [](const char* text) {
    const ChaseMap map = read_chase_map(text);
    const ChasePlan plan = exact_plan(chase_of(map, Clock::zero));
    EXPECT_EQ(plan.status, SearchStatus::none);
    return plan.reason;
  };
  EXPECT_EQ(reason("N 1,3 C 5 R 1,1 T 1,3 1,3 1,3 M 1,1,9"), "the target is inside obstacles all the time");
  EXPECT_EQ(reason("N 1,3 C 5 R 1,1 T 1,3 1,3 1,3 M 1,9,1"),
            "obstacles separate the target's whole trajectory from the robot");
  EXPECT_EQ(reason("N 1,4 C 5 R 1,1 T 1,4 1,4 1,4 M 1,1,1,1"),
            "the trajectory is too short: the robot comes at least 1 second late to each of its cells");
  EXPECT_EQ(reason("N 1,4 C 5 R 1,1 T 1,1 M 1,1,1,1"),
            "the trajectory is too short: its only entry is where the target begins");
}

TEST(ExactPlan, BoundsWhatItCouldNotFinish) {
  const ChaseMap map =
      generate_chase_map({.x_size = 300, .y_size = 300, .seconds = 600, .costly = true, .buildings = 0.2, .seed = 3});
  const Chase chase = chase_of(map, Clock::zero);
  PlanLimits limits;
  limits.stopped = [] { return true; };
  const ChasePlan plan = exact_plan(chase, limits);
  ASSERT_EQ(plan.status, SearchStatus::found);
  EXPECT_FALSE(plan.optimal);
  EXPECT_EQ(verify_plan(plan, chase), "");
  EXPECT_LE(plan.bound, exact_plan(chase).cost);
}

}  // namespace
}  // namespace taut::pursuit
