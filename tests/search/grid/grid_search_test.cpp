#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <vector>

#include <taut/geometry/errors.h>
#include <taut/search/grid/grid_search.h>
#include "support/grid_drawing.h"

namespace taut::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

GridQuery query(GridAlgorithm algorithm, GridMoves moves = GridMoves::four) {
  GridQuery q{algorithm, natural_heuristic(moves)};
  q.record = true;
  return q;
}

GridResult found(const DrawnGrid& d, GridQuery q, GridMoves moves = GridMoves::four) {
  return GridSearch(d.grid, moves).find(d.start, d.goal, q);
}

const std::vector<GridAlgorithm>& all_algorithms() {
  static const std::vector<GridAlgorithm> all = [] {
    std::vector<GridAlgorithm> list;
    for (std::size_t i = 0; i < kGridAlgorithms; ++i) list.push_back(static_cast<GridAlgorithm>(i));
    return list;
  }();
  return all;
}

// By hand: 4 x 3 with a wall whose gap is at the bottom.
const DrawnGrid kBend = drawn({"S.#G",  //
                               "..#.",  //
                               "...."});

TEST(GridSearch, TakesCellsInTheOrderOfItsFrontier) {
  using P = GridPlace;
  EXPECT_THAT(found(kBend, query(GridAlgorithm::bfs)).visited,
              ElementsAre(P{0, 0}, P{0, 1}, P{1, 0}, P{1, 1}, P{2, 0}, P{2, 1}, P{2, 2}, P{2, 3}, P{1, 3}, P{0, 3}));
  EXPECT_THAT(found(kBend, query(GridAlgorithm::dfs)).visited,
              ElementsAre(P{0, 0}, P{0, 1}, P{1, 1}, P{2, 1}, P{2, 2}, P{2, 3}, P{1, 3}, P{0, 3}));
}

TEST(GridSearch, FindsTheWayRoundTheBendByEveryAlgorithm) {
  for (const GridAlgorithm a : all_algorithms()) {
    if (a == GridAlgorithm::jps) continue;
    SCOPED_TRACE(name(a));
    const GridResult r = found(kBend, query(a));
    EXPECT_EQ(r.status, SearchStatus::found);
    EXPECT_EQ(r.cost, GridCost(7, 0));
    EXPECT_THAT(r.path, SizeIs(8));
    EXPECT_EQ(verify_grid_path(kBend.grid, GridMoves::four, kBend.start, kBend.goal, r.path).fault, "");
  }
}

TEST(GridSearch, ProvesThatAWallSeparates) {
  const DrawnGrid d = drawn({"S.#.", "..#G", "###."});
  for (const GridAlgorithm a : all_algorithms())
    for (const GridMoves moves : {GridMoves::four, GridMoves::octile, GridMoves::eight}) {
      if (a == GridAlgorithm::jps && moves == GridMoves::four) continue;
      SCOPED_TRACE(name(a));
      const GridResult r = found(d, query(a, moves), moves);
      EXPECT_EQ(r.status, SearchStatus::none);
      EXPECT_THAT(r.path, IsEmpty());
      EXPECT_FALSE(r.optimal);
      EXPECT_TRUE(r.frontier.empty() || a == GridAlgorithm::bidirectional_astar);  // the other side's stays
    }
}

TEST(GridSearch, IsThereAtOnceWhenStartIsGoal) {
  for (const GridAlgorithm a : all_algorithms()) {
    SCOPED_TRACE(name(a));
    const GridResult r = GridSearch(kBend.grid, GridMoves::octile).find({2, 2}, {2, 2}, query(a, GridMoves::octile));
    EXPECT_EQ(r.status, SearchStatus::found);
    EXPECT_THAT(r.path, ElementsAre(GridPlace{2, 2}));
    EXPECT_EQ(r.cost, GridCost());
    EXPECT_LE(r.steps, 1U);
  }
}

// Two blocked cells touch at a corner: between them only the free rule goes; past one of them only the free rule cuts.
TEST(GridSearch, CutsCornersAndSqueezesOnlyByTheFreeRule) {
  const DrawnGrid squeeze = drawn({"S#", "#G"}), corner = drawn({"S#", ".G"});
  for (const GridAlgorithm a : {GridAlgorithm::dijkstra, GridAlgorithm::jps, GridAlgorithm::astar}) {
    EXPECT_EQ(found(squeeze, query(a, GridMoves::eight), GridMoves::eight).cost, GridCost(0, 1));
    EXPECT_EQ(found(squeeze, query(a, GridMoves::octile), GridMoves::octile).status, SearchStatus::none);
    EXPECT_EQ(found(corner, query(a, GridMoves::eight), GridMoves::eight).cost, GridCost(0, 1));
    EXPECT_EQ(found(corner, query(a, GridMoves::octile), GridMoves::octile).cost, GridCost(2, 0));
  }
}

