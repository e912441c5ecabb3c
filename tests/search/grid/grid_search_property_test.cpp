// Every search against an independent least cost: Bellman-Ford style relaxation on counts, compared in long double and
// checked by squares.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <vector>

#include <taut/geometry/draws.h>
#include <taut/search/grid/grid_search.h>
#include "support/grid_brute_force.h"

namespace taut::test {
namespace {

std::vector<GridQuery> all_queries(Draws& draws, GridMoves moves) {
  std::vector<GridQuery> queries;
  for (std::size_t i = 0; i < kGridAlgorithms; ++i) {
    const auto algorithm = static_cast<GridAlgorithm>(i);
    if (algorithm == GridAlgorithm::jps && moves == GridMoves::four) continue;
    GridHeuristic h;
    h.members.clear();
    for (std::uint32_t n = 1 + draws.below(2); n > 0; --n)
      h.members.push_back(static_cast<GridEstimate>(draws.below(8)));
    GridQuery q{algorithm, h};
    q.ties = draws.below(2) == 0 ? Ties::fifo : Ties::lifo;
    q.weight = 1000 + draws.below(2000);
    q.max_steps = 100'000;
    queries.push_back(q);
  }
  return queries;
}

class GridSearchProperty : public testing::TestWithParam<GridMoves> {};

TEST_P(GridSearchProperty, FindsWhatBruteForceFindsOnRandomGrids) {
  const GridMoves moves = GetParam();
  Draws draws(20 + static_cast<std::uint64_t>(moves));
  std::size_t found = 0, stopped = 0;
  for (int round = 0; round < 1500; ++round) {
    OccupancyGrid grid = random_grid(draws, 14);
    const GridPlace start = free_place(draws, grid), goal = free_place(draws, grid);
    const auto least = brute_force(grid, moves, start)[goal.row * grid.width + goal.column];
    GridSearch search(grid, moves);
    for (const GridQuery& q : all_queries(draws, moves)) {
      const GridResult r = search.find(start, goal, q);
      const std::string what =
          std::string(name(q.algorithm)) + " " + name(q.heuristic) + ", round " + std::to_string(round);
      if (r.status == SearchStatus::stopped) {
        ASSERT_TRUE(q.algorithm == GridAlgorithm::greedy || q.algorithm == GridAlgorithm::idastar) << what;
        ++stopped;
        continue;
      }
      ASSERT_EQ(r.status == SearchStatus::found, least.has_value()) << what;
      if (!least) continue;
      ++found;
      const GridCost optimum(least->straight, least->diagonal);
      const GridPathVerdict check = verify_grid_path(grid, moves, start, goal, r.path);
      ASSERT_EQ(check.fault, "") << what;
      ASSERT_EQ(check.cost, r.cost) << what;
      ASSERT_GE(r.cost, optimum) << what;
      if (r.optimal) {
        ASSERT_EQ(r.cost, optimum) << what;
      }
      if (q.algorithm == GridAlgorithm::weighted_astar && consistent_everywhere(q.heuristic, moves)) {
        ASSERT_LE(r.cost.value(), optimum.value() * q.weight / 1000 + 1e-6) << what;
      }
    }
  }
  EXPECT_GT(found, 5000U);
  EXPECT_LT(stopped, 100U);
}

TEST_P(GridSearchProperty, CostsFromEveryCellAreThoseOfBruteForce) {
  const GridMoves moves = GetParam();
  Draws draws(77);
  for (int round = 0; round < 300; ++round) {
    OccupancyGrid grid = random_grid(draws, 12);
    const GridPlace goal = free_place(draws, grid);
    const auto brute = brute_force(grid, moves, goal);
    const auto costs = GridSearch(grid, moves).costs_to(goal);
    for (std::size_t i = 0; i < costs.size(); ++i) {
      ASSERT_EQ(costs[i].has_value(), brute[i].has_value());
      if (brute[i]) {
        ASSERT_EQ(*costs[i], GridCost(brute[i]->straight, brute[i]->diagonal));
      }
    }
  }
}

// Larger and sparser than brute force could do.
TEST_P(GridSearchProperty, SearchesAgreeOnLargerGrids) {
  const GridMoves moves = GetParam();
  Draws draws(5);
  for (int round = 0; round < 60; ++round) {
    OccupancyGrid grid = random_grid(draws, 120);
    const GridPlace start = free_place(draws, grid), goal = free_place(draws, grid);
    GridSearch search(grid, moves);
    const GridResult truth = search.find(start, goal, {GridAlgorithm::dijkstra, {}});
    for (const GridAlgorithm a : {GridAlgorithm::astar, GridAlgorithm::bidirectional_astar, GridAlgorithm::jps}) {
      if (a == GridAlgorithm::jps && moves == GridMoves::four) continue;
      const GridResult r = search.find(start, goal, {a, natural_heuristic(moves)});
      ASSERT_EQ(r.status, truth.status) << name(a);
      ASSERT_EQ(r.cost, truth.cost) << name(a);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Moves, GridSearchProperty,
                         testing::Values(GridMoves::four, GridMoves::eight, GridMoves::octile),
                         [](const auto& which) { return "Moves" + std::string(name(which.param)); });

// The order of GridCost against squares, on counts that nearly tie.
TEST(GridCost, AgreesWithSquaresOnRandomCounts) {
  Draws draws(3);
  for (int round = 0; round < 200'000; ++round) {
    const Counts a{draws.below(1'000'000), draws.below(1'000'000)};
    const auto near = static_cast<std::int64_t>(std::uint32_t{draws.below(5)}) - 2;
    Counts b{a.straight + 1393 * near, a.diagonal - 985 * near};  // 1393 / 985 is sqrt(2) to 1e-6
    if (draws.below(2) == 0) b = {draws.below(1'000'000), draws.below(1'000'000)};
    if (b.straight < 0 || b.diagonal < 0) continue;
    const GridCost ka(a.straight, a.diagonal), kb(b.straight, b.diagonal);
    ASSERT_EQ(ka < kb, less(a, b));
    ASSERT_EQ(ka.straight(), a.straight);
    ASSERT_EQ(ka.diagonal(), a.diagonal);
  }
}

}  // namespace
}  // namespace taut::test
