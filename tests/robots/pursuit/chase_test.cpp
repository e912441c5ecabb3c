#include <taut/robots/pursuit/chase.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include <taut/io/worlds/read_chase_map.h>
#include <taut/io/worlds/read_world.h>
#include <taut/robots/pursuit/chase_generator.h>
#include <taut/robots/pursuit/entry_planner.h>
#include <taut/robots/pursuit/exact_planner.h>

#include "robots/pursuit/full_programme.h"
#include "support/paths.h"

namespace taut::pursuit {
namespace {

ChaseMap line_map(const std::string& target, const std::string& costs = "1,1,1,1,1,1") {
  return read_chase_map("N 1,6 C 100 R 1,1 T " + target + " M " + costs);
}

/// Says what it goes to, and lets the clock run as long as it is told to think.
struct Script {
  const ChaseMap& map;
  std::vector<int> to;
  std::vector<double> thought = {};
  double now = 0;
  std::size_t at = 0;

  ChaseResult play_it(Clock clock, bool free_planning) {
    const ChaseRules rules{clock, free_planning, [this] { return now; }};
    return play(map, rules, [this](CellIndex, int) -> std::optional<CellIndex> {
      if (at == to.size()) return std::nullopt;
      now += at < thought.size() ? thought[at] : 0;
      return map.index({1, to[at++]});
    });
  }
};

TEST(Chase, CountsWhatTheCellThatIsLeftCosts) {
  const ChaseMap map = line_map("1,6 1,5 1,5 1,3", "7,2,9,9,9,9");
  const ChaseResult result = Script{map, {1, 2, 3}}.play_it(Clock::zero, false);
  EXPECT_EQ(result.end, ChaseEnd::caught);
  EXPECT_EQ(result.time, 3);
  EXPECT_EQ(result.moves, 2);
  EXPECT_EQ(result.cost, 7 + 7 + 2);
}

TEST(Chase, ComparesWithTheEntryOfItsClock) {
  const ChaseMap map = line_map("1,6 1,2 1,3 1,6");
  EXPECT_EQ((Script{map, {2, 3}}.play_it(Clock::zero, false).time), 1);
  EXPECT_EQ((Script{map, {2, 2}}.play_it(Clock::one, false).time), 2);
}

TEST(Chase, EndsWithTheTrajectory) {
  const ChaseMap map = line_map("1,6 1,6 1,6");
  const ChaseResult zero = Script{map, {1, 1, 1, 1, 1}}.play_it(Clock::zero, false);
  EXPECT_EQ(zero.end, ChaseEnd::escaped);
  EXPECT_EQ(zero.time, 2);
  EXPECT_EQ((Script{map, {1, 1, 1, 1, 1}}.play_it(Clock::one, false).time), 3);
}

TEST(Chase, ChargesThinkingInWholeSeconds) {
  const ChaseMap map = line_map("1,6 1,6 1,6 1,2 1,6 1,6", "5,1,1,1,1,1");
  const ChaseResult charged = Script{map, {2}, {2.25}}.play_it(Clock::zero, false);
  EXPECT_EQ(charged.end, ChaseEnd::caught);
  EXPECT_EQ(charged.time, 3);
  EXPECT_EQ(charged.cost, 15);
  EXPECT_EQ(charged.first_thought, 2.25);
  EXPECT_EQ((Script{map, {2}, {1.0}}.play_it(Clock::zero, false).cost), 5);
  EXPECT_EQ((Script{map, {2}, {1e30}}.play_it(Clock::zero, false).end), ChaseEnd::escaped);
  const ChaseResult free = Script{map, {2}, {2.25}}.play_it(Clock::zero, true);
  EXPECT_EQ(free.time, 1);
  EXPECT_EQ(free.cost, 5);
}

TEST(Chase, NamesAnIllegalMove) {
  const ChaseMap map = line_map("1,6 1,6 1,6 1,6", "1,1,1,100,1,1");
  EXPECT_EQ((Script{map, {2, 5}}.play_it(Clock::zero, false).reason),
            "the move from (1,2) to (1,5) is no step to a neighbour, at second 1");
  EXPECT_EQ((Script{map, {2, 3, 4}}.play_it(Clock::zero, false).reason),
            "the move from (1,3) to (1,4) ends in an obstacle, at second 2");
  const ChaseResult out = Script{map, {0}}.play_it(Clock::zero, false);
  EXPECT_EQ(out.end, ChaseEnd::illegal);
  EXPECT_EQ(out.reason, "the move from (1,1) leaves the map, at second 0");
  EXPECT_EQ(out.cost, 0);
}

// The plan waits two seconds in its third cell. Three seconds of thinking use them up, four are too many.
TEST(Follower, GivesUpWaitingWhenItIsLateAndPlansAgainWhenThatIsNotEnough) {
  const auto caught_at = [](double thought, int& plans) {
    const ChaseMap map = line_map("1,6 1,6 1,6 1,6 1,6 1,4 1,4 1,5 1,6", "3,3,1,1,1,1");
    double now = 0;
    Follower follower(map, Clock::zero, [&](const Chase& chase, const PlanLimits& limits, PlanEffort* effort) {
      if (plans++ == 0) now += thought;
      return chase_planner("exact")->plan(chase, limits, effort);
    });
    const ChaseResult result =
        play(map, {Clock::zero, false, [&] { return now; }}, [&](CellIndex at, int s) { return follower.next(at, s); });
    EXPECT_EQ(result.end, ChaseEnd::caught);
    EXPECT_EQ(plans, follower.plans());
    return result.time;
  };
  int in_time = 0, late = 0, later = 0;
  EXPECT_EQ(caught_at(0, in_time), 5);
  EXPECT_EQ(in_time, 1);
  EXPECT_EQ(caught_at(2.5, late), 5);
  EXPECT_EQ(late, 1);
  EXPECT_EQ(caught_at(3.5, later), 6);
  EXPECT_EQ(later, 2);
}

/// Two rows: a way of cost 9 and, below, one of cost 1. The target waits at the far end.
struct ThoughtAhead {
  double first = 0.9, ahead = 1.5;  // seconds
  std::size_t plans = 0;
  double seconds_ahead = 0;

