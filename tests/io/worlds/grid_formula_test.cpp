// Estimates as people write them, against those that have a name.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <taut/geometry/draws.h>
#include <taut/geometry/errors.h>
#include <taut/io/worlds/grid_formula.h>
#include <taut/search/grid/grid_search.h>
#include <cmath>
#include <string>
#include "support/grid_drawing.h"

namespace taut::test {
namespace {

using testing::HasSubstr;

const DrawnGrid kBend = drawn({"S.#G",  //
                               "..#.",  //
                               "...."});

std::string refusal(std::string_view text) {
  try {
    grid_heuristic(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

OccupancyGrid random_grid(Draws& draws) {
  OccupancyGrid grid{
      1 + static_cast<std::uint32_t>(draws.below(9)), 1 + static_cast<std::uint32_t>(draws.below(9)), {}};
  for (std::uint32_t i = 0; i < grid.width * grid.height; ++i) grid.blocked.push_back(draws.below(3) == 0 ? 1 : 0);
  return grid;
}

TEST(GridFormula, TakesColumnsAndRowsOfCellAndGoal) {
  const GridFormula f = grid_formula("1000*cx + 100*cy + 10*gx + gy");
  EXPECT_EQ(f.value({2, 1}, {4, 3}), 1234);
  EXPECT_EQ(f.text, "1000*cx + 100*cy + 10*gx + gy");
}

TEST(GridFormula, JudgesAsTheNamedEstimateDoes) {
  const std::pair<const char*, const char*> kSame[]{
      {"manhattan", "abs(cx-gx) + abs(cy-gy)"},
      {"chebyshev", "max(abs(cx-gx), abs(cy-gy))"},
      {"octile", "max(abs(cx-gx), abs(cy-gy)) + (sqrt(2)-1) * min(abs(cx-gx), abs(cy-gy))"},
      {"euclidean", "sqrt((cx-gx)^2 + (cy-gy)^2)"},
      {"biased-row", "cy - gy"},
      {"biased-column", "cx - gx"},
      {"manhattan,biased-row", "manhattan,cy - gy"},
      {"zero", "0"},
  };
  Draws draws(77);
  for (int round = 0; round < 400; ++round) {
    OccupancyGrid grid = random_grid(draws);
    const GridPlace goal{static_cast<std::uint32_t>(draws.below(grid.height)),
                         static_cast<std::uint32_t>(draws.below(grid.width))};
    grid.blocked[goal.row * grid.width + goal.column] = 0;
    for (const GridMoves moves : {GridMoves::four, GridMoves::eight, GridMoves::octile})
      for (const auto& [word, formula] : kSame) {
        SCOPED_TRACE(formula);
        const HeuristicVerdict named = heuristic_verdict(grid, moves, goal, grid_heuristic(word)),
                               written = heuristic_verdict(grid, moves, goal, grid_heuristic(formula));
        ASSERT_EQ(written.admissible(), named.admissible());
        ASSERT_EQ(written.consistent(), named.consistent());
        if (!named.overestimate) continue;
        ASSERT_EQ(written.overestimate->cell, named.overestimate->cell);
        ASSERT_NEAR(written.overestimate->estimate, named.overestimate->estimate, 1e-8);
      }
  }
}

TEST(GridFormula, LeadsASearchAsTheNamedEstimateDoesButProvesNothing) {
  GridQuery named{GridAlgorithm::astar, grid_heuristic("chebyshev")},
      written{GridAlgorithm::astar, grid_heuristic("max(abs(cx-gx),abs(cy-gy))")};
  named.record = written.record = true;
  GridSearch one(kBend.grid, GridMoves::octile), other(kBend.grid, GridMoves::octile);
  const GridResult a = one.find(kBend.start, kBend.goal, named), b = other.find(kBend.start, kBend.goal, written);
  EXPECT_EQ(a.visited, b.visited);
  EXPECT_EQ(a.cost, b.cost);
  EXPECT_TRUE(a.optimal);
  EXPECT_FALSE(b.optimal);
}

TEST(GridFormula, NamesTheCellWithoutAValue) {
  for (const char* text : {"1/(cx-1)", "sqrt(-1-cx)", "1e10"}) {
    try {
      heuristic_verdict(kBend.grid, GridMoves::four, kBend.goal, grid_heuristic(text));
      ADD_FAILURE() << text;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr(text));
      EXPECT_THAT(error.what(), testing::ContainsRegex("cell \\([0-9],[0-9]\\)"));
    }
  }
}

TEST(GridFormula, IsRefusedWithItsPlace) {
  EXPECT_THAT(refusal("cx+"), HasSubstr("Unexpected end of expression at position 4"));
  EXPECT_THAT(refusal("cx + dx"), HasSubstr("dx"));
  EXPECT_THAT(refusal("max(cx"), HasSubstr("no expression"));
  for (const char* word : {"manhatan", "", "manhattan,", "Manhattan"})
    EXPECT_THAT(refusal(word), HasSubstr("is no heuristic; they are zero, manhattan")) << word;
}

TEST(GridHeuristicText, JoinsNamesAndFormulasAtCommasOutsideParentheses) {
  const GridHeuristic h = grid_heuristic("zero,max(cx,cy),octile,cx");
  EXPECT_EQ(h.members, (std::vector{GridEstimate::zero, GridEstimate::octile}));
  ASSERT_EQ(h.formulas.size(), 2U);
  EXPECT_EQ(h.formulas[0].text, "max(cx,cy)");
  EXPECT_EQ(name(h), "zero,octile,max(cx,cy),cx");
}

}  // namespace
}  // namespace taut::test
