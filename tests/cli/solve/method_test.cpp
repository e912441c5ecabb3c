// taut solve --algorithm NAME --heuristic NAME.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "support/program_test.h"

namespace taut::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

// Over the short wall's end it is shorter than round the other way.
constexpr const char* kRoom = "boundary 0 0 10 10\n3 0 3 7\n6 3 6 10\nstart 1 1\ngoal 9 9\n";

class MethodProgram : public ProgramTest {
 protected:
  static json answer(const std::string& options) {
    const Outcome run = run_taut("solve - --json - " + options, kRoom);
    EXPECT_EQ(run.code, 0) << options << ": " << run.err;
    return json::parse(run.out)["result"];
  }
};

TEST_F(MethodProgram, FindsAValidPathByEveryName) {
  const double shortest = answer("")["length"];
  for (const char* algorithm : {"astar", "dijkstra", "bfs", "dfs", "greedy"})
    for (const char* kind : {"visibility", "full", "prm"}) {
      SCOPED_TRACE(std::string(algorithm) + " " + kind);
      const json found = answer(std::string("--algorithm ") + algorithm + " --roadmap " + kind);
      EXPECT_EQ(found["algorithm"], algorithm);
      EXPECT_TRUE(found["verified"]);
      EXPECT_GE(found["length"], shortest);
      const bool exact = (found["algorithm"] == "astar" || found["algorithm"] == "dijkstra");
      EXPECT_EQ(found["optimal"], exact && found["roadmap"] != "prm");
      if (found["optimal"]) {
        EXPECT_EQ(found["length"], shortest);
      }
    }
}

TEST_F(MethodProgram, TakesTheVisibilityGraphWhereNoRoadmapIsNamed) {
  EXPECT_EQ(answer("")["roadmap"], "polyanya");
  EXPECT_FALSE(answer("").contains("algorithm"));
  EXPECT_EQ(answer("--algorithm astar")["roadmap"], "visibility");
  EXPECT_EQ(answer("--heuristic zero")["roadmap"], "visibility");
  EXPECT_EQ(answer("--heuristic zero")["heuristic"], "zero");
  EXPECT_FALSE(answer("--algorithm dijkstra").contains("heuristic"));
}

TEST_F(MethodProgram, SaysWhereManhattanOverestimates) {
  const json found = answer("--heuristic manhattan");
  EXPECT_EQ(found["optimal"], false);
  EXPECT_GT(found["overestimate"]["estimate"], found["overestimate"]["cost"]);
  const Outcome line = run_taut("solve - --heuristic manhattan", kRoom);
  EXPECT_THAT(line.out,
              HasSubstr("astar with manhattan in the roadmap visibility; not proven optimal: manhattan says"));
  EXPECT_THAT(run_taut("solve - --heuristic euclidean", kRoom).out, Not(HasSubstr("not proven")));
  for (const char* heuristic : {"euclidean", "chebyshev", "zero"}) {
    const json exact = answer(std::string("--heuristic ") + heuristic);
    EXPECT_EQ(exact["optimal"], true) << heuristic;
    EXPECT_FALSE(exact.contains("overestimate")) << heuristic;
  }
}

TEST_F(MethodProgram, PullsTautWhatIsNotShortest) {
  const Outcome run = run_taut("solve - --algorithm dfs --shorten", kRoom);
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("pulled taut"));
  EXPECT_EQ(run_taut("solve - --algorithm dijkstra --shorten", kRoom).code, 2);
}

TEST_F(MethodProgram, ProvesThatThereIsNone) {
  const std::string sealed = "boundary 0 0 10 10\n3 0 3 10\nstart 1 1\ngoal 9 9\n";
  for (const char* algorithm : {"astar", "dijkstra", "bfs", "dfs", "greedy"})
    EXPECT_EQ(run_taut(std::string("solve - --algorithm ") + algorithm, sealed).code, 1) << algorithm;
}

TEST_F(MethodProgram, RefusesWhatHasNoGraphOrNoHeuristic) {
  for (const char* options :
       {"--algorithm magic", "--heuristic magic", "--algorithm dijkstra --heuristic euclidean",
        "--algorithm bfs --heuristic zero", "--roadmap polyanya --algorithm dijkstra",
        "--roadmap polyanya --heuristic zero", "--roadmap voronoi --algorithm bfs", "--widest --algorithm astar",
        "--arcs --robot disc:0.1 --algorithm astar", "--anytime --heuristic zero"})
    EXPECT_EQ(run_taut(std::string("solve - ") + options, kRoom).code, 2) << options;
  EXPECT_EQ(run_taut("solve - --roadmap voronoi --algorithm dijkstra", kRoom).code, 0);
}

}  // namespace
}  // namespace taut::test
