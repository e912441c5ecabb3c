// What each subcommand does when all is well.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "support/program_test.h"

namespace taut::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::StartsWith;

// Two rooms joined above a wall; a dead end (1, 0)-(1, 1) on the left.
constexpr const char* kRoom = "0 0 4 0\n4 0 4 4\n4 4 0 4\n0 4 0 0\n2 0 2 3\n1 0 1 1\nstart 1 2\ngoal 3 2\n";

class Subcommand : public ProgramTest {};

TEST_F(Subcommand, SolveSaysEverythingInJson) {
  const json envelope = json::parse(run_taut("solve - --json -", kRoom).out), answer = envelope["result"];
  EXPECT_EQ(envelope["status"], "found");
  EXPECT_EQ(answer["length_text"], "2.828427124746190");
  EXPECT_EQ(answer["points"], json::parse("[[1, 2], [2, 3], [3, 2]]"));
  EXPECT_EQ(answer["corners"], 1);
  EXPECT_EQ(answer["clearance"], 0);
  EXPECT_EQ(answer["verified"], true);
  EXPECT_EQ(envelope["source"], "<stdin>");
}

TEST_F(Subcommand, SolveNamesTheWallsThatSeparateWithoutDeadEndsAndBorder) {
  const char* sealed = "0 0 4 0\n4 0 4 4\n4 4 0 4\n0 4 0 0\n2 0 2 3\n2 3 4 3\n1 0 1 1\n2 1 1 1\nstart 1 2\ngoal 3 2\n";
  const Outcome run = run_taut("solve - --json " + (folder / "a.json").string(), sealed);
  EXPECT_EQ(run.code, 1);
  EXPECT_EQ(run.out, "<stdin>: no path: these 2 walls separate start and goal: (4, 3)-(2, 3), (2, 3)-(2, 0)\n");
  const json envelope = json::parse(contents(folder / "a.json")), answer = envelope["result"];
  EXPECT_EQ(envelope["status"], "none");
  EXPECT_EQ(answer["separation"], json::parse("[[[4, 3], [2, 3]], [[2, 3], [2, 0]]]"));
  EXPECT_FALSE(answer.contains("points"));
}

TEST_F(Subcommand, SolvePrintsThePoints) { EXPECT_EQ(run_taut("solve - --path -q", kRoom).out, "1 2\n2 3\n3 2\n"); }

TEST_F(Subcommand, SolveGivesTheSamePathByBothAlgorithms) {
  const Outcome maze = run_taut("generate --size 30 --loops 0.1 --seed 5");
  const Outcome astar = run_taut("solve - --path -q", maze.out);
  EXPECT_EQ(astar.code, 0);
  EXPECT_EQ(run_taut("solve - --path -q --algorithm dijkstra", maze.out).code, 0);
  EXPECT_EQ(run_taut("solve - --path -q", maze.out).out, astar.out);
}

TEST_F(Subcommand, SolvePutsStatisticsOnStderrOnly) {
  const Outcome run = run_taut("solve - --stats --roadmap visibility", kRoom);
  EXPECT_THAT(run_taut("solve - --stats", kRoom).err, HasSubstr("navigation mesh"));
  EXPECT_THAT(run.out, StartsWith("<stdin>: length"));
  for (const char* word : {"read", "space", "triangles", "vertices", "edge", "expanded", "displacement", "peak memory"})
    EXPECT_THAT(run.err, HasSubstr(word));
}

TEST_F(Subcommand, SolveMovesARobotOfSomeSize) {
  const Outcome point = run_taut("solve - --path -q", kRoom),
                square = run_taut("solve - --path -q --robot square:0.25", kRoom);
  EXPECT_EQ(square.out, "1 2\n1.75 3.25\n2.25 3.25\n3 2\n");
  EXPECT_NE(point.out, square.out);
  EXPECT_EQ(run_taut("solve - --robot square:0.6", kRoom).code, 1);  // 1 between the wall and the top
}

TEST_F(Subcommand, CheckCountsWhatIsThere) {
  const json envelope = json::parse(run_taut("check - --json -", kRoom).out), answer = envelope["result"];
  EXPECT_EQ(envelope["status"], "done");
  EXPECT_EQ(answer["format"], "segments");
  EXPECT_EQ(answer["walls"], 6);
  EXPECT_EQ(answer["free_space"]["area"], 16);
  EXPECT_EQ(answer["free_space"]["components"], 1);
  EXPECT_EQ(answer["free_space"]["reflex_corners"], 2);
  EXPECT_EQ(answer["path"], nullptr);
  EXPECT_THAT(run_taut("check -", kRoom).out, StartsWith("<stdin>: valid, segments\n"));
}