  ChaseResult play_it() {
    const std::string rest = ",9,9,9,9,9,9,9,9,9\n1,1,1,1,1,1,1,1,1,1",
                      still = "1,10 1,10 1,10 1,10 1,10 1,10 1,10 1,10 1,10 ";
    const ChaseMap map = read_chase_map("N 2,10 C 100 R 1,1 T 2,10 " + still + "1,10 1,10 M 9" + rest);
    double now = 0;
    const auto planner = [&](const Chase& chase, const PlanLimits& limits, PlanEffort* effort) {
      now += plans == 0 ? first : ahead;
      ChasePlan plan = exact_plan(chase, limits, effort);
      if (plans++ > 0) return plan;
      plan.cells.clear();
      for (int y = 1; y <= 10; ++y) plan.cells.push_back(map.index({1, y}));
      plan.cost = 81;
      plan.optimal = false;
      return plan;
    };
    Follower follower(map, Clock::zero, planner, {.seconds = 0.9}, [&] { return now; });
    const ChaseResult result = play(map, {Clock::zero, false, [&] { return now - follower.seconds_ahead(); }},
                                    [&](CellIndex at, int s) { return follower.next(at, s); });
    seconds_ahead = follower.seconds_ahead();
    return result;
  }
};

TEST(Follower, ChangesToABetterPlanThatItMadeWhileItMoved) {
  ThoughtAhead chase;
  const ChaseResult result = chase.play_it();
  EXPECT_EQ(result.end, ChaseEnd::caught);
  EXPECT_EQ(result.time, 9);
  EXPECT_EQ(result.cost, 9 + 9 + 9 + 6 * 1);  // two steps along the dear way, a third to leave it
  EXPECT_EQ(chase.plans, 2U);
  EXPECT_EQ(chase.seconds_ahead, 1.5);
}

TEST(Follower, DoesNotUseAPlanBeforeItIsReady) {
  ThoughtAhead late{.ahead = 2.5}, later{.ahead = 6.5};
  EXPECT_EQ(late.play_it().cost, 7 * 9 + 9 + 1);  // the one for two seconds on comes too late, the next does not
  EXPECT_EQ(later.play_it().cost, 81);
}

// Four seconds of planning, each time: the second plan is one for the second at which it is ready.
TEST(Follower, AllowsForSlowPlanningWhenItHasToPlanAgain) {
  const ChaseMap map =
      line_map("1,6 1,6 1,6 1,6 1,6 1,6 1,6 1,6 1,6 1,6 1,6 1,6 1,6 1,6 1,6 1,6 1,6 1,6", "3,3,1,1,1,1");
  double now = 0;
  int plans = 0;
  Follower follower(
      map, Clock::zero,
      [&](Chase chase, const PlanLimits& limits, PlanEffort* effort) {
        if (plans == 0) std::erase_if(chase.meetings, [](const Meeting& m) { return m.second > 5; });
        if (++plans <= 2) now += 4;
        return exact_plan(chase, limits, effort);
      },
      {}, [&] { return now; });
  const ChaseResult result =
      play(map, {Clock::zero, false, [&] { return now; }}, [&](CellIndex at, int s) { return follower.next(at, s); });
  EXPECT_EQ(result.end, ChaseEnd::caught);
  EXPECT_EQ(plans, 2);
}

TEST(EntryPlan, IsLegalAndNeverCheaperThanTheOptimum) {
  int found = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const ChaseMap map = generate_chase_map(
        {.x_size = 24, .y_size = 18, .seconds = 40, .costly = seed % 2 == 0, .buildings = 0.3, .seed = seed});
    for (const Clock clock : {Clock::zero, Clock::one}) {
      const Chase chase = chase_of(map, clock);
      const auto least = test::least_cost(map, clock);
      for (const std::uint32_t weight : {1U, 3U}) {
        const ChasePlan plan = entry_plan(chase, weight);
        ASSERT_EQ(verify_plan(plan, chase), "") << seed;
        ASSERT_FALSE(plan.status == SearchStatus::none && least) << seed;
        if (plan.status != SearchStatus::found) continue;
        ++found;
        ASSERT_GE(plan.cost, *least) << seed;
        EXPECT_FALSE(plan.optimal);
      }
    }
  }
  EXPECT_GT(found, 150);
}

// The one cheap cell is beside the way's middle; waiting is done at the end.
TEST(EntryPlan, WaitsAtTheGoalInsteadOfTheCheapestCell) {
  const ChaseMap map = line_map("1,5 1,5 1,5 1,5 1,5 1,5 1,5 1,5", "9,1,9,9,9,9");
  PlanEffort effort;
  EXPECT_EQ(chase_planner("entry")->plan(chase_of(map, Clock::zero), {}, &effort).cost, 9 + 1 + 9 + 9);
  EXPECT_GT(effort.labels, 0U);
}

TEST(EntryPlan, TakesTheWayOfLeastCostWhenThereAreTooManyStates) {
  const ChaseMap map = generate_chase_map({.x_size = 40, .y_size = 40, .seconds = 80, .costly = true, .seed = 5});
  const Chase chase = chase_of(map, Clock::zero);
  PlanLimits limits;
  limits.most_labels = 1;
  const ChasePlan plan = entry_plan(chase, 1, limits);
  ASSERT_EQ(plan.status, SearchStatus::found);
  EXPECT_EQ(verify_plan(plan, chase), "");
}

struct Published {
  std::filesystem::path file;
  Cost zero, one;          // optima
  Cost entry = 1'000'000;  // the most that the planner `entry` may pay
};

std::vector<Published> published() {
  std::vector<Published> all{{test::data_dir() / "town_60x40.chase", 71, 72}};
  if (const auto shared = test::shared_data_dir())
    for (const Published& p : {Published{"map3.txt.gz", 241, 240, 244}, Published{"map4.txt.gz", 375, 376, 380},
                               Published{"map5.txt", 1063, 1015}, Published{"map12.txt.gz", 101, 102}})
      all.push_back({*shared / "pursuit" / p.file, p.zero, p.one, p.entry});
  return all;
}

TEST(Chase, CatchesTheTargetsOfFilesAtLeastCostAndByEntryAsCheaplyAsPublished) {
  for (const Published& p : published()) {
    SCOPED_TRACE(p.file);
    const ChaseMap map = read_chase_map(read_bytes(p.file.string()), p.file.string());
    for (const Clock clock : {Clock::zero, Clock::one})
      for (const NamedPlanner& planner : chase_planners()) {
        SCOPED_TRACE(planner.name);
        Follower follower(map, clock, planner.plan);
        const ChaseResult result =
            play(map, {clock, true, {}}, [&](CellIndex at, int now) { return follower.next(at, now); });
        const Cost least = clock == Clock::zero ? p.zero : p.one;
        EXPECT_EQ(result.end, ChaseEnd::caught);
        EXPECT_GE(result.cost, least);
        EXPECT_TRUE(planner.name != "exact" || result.cost == least);
        EXPECT_TRUE(planner.name != "entry" || result.cost <= p.entry);
      }
  }
}

}  // namespace
}  // namespace taut::pursuit
