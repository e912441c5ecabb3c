// What is said of an estimate on a map, by hand and against brute force in long double.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <vector>

#include <taut/geometry/errors.h>
#include <taut/search/grid/grid_heuristics.h>
#include "support/grid_brute_force.h"
#include "support/grid_drawing.h"

namespace taut::test {
namespace {

constexpr long double kRoot = 1.41421356237309504880168872420969808L;
// On small grids two different values are farther apart than this, and rounding Euclidean lengths to GridCost moves
// them less.
constexpr long double kApart = 1e-7L;

HeuristicVerdict verdict(const DrawnGrid& d, GridMoves moves, std::string_view h) {
  return heuristic_verdict(d.grid, moves, d.goal, *grid_heuristic_named(h));
}

const DrawnGrid kOpen = drawn({"...", "...", "..G"});

TEST(HeuristicVerdict, TrustsManhattanUntilThereAreDiagonals) {
  EXPECT_TRUE(verdict(kOpen, GridMoves::four, "manhattan").admissible());
  EXPECT_TRUE(verdict(kOpen, GridMoves::four, "manhattan").consistent());
  const HeuristicVerdict v = verdict(kOpen, GridMoves::octile, "manhattan");
  ASSERT_TRUE(v.overestimate);
  EXPECT_EQ(v.overestimate->cell, (GridPlace{0, 0}));
  EXPECT_EQ(v.overestimate->estimate, 4);
  EXPECT_EQ(v.overestimate->cost, GridCost(0, 2));
  ASSERT_TRUE(v.violation);
  EXPECT_EQ(v.violation->from, (GridPlace{0, 0}));
  EXPECT_EQ(v.violation->to, (GridPlace{1, 1}));
  EXPECT_EQ(v.violation->cost, GridCost(0, 1));
}

// Walls can make an estimate admissible that is not so on every map.
TEST(HeuristicVerdict, IsAboutThisMapOnly) {
  const DrawnGrid corridor = drawn({"....G"});
  EXPECT_TRUE(verdict(corridor, GridMoves::octile, "manhattan").consistent());
  EXPECT_FALSE(consistent_everywhere(*grid_heuristic_named("manhattan"), GridMoves::octile));
}

// Negative left of the goal and 0 in it; right of it a blocked cell forces a detour that the estimate does not see.
TEST(HeuristicVerdict, TrustsTheBiasedOnesAsWell) {
  const DrawnGrid d = drawn({"..#.", ".G#.", "...."});
  for (const char* h : {"biased-row", "biased-column", "biased-row,biased-column"}) {
    EXPECT_TRUE(verdict(d, GridMoves::four, h).admissible()) << h;
    EXPECT_TRUE(verdict(d, GridMoves::four, h).consistent()) << h;
  }
}

TEST(HeuristicVerdict, LooksOnlyWhereTheGoalCanBeReachedFrom) {
  const DrawnGrid d = drawn({"G.#..", "..#.."});
  EXPECT_EQ(verdict(d, GridMoves::four, "exact").cells, 4U);
  EXPECT_TRUE(verdict(d, GridMoves::four, "exact").consistent());
}

TEST(HeuristicVerdict, RefusesAGoalThatIsNone) {
  EXPECT_THROW(heuristic_verdict(drawn({"#."}).grid, GridMoves::four, {0, 0}, {}), InputError);
  EXPECT_THROW(heuristic_verdict(drawn({"#."}).grid, GridMoves::four, {1, 0}, {}), InputError);
}

long double value(Counts c) {
  return static_cast<long double>(c.straight) + static_cast<long double>(c.diagonal) * kRoot;
}

long double estimate(GridEstimate e, GridPlace p, GridPlace goal, const std::optional<Counts>& cost) {
  const long double dy = static_cast<long double>(p.row) - goal.row,
                    dx = static_cast<long double>(p.column) - goal.column;
  const long double x = std::fabs(dx), y = std::fabs(dy);
  switch (e) {
    case GridEstimate::zero: return 0;
    case GridEstimate::manhattan: return x + y;
    case GridEstimate::euclidean: return std::sqrt(x * x + y * y);
    case GridEstimate::chebyshev: return std::max(x, y);
    case GridEstimate::octile: return std::max(x, y) - std::min(x, y) + kRoot * std::min(x, y);
    case GridEstimate::biased_row: return dy;
    case GridEstimate::biased_column: return dx;
    case GridEstimate::exact: return value(*cost);
  }
  return 0;
}

/// The largest excess and the largest fall of an estimate, and where each is met first.
struct Truth {
  long double excess = 0, fall = 0;
  std::optional<GridPlace> cell, from, to;
};

class Judged {
 public:
  Judged(const OccupancyGrid& g, GridMoves moves, GridPlace goal, const GridHeuristic& heuristic)
      : grid_(g), moves_(moves), goal_(goal), heuristic_(heuristic), cost_(brute_force(g, moves, goal)) {
    if (std::fabs(h(goal)) > kApart) truth_ = {0, std::fabs(h(goal)), {}, goal, goal};
    for (std::uint32_t row = 0; row < g.height; ++row)
      for (std::uint32_t column = 0; column < g.width; ++column)
        if (cost(GridPlace{row, column})) look({row, column});
  }