TEST(GridSearch, PrefersTheNewestOrTheOldestAmongEquals) {
  const DrawnGrid d = drawn({"S....", ".....", ".....", "....G"});
  GridQuery q = query(GridAlgorithm::astar);
  EXPECT_EQ(found(d, q).steps, 20U);  // every cell has f = 7
  q.ties = Ties::lifo;
  EXPECT_EQ(found(d, q).steps, 8U);
}

TEST(GridSearch, StopsWhenItsStepsAreUsedUp) {
  for (const GridAlgorithm a : all_algorithms()) {
    if (a == GridAlgorithm::jps) continue;
    SCOPED_TRACE(name(a));
    GridQuery q = query(a);
    q.max_steps = 4;
    const GridResult r = found(kBend, q);
    EXPECT_EQ(r.status, SearchStatus::stopped);
    EXPECT_EQ(r.steps, 4U);
    EXPECT_THAT(r.path, IsEmpty());
  }
}

TEST(GridSearch, EndsDepthFirstSearchOfALongSnakeWithoutRecursion) {
  OccupancyGrid grid{1, 2'000'000, std::vector<std::uint8_t>(2'000'000, 0)};
  const GridResult r = GridSearch(grid, GridMoves::four).find({0, 0}, {1'999'999, 0}, {GridAlgorithm::dfs, {}});
  EXPECT_EQ(r.steps, 2'000'000U);
}

TEST(GridSearch, SaysWhatIsWrongWithItsEnds) {
  GridSearch search(kBend.grid, GridMoves::four);
  EXPECT_THROW(search.find({0, 2}, {0, 0}, {}), InputError);
  EXPECT_THROW(search.find({0, 0}, {0, 4}, {}), InputError);
  EXPECT_THROW(search.find({0, 0}, {0, 3}, {GridAlgorithm::jps, {}}), InputError);
  EXPECT_THROW(GridSearch({}, GridMoves::four), InputError);
  EXPECT_THROW(GridSearch({2, 2, {0, 0, 0}}, GridMoves::four), InputError);
}

TEST(GridSearch, NamesAreReadBack) {
  for (const GridAlgorithm a : all_algorithms()) EXPECT_EQ(grid_algorithm_named(name(a)), a);
  for (const GridMoves m : {GridMoves::four, GridMoves::eight, GridMoves::octile})
    EXPECT_EQ(grid_moves_named(name(m)), m);
  EXPECT_FALSE(grid_algorithm_named("a*"));
}

TEST(GridPathVerdict, RefusesWhatIsNoPath) {
  const auto fault = [&](std::vector<GridPlace> path, GridMoves moves) {
    return verify_grid_path(kBend.grid, moves, {0, 0}, {2, 1}, path).fault;
  };
  EXPECT_EQ(fault({{0, 0}, {1, 0}, {2, 0}, {2, 1}}, GridMoves::four), "");
  EXPECT_EQ(fault({{0, 0}, {1, 0}, {2, 1}}, GridMoves::octile), "");
  EXPECT_EQ(fault({}, GridMoves::four), "the path is empty");
  EXPECT_EQ(fault({{0, 0}, {1, 0}, {2, 1}}, GridMoves::four), "(row 1, column 0) to (row 2, column 1) is not a move");
  EXPECT_EQ(fault({{0, 0}, {1, 0}, {1, 0}, {2, 1}}, GridMoves::octile),
            "(row 1, column 0) to (row 1, column 0) is not a move");
  EXPECT_EQ(fault({{0, 1}, {1, 1}, {2, 1}}, GridMoves::four), "the path begins at (row 0, column 1)");
  EXPECT_EQ(fault({{0, 0}, {1, 0}}, GridMoves::four), "the path ends at (row 1, column 0)");
  EXPECT_EQ(fault({{0, 0}, {0, 1}, {0, 2}, {1, 2}, {2, 1}}, GridMoves::eight), "(row 0, column 2) is not free");
}

TEST(GridCost, IsOrderedAsTheNumbersAreAndKeepsItsCounts) {
  EXPECT_LT(GridCost(7, 0), GridCost(0, 5));                      // 7 < 7.0710
  EXPECT_GT(GridCost(17, 0), GridCost(0, 12));                    // 17 > 16.9706
  EXPECT_LT(GridCost(275'807, 0), GridCost(0, 195'025));          // squares differ by 1 in 7.6e10
  EXPECT_LT(GridCost(318'281'039, 0), GridCost(0, 225'058'681));  // squares differ by 1 in 1e17
  const GridCost c(123'456, 98'765);
  EXPECT_EQ(c.straight(), 123'456);
  EXPECT_EQ(c.diagonal(), 98'765);
  EXPECT_EQ(c + GridCost(1, 2), GridCost(123'457, 98'767));
  EXPECT_DOUBLE_EQ(GridCost(2, 1).value(), 3.414213562373095);
}

}  // namespace
}  // namespace taut::test
