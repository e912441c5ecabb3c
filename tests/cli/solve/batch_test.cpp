// taut batch, and grid maps in the program.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "support/program_test.h"
#include "support/text.h"

namespace taut::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

constexpr const char* kMap =
    "type octile\nheight 5\nwidth 5\nmap\n"
    ".....\n"
    ".@@@.\n"
    ".@.@.\n"
    ".@@@.\n"
    ".....\n";

class Batch : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    map = folder.file("x.map", kMap);
  }
  Outcome run(const std::string& queries, const std::string& options = "") {
    return run_taut("batch " + map + " - " + options, queries);
  }
  std::string map;
};

TEST_F(Batch, TakesScenariosBetweenCornersOfCells) {
  const Outcome good = run("version 1\r\n0 x.map 5 5 0 0 5 0 5\r\n3 x.map 5 5 0 0 5 5 10\r\n\r\n");
  EXPECT_THAT(good.out, HasSubstr("2 5\n"));
  EXPECT_EQ(good.code, 1) << "around the block it is shorter than 10";
  EXPECT_THAT(good.err, HasSubstr("<stdin>:3: expected 10, found 8.24621125"));
  EXPECT_EQ(run("version 1\n0 x.map 5 5 0 0 5 5 8.24621\n").code, 0);
  EXPECT_EQ(run("version 1\n0 x.map 5 5 0 0 5 5 8.2462\n").code, 0);
  EXPECT_EQ(run("version 1\n0 x.map 5 5 0 0 5 5 8.2463\n").code, 1);
}

TEST_F(Batch, RefusesScenariosOfAnotherMapOrVersion) {
  const Outcome size = run("version 1\n0 x.map 6 5 0 0 5 5 8\n");
  EXPECT_EQ(size.code, 3);
  EXPECT_THAT(size.err, HasSubstr("<stdin>:2: is for a map of 6 x 5 cells"));
  EXPECT_THAT(run("version 2\n").err, HasSubstr("<stdin>:1: version '2' is not known"));
  EXPECT_THAT(run("version 1\n0 x.map 5 5 0 0 6 5 8\n").err, HasSubstr("<stdin>:2: the goal lies outside"));
}

TEST_F(Batch, AnswersEachLineInTheMapsOwnCoordinates) {
  const Outcome outcome = run("# head\n0.5 0.5 4.5 0.5\n\n0.5 0.5 4.5 4.5 # corner to corner\n0.5,0.5,0.5,0.5\n");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "2 4\n4 7.0710678118654755\n5 0\n");
  EXPECT_THAT(outcome.err, HasSubstr("3 queries, 0 without an answer, 0 compared, 0 mismatches"));
}

TEST_F(Batch, ComparesWhereALengthIsGivenAndNamesMismatches) {
  const Outcome outcome = run("0.5 0.5 4.5 0.5 4.0000005\n0.5 0.5 4.5 0.5 4.1\n0.5 0.5 2.5 2.5 none\n", "-q");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_EQ(outcome.out, "");
  EXPECT_THAT(outcome.err, HasSubstr("<stdin>:2: expected 4.1, found 4"));
  EXPECT_THAT(outcome.err, HasSubstr("3 queries, 0 without an answer, 3 compared, 1 mismatch;"));
}

TEST_F(Batch, SaysNoneAndBlockedAndGoesOn) {
  const Outcome outcome = run("0.5 0.5 2.5 2.5\n1.5 1.5 0.5 0.5\n0.5 0.5 9 9\n0.5 0.5 0.5 1.5\n");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_EQ(outcome.out, "1 none\n2 blocked\n3 blocked\n4 1\n");
  EXPECT_THAT(outcome.err, HasSubstr("3 without an answer"));
}

TEST_F(Batch, SpeaksJsonLines) {
  const Outcome outcome = run("0.5 0.5 4.5 0.5 4\n1.5 1.5 0.5 0.5\n", "--json-lines --path");
  const std::size_t end = outcome.out.find('\n');
  EXPECT_EQ(json::parse(outcome.out.substr(0, end)),
            json::parse(R"({"line": 1, "status": "found", "length": 4.0, "expected": 4.0, "matches": true,
                            "path": [[0.5, 0.5], [4.5, 0.5]]})"));
  EXPECT_EQ(
      json::parse(outcome.out.substr(end)),
      json::parse(R"({"line": 2, "status": "blocked", "blocked": "start", "nearest": [1.0, 1.5], "distance": 0.5})"));
}

TEST_F(Batch, SumsUpInTheEnvelope) {
  const Outcome outcome = run("0.5 0.5 4.5 0.5 4\n1.5 1.5 0.5 0.5\n", "--path --json " + (folder / "a.json").string());
  EXPECT_EQ(outcome.out, "1 4 0.5 0.5 4.5 0.5\n2 blocked\n");
  const json envelope = json::parse(contents(folder / "a.json")), answer = envelope["result"];
  EXPECT_EQ(envelope["status"], "none");
  EXPECT_EQ(answer["queries"], 2);
  EXPECT_EQ(answer["unanswered"], 1);
  EXPECT_EQ(answer["answers"][0]["path"], json::parse("[[0.5, 0.5], [4.5, 0.5]]"));
  EXPECT_EQ(answer["answers"][1]["blocked"], "start");
  EXPECT_THAT(outcome.err, HasSubstr(" us CPU a query"));
}