TEST_F(Subcommand, CheckJudgesPaths) {
  const std::string world = folder.file("room.txt", kRoom);
  const auto check = [&](const char* points) { return run_taut("check " + world + " --path -", points); };
  EXPECT_EQ(check("1 2\n2 3\n3 2\n").code, 0);
  EXPECT_EQ(check("# a detour\n1 2\n1 3.5\n3,3.5\n3 2\n").code, 0);
  const Outcome through = check("1 2\n3 2\n");
  EXPECT_EQ(through.code, 1);
  EXPECT_THAT(through.out, HasSubstr("not valid: "));
  EXPECT_EQ(check("[[1, 2], [2, 3], [3, 2]]").code, 0);
  EXPECT_EQ(check("{\"points\": [[1, 2], [2, 3], [3, 2]], \"length\": 2.8284271247461903}").code, 0);
  EXPECT_EQ(check("{\"points\": [[1, 2], [2, 3], [3, 2]], \"length\": 2.8}").code, 1);
  EXPECT_EQ(check("1 2\n2 3\n").code, 1);
  EXPECT_EQ(check("1 2\n2\n").code, 3);
  EXPECT_EQ(check("").code, 3);
}

TEST_F(Subcommand, CheckAcceptsWhatSolveFinds) {
  const std::string world = folder.file("maze.txt", run_taut("generate --size 21x13 --loops 0.2 --seed 3").out);
  const Outcome answer = run_taut("solve --json - " + world);
  EXPECT_EQ(run_taut("check " + world + " --path -", answer.out).code, 0);
}

TEST_F(Subcommand, RoadmapCountsAndWritesTheGraph) {
  const Outcome reduced = run_taut("roadmap - ", kRoom);
  EXPECT_THAT(reduced.out, StartsWith("<stdin>: reduced visibility graph, 2 vertices, "));
  const json graph = json::parse(run_taut("roadmap - --kind full --json -", kRoom).out)["result"];
  EXPECT_EQ(graph["kind"], "full visibility graph");
  EXPECT_GT(graph["edges"].size(), 10U);
  for (const json& edge : graph["edges"]) EXPECT_LT(edge[0], edge[1]);
  EXPECT_THAT(run_taut("roadmap - --svg -", kRoom).out, HasSubstr("class=\"roadmap\""));
}

TEST_F(Subcommand, GenerateMakesTheSameMazeFromTheSameSeed) {
  const std::string maze = run_taut("generate --size 9x5 --seed 4").out;
  EXPECT_THAT(maze, StartsWith("# taut generate --size 9x5 --kind biased --seed 4\n"));
  EXPECT_EQ(run_taut("generate --size 9x5 --seed 4").out, maze);
  EXPECT_NE(run_taut("generate --size 9x5 --seed 5").out, maze);
  const json box = json::parse(run_taut("check - --json -", maze).out)["result"]["box"];
  EXPECT_EQ(box, json::parse("[0.5, 0.5, 9.5, 5.5]"));  // width x height
}

TEST_F(Subcommand, GenerateAndSolveWorkInAPipe) {
  const Outcome maze = run_taut("generate --size 45x45 --seed 1"),
                run = run_taut("solve - --svg " + (folder / "a.svg").string(), maze.out);
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(contents(folder / "a.svg"), HasSubstr("class=\"path\""));
}

TEST_F(Subcommand, GenerateWritesEveryGridFormat) {
  for (const char* format : {"segments", "drawing", "num", "maz", "geojson"}) {
    SCOPED_TRACE(format);
    const Outcome maze = run_taut(std::string("generate --size 16 --seed 2 --as ") + format);
    EXPECT_EQ(maze.code, 0) << maze.err;
    const json world = json::parse(run_taut("check - --json -", maze.out).out)["result"];
    EXPECT_EQ(world["format"], format);
    EXPECT_EQ(world["free_space"]["area"], 256);
  }
}

TEST_F(Subcommand, ConvertKeepsTheAnswer) {
  const std::string maze =
      folder.file("maze.txt", run_taut("generate --size 16 --kind backtracker --as drawing --seed 7").out);
  const std::string answer = run_taut("solve --path -q " + maze).out;
  for (const char* format : {"segments", "drawing", "geojson"}) {
    SCOPED_TRACE(format);
    const std::string other = (folder / format).string();
    const Outcome run = run_taut("convert " + maze + " " + other + " --as " + format);
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(run_taut("solve --path -q " + other).out, answer);
  }
}

TEST_F(Subcommand, ConvertRefusesWhatAFormatCannotHold) {
  const Outcome run = run_taut("convert - --as maz", kRoom);
  EXPECT_EQ(run.code, 3);
  EXPECT_EQ(run.out, "");
}

}  // namespace
}  // namespace taut::test
