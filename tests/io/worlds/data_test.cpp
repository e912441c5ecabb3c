// data/README.md promises a shortest path for each file; here it is kept.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include <taut/io/worlds/grid_csv.h>
#include <taut/io/worlds/movingai.h>
#include <taut/io/worlds/read_world.h>
#include <taut/search/corner_count.h>
#include <taut/search/grid/grid_search.h>
#include <taut/search/shortest_path.h>
#include <taut/search/verify.h>

#include "support/paths.h"
#include "support/run_program.h"

namespace taut {
namespace {

TEST(Data, HasTheShortestPathsThatItsReadmePromises) {
  std::ifstream readme(test::data_dir() / "README.md");
  const std::regex row(R"(\| `([^`]+)` \|.*\| length ([0-9.]+), ([0-9]+) corners? \|)");
  std::size_t rows = 0;
  for (std::string line; std::getline(readme, line);) {
    std::smatch match;
    if (!std::regex_match(line, match, row)) continue;
    ++rows;
    const World world = read_world_file((test::data_dir() / match[1].str()).string());
    const FreeSpace space(world);
    const auto path = shortest_path(space, *world.start(), world.goal());
    ASSERT_TRUE(path) << match[1];
    EXPECT_EQ(path->length.decimals(6), match[2].str()) << match[1];
    EXPECT_EQ(std::to_string(corner_count(path->points)), match[3].str()) << match[1];
    EXPECT_TRUE(verify(*path, space, *world.start(), world.goal()).valid) << match[1];
  }
  EXPECT_GE(rows, 13U);  // what is left out by a typing error is missed otherwise
}

TEST(Data, HasARowForEachFile) {
  const std::string readme = test::contents(test::data_dir() / "README.md");
  for (const auto& entry : std::filesystem::recursive_directory_iterator(test::data_dir())) {
    if (entry.is_directory()) continue;
    const std::string name = std::filesystem::relative(entry.path(), test::data_dir()).generic_string();
    EXPECT_TRUE(name == "README.md" || readme.find("\n| `" + name + "` |") != std::string::npos) << name;
  }
}

class GridData : public testing::Test {
 protected:
  static std::string text(const std::string& name) { return test::contents(test::data_dir() / name); }
  /// Calls `check` with the groups of every row of data/README.md that matches; says how many did.
  template <class Check>
  static std::size_t for_rows(const char* pattern, Check check) {
    const std::regex row(pattern);
    std::istringstream readme(text("README.md"));
    std::size_t rows = 0;
    for (std::string line; std::getline(readme, line);)
      if (std::smatch match; std::regex_match(line, match, row)) {
        SCOPED_TRACE(match[1]);
        check(match);
        ++rows;
      }
    return rows;
  }
};

TEST_F(GridData, MapsHaveTheFreeCellsOfTheReadme) {
  EXPECT_EQ(for_rows(R"(\| `([^`]+\.map)` \|.*\| ([0-9]+) free cells \|)",
                     [](const std::smatch& row) {
                       const OccupancyGrid grid = read_movingai_map(text(row[1]), row[1]);
                       EXPECT_EQ(std::count(grid.blocked.begin(), grid.blocked.end(), 0), std::stol(row[2]));
                     }),
            3U);
}

// Made by Dijkstra; A* and jump point search agree to the last digit.
TEST_F(GridData, ScenariosHaveTheCostsOfTheReadme) {
  const auto check = [](const std::smatch& row) {
    const std::string scen = row[1], map = scen.substr(0, scen.size() - 4) + "map";
    GridSearch search(read_movingai_map(text(map), map), GridMoves::octile);
    const std::vector<Scenario> scenarios = read_movingai_scenarios(text(scen), scen);
    EXPECT_EQ(std::to_string(scenarios.size()), row[2]);
    double total = 0;
    for (const Scenario& s : scenarios) {
      for (const GridAlgorithm a : {GridAlgorithm::astar, GridAlgorithm::jps}) {
        const GridResult r = search.find({s.start_row, s.start_column}, {s.goal_row, s.goal_column},
                                         {a, natural_heuristic(GridMoves::octile)});
        EXPECT_EQ(fmt::format("{:.8f}", r.cost.value()), s.optimal_text) << s.line;
      }
      total += s.optimal;
    }
    EXPECT_EQ(fmt::format("{:.6f}", total), row[3]);
  };
  EXPECT_EQ(for_rows(R"(\| `([^`]+\.scen)` \|.*\| ([0-9]+) scenarios, total cost ([0-9.]+) \|)", check), 3U);
}

TEST_F(GridData, SearchesTakeTheStepsOfTheReadme) {
  const auto check = [](const std::smatch& row) {
    const GridTask task = read_grid(text(row[1]), row[1]);
    GridSearch search(task.grid, GridMoves::four);
    const std::string steps = row[3];
    const std::regex pair("([a-z]+) ([0-9]+)");
    for (std::sregex_iterator each(steps.begin(), steps.end(), pair), end; each != end; ++each) {
      GridQuery query{*grid_algorithm_named((*each)[1].str()), natural_heuristic(GridMoves::four)};
      if (query.algorithm == GridAlgorithm::greedy) query.heuristic = {{GridEstimate::euclidean}};
      const GridResult r = search.find(*task.start, *task.goal, query);
      EXPECT_EQ(std::to_string(r.steps), (*each)[2]) << (*each)[1];
      EXPECT_TRUE(!r.optimal || std::to_string(r.cost.straight()) == row[2]) << (*each)[1];
    }
  };
  EXPECT_EQ(for_rows(R"(\| `([^`]+\.csv)` \|.*\| cost ([0-9]+); (.*) steps \|)", check), 1U);
}

}  // namespace
}  // namespace taut