TEST_F(Batch, PrintsAndKeepsTheAnswersSoFarWhenStopped) {
  const std::string file = (folder / "a.json").string();
  const Outcome outcome = run_script("(echo 0.5 0.5 4.5 0.5; echo 0.5 0.5 0.5 0.5; sleep 4) | \"$taut\" batch \"" +
                                     map + "\" - --max-seconds 1 --json \"" + file + "\"");
  EXPECT_EQ(outcome.code, 4) << outcome.err;
  EXPECT_EQ(outcome.out, "1 4\n2 0\n");
  EXPECT_THAT(outcome.err, HasSubstr("2 queries, "));
  const json envelope = json::parse(contents(file));
  EXPECT_EQ(envelope["status"], "stopped");
  EXPECT_EQ(envelope["result"]["answers"].size(), 2U);
}

TEST_F(Batch, RefusesBrokenLinesByNumber) {
  const Outcome few = run("0.5 0.5 4.5 0.5\n1 2 3\n");
  EXPECT_EQ(few.code, 3);
  EXPECT_THAT(few.err, HasSubstr("<stdin>:2: too few numbers"));
  EXPECT_THAT(run("1 2 3 x\n").err, HasSubstr("<stdin>:1: 'x' is not a number"));
  EXPECT_THAT(run("1 2 3 4 5 6\n").err, HasSubstr("'6' follows the length"));
  EXPECT_EQ(run_taut("batch - -", kMap).code, 2);
  EXPECT_EQ(run_taut("batch " + map + " /nowhere/x").code, 3);
}

TEST_F(Batch, AnswersALineBeforeTheNextOneComes) {
  const Outcome outcome = run_script("mkfifo \"" + (folder / "in").string() + "\" \"" + (folder / "out").string() +
                                     "\"\n\"$taut\" batch \"" + map + "\" - < \"" + (folder / "in").string() +
                                     "\" > \"" + (folder / "out").string() +
                                     "\" 2>/dev/null &\n"
                                     "exec 3> \"" +
                                     (folder / "in").string() + "\" 4< \"" + (folder / "out").string() +
                                     "\"\n"
                                     "echo 0.5 0.5 4.5 0.5 >&3; read answer <&4; echo \"got $answer\"\n"
                                     "echo 0.5 0.5 0.5 0.5 >&3; read answer <&4; echo \"got $answer\"\n"
                                     "exec 3>&-; wait\n");
  EXPECT_EQ(outcome.out, "got 1 4\ngot 2 0\n") << outcome.err;
}

TEST_F(Batch, TakesAnyWorldAndPackedFiles) {
  const std::string maze = (data_dir() / "maze_25x25.txt").string(), packed = (folder / "maze.gz").string(),
                    queries = folder.file("q", "0.5 0.5 0.5 0.5 0\n");
  const Outcome outcome = run_script("gzip -c '" + maze + "' > '" + packed + "' && gzip '" + queries +
                                     "' && \"$taut\" batch '" + packed + "' '" + queries + ".gz'");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "1 0\n");
}

TEST_F(Batch, GridMapsAreWorldsForTheOthersToo) {
  const Outcome outcome =
      run_taut("solve " + map + " --from 0.5,0.5 --to 4.5,4.5 --svg " + (folder / "x.svg").string());
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("length 7.071068"));
  EXPECT_EQ(run_taut("solve " + map + " --from 0.5,0.5 --to 2.5,2.5").code, 1);
  EXPECT_EQ(run_taut("solve " + map + " --from 1.5,1.5 --to 0.5,0.5").code, 3);
}

TEST_F(Batch, SolvesTheSameWithAndWithoutAGraph) {
  const std::string maze = "solve " + (data_dir() / "maze_61x61_loops.txt").string();
  const std::string fast = run_taut(maze + " --json -").out,
                    graph = run_taut(maze + " --roadmap visibility --json -").out;
  EXPECT_EQ(json::parse(fast)["result"]["length_text"], json::parse(graph)["result"]["length_text"]);
  EXPECT_EQ(json::parse(fast)["result"]["roadmap"], "polyanya");
  EXPECT_EQ(run_taut(maze + " --roadmap polyanya --save x").code, 2);
}

TEST_F(Batch, AnswersAlikeOnceItHasAGraphAndLandmarks) {
  map = in_folder("maze.txt");
  ASSERT_EQ(run_taut("generate --size 40x40 --loops 0.2 --seed 2 -o " + map).code, 0);
  std::string once;
  for (int n = 0; n < 400; ++n)
    for (const int k : {7, 11, 13, 17}) once += std::to_string(n * k % 40 + 1) + (k < 17 ? ".25 " : "\n");
  const Outcome outcome = run(once + once, "--path");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const std::vector<std::string> lines = lines_of(outcome.out);
  ASSERT_EQ(lines.size(), 800u);
  for (std::size_t i = 0; i < 400; ++i) {
    const std::string first = lines[i].substr(lines[i].find(' ') + 1), second = lines[i + 400].substr(4);
    EXPECT_EQ(first.substr(0, first.find(' ')), second.substr(0, second.find(' '))) << lines[i];
  }
}

}  // namespace
}  // namespace taut::test