  const Truth& truth() const { return truth_; }

 private:
  const std::optional<Counts>& cost(GridPlace p) const { return cost_[p.row * grid_.width + p.column]; }

  long double h(GridPlace p) const {
    long double most = estimate(heuristic_.members.front(), p, goal_, cost(p));
    for (const GridEstimate e : heuristic_.members) most = std::max(most, estimate(e, p, goal_, cost(p)));
    return most;
  }

  void look(GridPlace p) {
    if (const long double excess = h(p) - value(*cost(p)); excess > truth_.excess + kApart) {
      truth_.excess = excess;
      truth_.cell = p;
    }
    // In the order of GridMoves.
    constexpr int kMoves[8][2] = {{0, 1}, {1, 0}, {0, -1}, {-1, 0}, {1, 1}, {1, -1}, {-1, -1}, {-1, 1}};
    for (const auto& [dr, dc] : kMoves) {
      if (!may_move(grid_, moves_, static_cast<int>(p.row), static_cast<int>(p.column), dr, dc)) continue;
      const GridPlace n{static_cast<std::uint32_t>(static_cast<int>(p.row) + dr),
                        static_cast<std::uint32_t>(static_cast<int>(p.column) + dc)};
      const long double fall = h(p) - h(n) - (dr != 0 && dc != 0 ? kRoot : 1);
      if (fall <= truth_.fall + kApart) continue;
      truth_.fall = fall;
      truth_.from = p;
      truth_.to = n;
    }
  }

  const OccupancyGrid& grid_;
  GridMoves moves_;
  GridPlace goal_;
  GridHeuristic heuristic_;
  std::vector<std::optional<Counts>> cost_;
  Truth truth_;
};

class HeuristicVerdictProperty : public testing::TestWithParam<GridMoves> {};

TEST_P(HeuristicVerdictProperty, NamesTheWorstCellAndMoveThatBruteForceNames) {
  const GridMoves moves = GetParam();
  Draws draws(41 + static_cast<std::uint64_t>(moves));
  int inadmissible = 0, inconsistent = 0;
  for (int round = 0; round < 1500; ++round) {
    OccupancyGrid grid = random_grid(draws, 10);
    const GridPlace goal = free_place(draws, grid);
    GridHeuristic heuristic{{static_cast<GridEstimate>(draws.below(8))}};
    if (draws.below(2) == 0) heuristic.members.push_back(static_cast<GridEstimate>(draws.below(8)));
    SCOPED_TRACE(name(heuristic) + ", round " + std::to_string(round));
    const HeuristicVerdict v = heuristic_verdict(grid, moves, goal, heuristic);
    const Truth truth = Judged(grid, moves, goal, heuristic).truth();
    ASSERT_EQ(v.admissible(), !truth.cell);
    ASSERT_EQ(v.consistent(), !truth.from);
    ASSERT_TRUE(v.consistent() || !consistent_everywhere(heuristic, moves));
    ASSERT_TRUE(v.admissible() || !v.consistent());
    if (v.overestimate) {
      ++inadmissible;
      ASSERT_EQ(v.overestimate->cell, *truth.cell);
      ASSERT_NEAR(v.overestimate->estimate - v.overestimate->cost.value(), static_cast<double>(truth.excess), 1e-7);
    }
    if (v.violation) {
      ++inconsistent;
      ASSERT_EQ(v.violation->from, *truth.from);
      ASSERT_EQ(v.violation->to, *truth.to);
      ASSERT_NEAR(v.violation->estimate_from - v.violation->estimate_to - v.violation->cost.value(),
                  static_cast<double>(truth.fall), 1e-7);
    }
  }
  if (moves == GridMoves::four) return;  // all of them are consistent there
  EXPECT_GT(inadmissible, 100);
  EXPECT_GE(inconsistent, inadmissible);
}

INSTANTIATE_TEST_SUITE_P(Moves, HeuristicVerdictProperty,
                         testing::Values(GridMoves::four, GridMoves::eight, GridMoves::octile),
                         [](const auto& which) { return "Moves" + std::string(name(which.param)); });

TEST(GridHeuristic, NamesAreReadBack) {
  EXPECT_EQ(name(*grid_heuristic_named("manhattan,biased-row")), "manhattan,biased-row");
  for (const char* wrong : {"", ",", "manhattan,", "Manhattan", "manhattan euclidean"})
    EXPECT_FALSE(grid_heuristic_named(wrong)) << wrong;
}

}  // namespace
}  // namespace taut::test
