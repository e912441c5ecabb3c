// taut grid: known figures, every subcommand, and what is refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "support/program_test.h"
#include "support/text.h"

namespace taut::test {
namespace {

using nlohmann::json;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::StartsWith;

// By hand: a wall whose gap is at the bottom.
constexpr const char* kBend = "start,0,0,,\ngoal,0,3,,\n0,0,1,0\n0,0,1,0\n0,0,0,0\n";
constexpr const char* kSealed = "S#G\n";

class GridProgram : public ProgramTest {
 protected:
  static json envelope(const std::string& arguments, std::string_view input = {}) {
    return json::parse(run_taut("grid " + arguments + " --json -", input).out);
  }
  static json answer(const std::string& arguments, std::string_view input = {}) {
    return envelope(arguments, input)["result"];
  }
};

class GridSolve : public GridProgram {};
class GridCompare : public GridProgram {};
class GridHeuristics : public GridProgram {};
class GridGenerate : public GridProgram {};

/// What is known of a search: steps, and cells of its path. Those on our grid were counted by hand or by bench; those of
/// others are published.
struct Figure {
  std::string file;
  const char* options;
  int steps;
  int cells;
  bool optimal;
};

void PrintTo(const Figure& figure, std::ostream* out) { *out << figure.file << ' ' << figure.options; }

class GridFigure : public GridProgram, public testing::WithParamInterface<Figure> {};

TEST_P(GridFigure, IsThatOfTheSource) {
  const auto& [file, options, steps, cells, optimal] = GetParam();
  const json all = envelope("solve " + file + " " + options), out = all["result"];
  EXPECT_EQ(all["status"], "found");
  EXPECT_EQ(out["steps"], steps);
  EXPECT_EQ(out["cells"], cells);
  EXPECT_EQ(out["path"].size(), static_cast<std::size_t>(cells));
  EXPECT_EQ(out["cost"], cells - 1);
  EXPECT_EQ(out["optimal"], optimal);
}

std::vector<Figure> figures() {
  std::vector<Figure> all;
  const auto add = [&](const std::filesystem::path& folder, std::vector<Figure> some) {
    for (Figure& figure : some) {
      figure.file = (folder / figure.file).string();
      all.push_back(std::move(figure));
    }
  };
  add(data_dir(),
      {Figure{"pocket.csv", "--algorithm bfs", 71, 17, true}, Figure{"pocket.csv", "--algorithm dfs", 33, 33, false},
       Figure{"pocket.csv", "--algorithm dijkstra", 71, 17, true}, Figure{"pocket.csv", "", 55, 17, true},
       Figure{"pocket.csv", "--algorithm astar --ties fifo", 55, 17, true},
       Figure{"pocket.csv", "--algorithm astar --ties lifo", 50, 17, true},
       Figure{"pocket.csv", "--heuristic biased-row,biased-column", 63, 17, true},
       Figure{"pocket.csv", "--algorithm greedy", 194, 17, false}});
  if (const auto shared = shared_data_dir())
    add(*shared / "grid",
        {Figure{"test_map.csv", "--algorithm bfs", 10, 5, true}, Figure{"test_map.csv", "--algorithm dfs", 9, 9, false},
         Figure{"test_map.csv", "--algorithm dijkstra", 10, 5, true},
         Figure{"test_map.csv", "--algorithm astar", 7, 5, true}, Figure{"map.csv", "--algorithm bfs", 64, 20, true},
         Figure{"map.csv", "--algorithm dfs", 33, 32, false}, Figure{"map.csv", "--algorithm dijkstra", 64, 20, true},
         Figure{"map.csv", "", 51, 20, true}, Figure{"map.csv", "--algorithm astar", 51, 20, true},
         Figure{"map.csv", "--heuristic biased-row,biased-column", 60, 20, true},
         Figure{"map.csv", "--algorithm greedy", 40, 28, false},
         Figure{"map.csv", "--algorithm greedy-once", 34, 28, false},
         Figure{"map.csv", "--algorithm greedy --heuristic manhattan", 42, 32, false},
         Figure{"map.csv", "--algorithm weighted-astar --weight 1", 51, 20, true},
         Figure{"test_better.csv", "--algorithm bfs", 36, 11, true},
         Figure{"test_better.csv", "--algorithm dfs", 35, 27, false},
         Figure{"test_better.csv", "--algorithm dijkstra", 36, 11, true},
         Figure{"test_better.csv", "--algorithm astar --ties fifo", 19, 11, true},
         Figure{"test_better.csv", "--algorithm astar --ties lifo", 14, 11, true}});
  return all;
}

INSTANTIATE_TEST_SUITE_P(Source, GridFigure, testing::ValuesIn(figures()), [](const auto& figure) {
  return words(std::filesystem::path(figure.param.file).stem().string() + " " + figure.param.options);
});

TEST_F(GridSolve, SaysWhatItFoundInOneLine) {
  const Outcome run = run_taut("grid solve -", kBend);
  EXPECT_EQ(run.code, 0);
  EXPECT_EQ(run.err, "");
  EXPECT_THAT(run.out, StartsWith("<stdin>: astar (manhattan): "));
  EXPECT_THAT(run.out, HasSubstr(" steps, cost 7, 8 cells, proven least, "));
  EXPECT_EQ(std::count(run.out.begin(), run.out.end(), '\n'), 1);
}

TEST_F(GridSolve, GivesThePathAsRowsAndColumns) {
  const json path = json::parse("[[0,0],[0,1],[1,1],[2,1],[2,2],[2,3],[1,3],[0,3]]");
  EXPECT_EQ(answer("solve - --algorithm dfs", kBend)["path"], path);
  EXPECT_EQ(run_taut("grid solve - -q --path --algorithm dfs", kBend).out, "0,0\n0,1\n1,1\n2,1\n2,2\n2,3\n1,3\n0,3\n");
}

TEST_F(GridSolve, KnowsThreeKindsOfMoves) {
  EXPECT_EQ(answer("solve - --moves 4", kBend)["cost"], 7);
  const json octile = answer("solve - --moves octile", kBend), eight = answer("solve - --moves 8", kBend);
  EXPECT_EQ(octile["straight"], 5);  // the corners are not cut
  EXPECT_EQ(octile["diagonal"], 1);
  EXPECT_EQ(eight["diagonal"], 3);
  EXPECT_EQ(eight["straight"], 1);
  EXPECT_EQ(octile["heuristic"], "octile");
}

TEST_F(GridSolve, StartsAndEndsWhereItIsTold) {
  const json out = answer("solve - --start 2,0 --goal 2,3", kBend);
  EXPECT_EQ(out["path"], json::parse("[[2,0],[2,1],[2,2],[2,3]]"));
}

TEST_F(GridSolve, EndsWithOneWhenThereIsNoPath) {
  for (const char* algorithm : {"bfs", "dfs", "dijkstra", "greedy", "greedy-once", "astar", "weighted-astar",
                                "bidirectional-astar", "idastar", "jps"}) {
    SCOPED_TRACE(algorithm);
    const Outcome run = run_taut(std::string("grid solve - --json - --algorithm ") + algorithm, kSealed);
    EXPECT_EQ(run.code, 1);
    const json all = json::parse(run.out), out = all["result"];
    EXPECT_EQ(all["status"], "none");
    EXPECT_EQ(out["cost"], nullptr);
    EXPECT_EQ(out["path"], json::array());
  }
}

TEST_F(GridSolve, EndsWithFourWhenItsStepsAreUsedUp) {
  const Outcome run = run_taut("grid solve - --max-steps 3 --json -", kBend);
  EXPECT_EQ(run.code, 4);
  const json out = json::parse(run.out);
  EXPECT_EQ(out["status"], "stopped");
  EXPECT_EQ(out["reason"], "--max-steps 3");
  EXPECT_EQ(out["result"]["steps"], 3);
  EXPECT_EQ(run_taut("grid solve - --max-steps 3", kBend).code, 4);
}

// A pocket before the goal, into which the estimate leads: entries of equal rank multiply.
TEST_F(GridSolve, HasABudgetWhereStepsCanGrowExponentially) {
  std::string map;
  for (int row = 0; row < 40; ++row)
    map += row == 20 ? "S" + std::string(38, '.') + "#G\n" : std::string(39, '.') + "#.\n";
  EXPECT_EQ(run_taut("grid solve - --algorithm greedy", map).code, 4);
  EXPECT_EQ(run_taut("grid solve - --algorithm greedy-once", map).code, 1);
}

// With no estimate and a careless frontier every shortest way is walked anew: more than any computer has time for.
TEST_F(GridSolve, WritesAResultWhenTimeIsUp) {
  const std::string file = (folder / "a.json").string();
  std::string open = "S" + std::string(59, '.') + "\n";
  for (int row = 0; row < 58; ++row) open += std::string(60, '.') + "\n";
  open += std::string(59, '.') + "G\n";
  const std::string forever = " --algorithm greedy --heuristic zero --max-steps 1000000000000";
  EXPECT_EQ(run_taut("grid solve -" + forever + " --max-seconds 0.5 --json " + file, open).code, 4);
  EXPECT_EQ(json::parse(contents(file))["status"], "stopped");
  EXPECT_EQ(json::parse(contents(file))["result"]["algorithm"], "greedy");
  const Outcome all =
      run_taut("grid compare - --heuristic zero --max-steps 1000000000000 --max-seconds 1.5 --json " + file, open);
  EXPECT_EQ(all.code, 4);
  EXPECT_THAT(all.out, ContainsRegex("dijkstra +4 +found"));
  EXPECT_EQ(json::parse(contents(file))["status"], "stopped");
  EXPECT_GE(json::parse(contents(file))["result"]["searches"].size(), 4U);
}

TEST_F(GridSolve, DrawsStillAndPlaying) {
  const std::string still = (folder / "a.svg").string(), playing = (folder / "b.svg").string();
  EXPECT_EQ(run_taut("grid solve - --svg " + still + " --animate " + playing, kBend).code, 0);
  EXPECT_THAT(contents(still), StartsWith("<svg "));
  EXPECT_THAT(contents(still), testing::Not(HasSubstr("<animate")));
  EXPECT_THAT(contents(playing), HasSubstr("<animate"));
}

TEST_F(GridSolve, RefusesWrongUsageAndWrongInput) {
  for (const char* options : {"--algorithm a*",
                              "--heuristic foo",
                              "--heuristic manhattan,",
                              "--ties none",
                              "--moves 6",
                              "--weight nan",
                              "--weight 0.5",
                              "--weight 1e9",
                              "--max-steps -1",
                              "--max-steps 1e3",
                              "--start 0",
                              "--start -1,0",
                              "--goal 0,1,2",
                              "--weight 2",
                              "--algorithm bfs --heuristic zero",
                              "--algorithm dfs --ties lifo",
                              "--robot disc:1",
                              "--algorithm jps --moves 4",
                              "--json - --svg -",
                              "extra",
                              "--frobnicate"}) {
    const Outcome run = run_taut(std::string("grid solve - ") + options, kBend);
    EXPECT_EQ(run.code, 2) << options;
    EXPECT_EQ(run.out, "") << options;
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
  }
  for (const char* command : {"solve", "compare", "heuristics"}) {
    const Outcome old = run_taut(std::string("grid ") + command + " - --to 0,1", kBend);
    EXPECT_EQ(old.code, 2);
    EXPECT_THAT(old.err, HasSubstr("--to is --goal here; did you mean `--goal 0,1`?"));
  }
  EXPECT_THAT(run_taut("grid solve - --from 0,1", kBend).err, HasSubstr("did you mean `--start 0,1`?"));
  EXPECT_EQ(run_taut("grid").code, 2);
  EXPECT_EQ(run_taut("grid frobnicate").code, 2);
  const auto refusal = [](const char* options, const char* input) {
    const Outcome run = run_taut(std::string("grid solve - ") + options, input);
    EXPECT_EQ(run.code, 3) << run.err;
    return run.err;
  };
  EXPECT_EQ(refusal("--start 0,2", kBend),
            "taut: <stdin>: --start 0,2 is blocked in the grid of 3 rows and 4 columns\n");
  EXPECT_EQ(refusal("--goal 3,0", kBend), "taut: <stdin>: --goal 3,0 is outside the grid of 3 rows and 4 columns\n");
  EXPECT_EQ(refusal("", "..\n.G\n"), "taut: <stdin>: says no start; give one with --start ROW,COLUMN\n");
  EXPECT_EQ(refusal("", "start,0,0\ngoal,0,1\n0,2\n"), "taut: <stdin>:3: cell (row 0, column 1) is '2', not 0 or 1\n");
  EXPECT_THAT(refusal("", ""), StartsWith("taut: <stdin>"));
}

TEST_F(GridCompare, PutsAllSearchesSideBySide) {
  const json all = answer("compare -", kBend);
  ASSERT_EQ(all["searches"].size(), 10U);
  for (const json& search : all["searches"]) {
    EXPECT_EQ(search["status"], "found");
    const bool diagonal = search["algorithm"] == "jps";
    EXPECT_EQ(search["moves"], diagonal ? "octile" : "4");
    EXPECT_TRUE(diagonal || search["cost"] == 7) << search;
  }
  const Outcome table = run_taut("grid compare -", kBend);
  EXPECT_THAT(table.out, ContainsRegex("dijkstra +4 +found +10 +8 +7 +yes"));
  EXPECT_EQ(answer("compare - --moves 4", kBend)["searches"].size(), 9U);  // without jps
}

TEST_F(GridCompare, SaysNoneOnlyWhenProven) {
  EXPECT_EQ(run_taut("grid compare -", kSealed).code, 1);
  EXPECT_EQ(run_taut("grid compare - -q", kBend).out, "");
  EXPECT_EQ(run_taut("grid heuristics - -q", kBend).out, "");
  EXPECT_EQ(run_taut("grid compare - --max-steps 2", kBend).code, 4);
}

TEST_F(GridCompare, DrawsThemSideBySide) {
  const Outcome run = run_taut("grid compare - --moves octile --svg " + in_folder("searches.svg"), kBend);
  EXPECT_EQ(run.code, 0);
  const std::string picture = contents(in_folder("searches.svg"));
  EXPECT_EQ(count(picture, "class=\"panel\""), answer("compare - --moves octile", kBend)["searches"].size());
  EXPECT_THAT(picture, HasSubstr(">bidirectional-astar<"));
}

TEST_F(GridHeuristics, TakesAnExpression) {
  const json judged = answer("heuristics - --moves octile --heuristic 'max(abs(cx-gx), abs(cy-gy))*1.5'", kBend);
  EXPECT_EQ(judged["heuristics"][0]["heuristic"], "max(abs(cx-gx), abs(cy-gy))*1.5");
  EXPECT_EQ(judged["heuristics"][0]["admissible"], false);
  EXPECT_EQ(answer("solve - --heuristic 'abs(cx-gx)'", kBend)["cost"], answer("solve -", kBend)["cost"]);
  EXPECT_EQ(run_taut("grid solve - --heuristic cx+", kBend).code, 2);
  EXPECT_EQ(run_taut("grid solve - --heuristic '1/(cx-gx)'", kBend).code, 3);
}

TEST_F(GridHeuristics, NamesAWitness) {
  const json all = answer("heuristics - --moves 8", kBend);
  ASSERT_EQ(all["heuristics"].size(), 8U);
  for (const json& h : all["heuristics"]) {
    EXPECT_EQ(h["admissible"], h["heuristic"] != "manhattan") << h;
    EXPECT_EQ(h["consistent"], h["heuristic"] != "manhattan") << h;
  }
  const json& manhattan = all["heuristics"][1];
  EXPECT_TRUE(manhattan["overestimate"]["h"] > manhattan["overestimate"]["cost"]);
  EXPECT_EQ(manhattan["overestimate"]["cell"].size(), 2U);
  EXPECT_EQ(manhattan["violation"]["from"].size(), 2U);
  const Outcome text = run_taut("grid heuristics - --moves 4 --heuristic manhattan,biased-row", kBend);
  EXPECT_EQ(text.code, 0);
  EXPECT_THAT(text.out, ContainsRegex("manhattan,biased-row +admissible +consistent"));
}

TEST_F(GridSolve, TakesItsEndsFromTheCommandLineAlone) {
  for (const char* cells : {"0,0,1\n1,0,0\n", "0, 0, 1\n1, 0, 0\n"}) {
    EXPECT_EQ(answer("solve --start 0,0 --goal 1,2 -", cells)["straight"], 3) << cells;
    const Outcome none = run_taut("grid solve -", cells);
    EXPECT_EQ(none.code, 3);
    EXPECT_THAT(none.err, HasSubstr("says no start; give one with --start ROW,COLUMN"));
  }
}

TEST_F(GridGenerate, MakesMapsAndScenariosThatHold) {
  for (const char* kind : {"maze", "rooms", "random"}) {
    SCOPED_TRACE(kind);
    const std::string map = (folder / "a.map").string(), scen = (folder / "a.scen").string();
    const std::string command = std::string("grid generate --kind ") + kind + " --size 40x30 --seed 7 -o " + map +
                                " --scen " + scen + " --scenarios 25";
    ASSERT_EQ(run_taut(command).code, 0);
    const std::string first = contents(map) + contents(scen);
    EXPECT_THAT(run_taut("grid scen " + map + " " + scen).out, HasSubstr("25 as the file says, 0 mismatches"));
    ASSERT_EQ(run_taut(command).code, 0);
    EXPECT_EQ(contents(map) + contents(scen), first);
  }
  for (const char* options : {"--kind cave", "--size 4", "--size 0x4", "--size 30000x4", "--scenarios 0"})
    EXPECT_EQ(run_taut(std::string("grid generate ") + options).code, 2) << options;
}

}  // namespace
}  // namespace taut::test
