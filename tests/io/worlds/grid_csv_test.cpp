#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <taut/io/worlds/grid_csv.h>
#include <taut/search/grid/grid_search.h>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "support/paths.h"
#include "support/refusal.h"
#include "support/text.h"

namespace taut::test {
namespace {

std::string complaint(const std::string& text) {
  return refusal_of([&] { read_grid(text, "a.csv"); });
}

TEST(GridCsv, ReadsPaddedLinesWithAnyLineEnds) {
  const GridTask task = read_grid("start,0,1,\r\n\r\ngoal,1,2,,\r\n0,0,1,\r\n 1 ,0, 0\r\n", "a.csv");
  EXPECT_EQ(task.grid.width, 3U);
  EXPECT_EQ(task.grid.height, 2U);
  EXPECT_EQ(task.grid.blocked, (std::vector<std::uint8_t>{0, 0, 1, 1, 0, 0}));
  EXPECT_EQ(task.start, (GridPlace{0, 1}));
  EXPECT_EQ(task.goal, (GridPlace{1, 2}));
  EXPECT_EQ(read_grid_csv(grid_csv_text(task), "").grid.blocked, task.grid.blocked);
}

TEST(GridCsv, NamesLineAndCulprit) {
  EXPECT_EQ(complaint("start,0,0\ngoal,0,1\n0,2\n"), "a.csv:3: cell (row 0, column 1) is '2', not 0 or 1");
  EXPECT_EQ(complaint("start,0,0\ngoal,0,1\n0,0\n0\n"), "a.csv:4: row 1 has 1 cells, those before it 2");
  EXPECT_EQ(complaint("start,0,0\ngoal,0,1\n0,1\n"), "a.csv:2: goal (row 0, column 1) is blocked");
  EXPECT_EQ(complaint("start,5,0\ngoal,0,1\n0,0\n"),
            "a.csv:1: start (row 5, column 0) is outside the grid of 1 rows and 2 columns");
  EXPECT_EQ(complaint("start,0\ngoal,0,1\n0,0\n"), "a.csv:1: 'start' wants a row and a column, not 1 values");
  EXPECT_EQ(complaint("start,0,0\nstart,0,0\n0,0\n"), "a.csv:2: cell (row 0, column 0) is 'start', not 0 or 1");
  EXPECT_EQ(complaint("0,1,\n0,1,0\n"), "a.csv:2: row 1 has 3 cells, those before it 2");
  EXPECT_EQ(complaint("start,0,0\ngoal,0,1\n"), "a.csv: has no rows of cells");
}

TEST(GridCsv, MayLeaveStartAndGoalToTheCaller) {
  const GridTask bare = read_grid("0,1\n0,0\n", "a.csv");
  EXPECT_EQ(bare.grid.height, 2U);
  EXPECT_FALSE(bare.start || bare.goal);
  EXPECT_EQ(read_grid("goal,1,1\n0,1\n0,0\n", "a.csv").goal, (GridPlace{1, 1}));
}

TEST(GridDrawing, ReadsCellsAndEnds) {
  const GridTask task = read_grid("S.#\n.@G\n", "a.txt");
  EXPECT_EQ(task.grid.blocked, (std::vector<std::uint8_t>{0, 0, 1, 0, 1, 0}));
  EXPECT_EQ(task.start, (GridPlace{0, 0}));
  EXPECT_EQ(task.goal, (GridPlace{1, 2}));
  EXPECT_THAT(complaint("S?\n"), testing::HasSubstr("a.csv:1: '?' in column 1 is no cell"));
  EXPECT_THAT(complaint("SS\n"), testing::HasSubstr("a second 'S'"));
}

/// What is known of a grid: the steps of four searches, the cells of a shortest path and of that by depth first; A* with
/// the last come first of equals, and with two biased estimates; greedy.
struct Figures {
  std::filesystem::path file;
  std::size_t bfs, dfs, dijkstra, astar, path, dfs_path, lifo, biased, greedy, greedy_path;
};

void PrintTo(const Figures& figures, std::ostream* out) { *out << figures.file.filename().string(); }

/// Published ones, but for pocket.csv.
std::vector<Figures> figures() {
  std::vector<Figures> all{{data_dir() / "pocket.csv", 71, 33, 71, 55, 17, 33, 50, 63, 194, 17}};
  if (const auto shared = shared_data_dir()) {
    all.push_back({*shared / "grid" / "test_map.csv", 10, 9, 10, 7, 5, 9, 0, 0, 0, 0});
    all.push_back({*shared / "grid" / "map.csv", 64, 33, 64, 51, 20, 32, 0, 60, 40, 28});
    all.push_back({*shared / "grid" / "test_better.csv", 36, 35, 36, 19, 11, 27, 14, 0, 0, 0});
  }
  return all;
}

class GridFigures : public testing::TestWithParam<Figures> {
 protected:
  void SetUp() override {
    std::stringstream text;
    text << std::ifstream(GetParam().file).rdbuf();
    task = read_grid(text.str(), GetParam().file.string());
  }
  GridResult run(GridQuery query) {
    return GridSearch(task.grid, GridMoves::four).find(*task.start, *task.goal, query);
  }
  static GridHeuristic h(std::string_view names) { return *grid_heuristic_named(names); }
  GridTask task;
};

TEST_P(GridFigures, AreThoseOfTheSource) {
  const Figures& f = GetParam();
  const GridResult bfs = run({GridAlgorithm::bfs, {}}), dfs = run({GridAlgorithm::dfs, {}}),
                   dijkstra = run({GridAlgorithm::dijkstra, {}}), astar = run({GridAlgorithm::astar, h("manhattan")});
  EXPECT_EQ(bfs.steps, f.bfs);
  EXPECT_EQ(dfs.steps, f.dfs);
  EXPECT_EQ(dijkstra.steps, f.dijkstra);
  EXPECT_EQ(astar.steps, f.astar);
  EXPECT_EQ(bfs.path.size(), f.path);
  EXPECT_EQ(dijkstra.path.size(), f.path);
  EXPECT_EQ(astar.path.size(), f.path);
  EXPECT_EQ(dfs.path.size(), f.dfs_path);
}

// What was published as A* on two of them is A* with biased estimates on one, greedy search on the other.
TEST_P(GridFigures, AreThoseOfBiasedAndGreedySearches) {
  const Figures& f = GetParam();
  if (f.biased != 0) {
    EXPECT_EQ(run({GridAlgorithm::astar, h("biased-row,biased-column")}).steps, f.biased);
    const GridResult greedy = run({GridAlgorithm::greedy, h("euclidean")});
    EXPECT_EQ(greedy.steps, f.greedy);
    EXPECT_EQ(greedy.path.size(), f.greedy_path);
    EXPECT_FALSE(greedy.optimal);
  }
}

TEST_P(GridFigures, AreFewerStepsWithTheLastComeFirstOfEquals) {
  if (GetParam().lifo != 0) {
    const GridResult lifo = run({GridAlgorithm::astar, h("manhattan"), Ties::lifo});
    EXPECT_EQ(lifo.steps, GetParam().lifo);
    EXPECT_LT(lifo.steps, GetParam().astar);
  }
}

INSTANTIATE_TEST_SUITE_P(Files, GridFigures, testing::ValuesIn(figures()),
                         [](const auto& figures) { return words(figures.param.file.stem().string()); });

}  // namespace
}  // namespace taut::test
