#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <taut/io/pictures/grid_svg.h>
#include <taut/search/grid/grid_search.h>
#include <string>
#include "support/grid_drawing.h"
#include "support/text.h"

namespace taut::test {
namespace {

using testing::HasSubstr;
using testing::Not;

GridPicture picture_of(const OccupancyGrid& grid, GridMoves moves, GridPlace start, GridPlace goal) {
  GridQuery query{GridAlgorithm::astar, natural_heuristic(moves)};
  query.record = true;
  GridResult r = GridSearch(grid, moves).find(start, goal, query);
  return {"a < b & c", {"one", "two"}, r.visited, r.frontier, r.path, start, goal, false};
}

const DrawnGrid kBend = drawn({"S.#G",  //
                               "..#.",  //
                               "...."});

TEST(GridSvg, DrawsCellsFrontierPathAndEnds) {
  GridPicture picture = picture_of(kBend.grid, GridMoves::four, kBend.start, kBend.goal);
  picture.frontier = {{2, 0}};
  const std::string text = grid_svg(kBend.grid, picture);
  EXPECT_THAT(text, HasSubstr("M2 0h1v1h-1z"));           // a blocked cell
  EXPECT_THAT(text, HasSubstr("M0.15 2.15h.7v.7h-.7z"));  // the frontier
  EXPECT_THAT(text, HasSubstr("L1.5 1.5L1.5 2.5"));       // the path goes down
  EXPECT_THAT(text, HasSubstr("cx=\"144\" cy=\"56\""));   // the start: 112 + 0.5 * 64, 24 + 0.5 * 64
  EXPECT_THAT(text, HasSubstr("a &lt; b &amp; c"));
  EXPECT_THAT(text, HasSubstr("one \xC2\xB7 two"));
}

TEST(GridSvg, PlaysByItselfWhenAnimatedAndCanBePaused) {
  GridPicture picture = picture_of(kBend.grid, GridMoves::four, kBend.start, kBend.goal);
  EXPECT_THAT(grid_svg(kBend.grid, picture), Not(HasSubstr("begin=")));
  EXPECT_THAT(grid_svg(kBend.grid, picture), Not(HasSubstr("<script")));
  picture.animated = true;
  const std::string text = grid_svg(kBend.grid, picture);
  EXPECT_EQ(count(text, "<set "), picture.visited.size());  // fewer than 64: each has its moment
  EXPECT_EQ(count(text, "<animate "), 1U);
  EXPECT_EQ(count(text, "<script"), 1U);
  EXPECT_THAT(text, HasSubstr("prefers-reduced-motion"));
  EXPECT_EQ(count(text, "class=\"appears\""), picture.visited.size());
}

TEST(GridSvg, IsXmlWhateverTheTitle) {
  GridPicture picture;
  picture.title = "\x01 \xFF";
  EXPECT_THAT(grid_svg(kBend.grid, picture), HasSubstr("\xEF\xBF\xBD"));
  EXPECT_THAT(grid_svg(kBend.grid, picture), Not(HasSubstr("\x01")));
}

TEST(GridSvg, DrawsAMapAlone) {
  GridPicture nothing;
  nothing.title = "map";
  EXPECT_THAT(grid_svg(kBend.grid, nothing), HasSubstr("</svg>"));
}

TEST(GridSvg, GrowsWithOutlinesNotWithCells) {
  const OccupancyGrid open{600, 600, std::vector<std::uint8_t>(360'000, 0)};
  GridPicture picture = picture_of(open, GridMoves::octile, {300, 5}, {300, 590});
  EXPECT_LT(grid_svg(open, picture).size(), 200'000U);
  EXPECT_EQ(grid_svg(open, picture), grid_svg(open, picture));
}

TEST(GridComparisonSvg, HasAPanelForEachSearchAndOneLegend) {
  std::vector<GridPicture> pictures;
  for (const char* title : {"first", "second", "third", "fourth"}) {
    pictures.push_back(picture_of(kBend.grid, GridMoves::four, kBend.start, kBend.goal));
    pictures.back().title = title;
  }
  const std::string text = grid_comparison_svg(kBend.grid, pictures, "bend", {"4 moves"});
  EXPECT_EQ(count(text, "class=\"panel\""), 4U);
  EXPECT_EQ(count(text, "<svg x="), 4U);
  EXPECT_EQ(count(text, "class=\"legend\""), 1U);
  EXPECT_THAT(text, HasSubstr(">fourth<"));
  EXPECT_THAT(text, HasSubstr("width=\"1000\""));
  EXPECT_EQ(text, grid_comparison_svg(kBend.grid, pictures, "bend", {"4 moves"}));
}

}  // namespace
}  // namespace taut::test
