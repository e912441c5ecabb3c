// taut mouse and taut diff, as their users run them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "support/paths.h"
#include "support/run_program.h"

namespace taut::test {
namespace {

using nlohmann::json;
using testing::ContainsRegex;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

class Mouse : public testing::Test {
 protected:
  void SetUp() override {
    if (!program()) GTEST_SKIP() << "the program is not built";
  }
  std::string in_folder(const char* name) const { return (folder / name).string(); }

  Folder folder;
};

class MouseRun : public Mouse {};
class MouseCompare : public Mouse {};
class MouseCheck : public Mouse {};
class MouseServe : public Mouse {};
class MousePictures : public Mouse {};
class MouseSpeed : public Mouse {};
class Diff : public Mouse {};

std::string maze(const char* name) { return (data_dir() / name).string(); }

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t end = std::min(text.find('\n', from), text.size());
    lines.push_back(text.substr(from, end - from));
    from = end + 1;
  }
  return lines;
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; at += part.size()) ++n;
  return n;
}

// The goal G cannot be reached.
constexpr const char* kSealed = "o---o---o\n|   | G |\no   o---o\n| S |   |\no---o---o\n";
// Start and goal with one way, two steps.
constexpr const char* kBend = "o---o---o\n|     G |\no   o---o\n| S |   |\no---o---o\n";

TEST_F(MouseRun, PrintsATableForBothRuns) {
  const Outcome run = run_taut("mouse run " + maze("mouse_12.cells"));
  EXPECT_EQ(run.code, 0) << run.err;
  for (const char* row :
       {"run 1 ", "run 2 ", "score ", "optimum ", "proven ", "floor ", "floor with proof ", "benchmark 1 "})
    EXPECT_THAT(run.out, HasSubstr(std::string("\n  ") + row));
}

TEST_F(MouseRun, GivesTheScoreOfItsRunsAsJson) {
  for (const char* explorer : {"dfs", "bfs", "flood", "astar", "plain-prove", "prove", "score"}) {
    SCOPED_TRACE(explorer);
    const Outcome run =
        run_taut("mouse run --quick --json - --explorer " + std::string(explorer) + " " + maze("mouse_12.cells"));
    ASSERT_EQ(run.code, 0) << run.err;
    const json all = json::parse(run.out);
    EXPECT_DOUBLE_EQ(all["score"], all["run2"].get<int>() + all["run1"].get<int>() / 30.0);
    EXPECT_GE(all["run2"], all["optimum"]);
    EXPECT_DOUBLE_EQ(all["floor"], all["optimum"].get<int>() + (all["optimum"].get<int>() + 1) / 30.0);
    EXPECT_EQ(all["steps"].size(), all["run1"].get<std::size_t>() + all["run2"].get<std::size_t>());
    EXPECT_TRUE(!all["proven"].get<bool>() || all["run2"] == all["optimum"]);
    EXPECT_EQ(all["explorer"], explorer);
  }
}

TEST_F(MouseRun, ProvesInProveMode) {
  const json all = json::parse(run_taut("mouse run --quick --json - --mode prove " + maze("mouse_16.maz")).out);
  EXPECT_EQ(all["explorer"], "prove");
  EXPECT_EQ(all["proven"], true);
  EXPECT_EQ(all["run2"], all["optimum"]);
  EXPECT_EQ(json::parse(run_taut("mouse run --quick --json - " + maze("mouse_16.maz")).out)["explorer"], "score");
}

TEST_F(MouseRun, KnowsTheFirstMazeOfTheCourse) {
  const auto shared = shared_data_dir();
  if (!shared) GTEST_SKIP() << "no shared data";
  const json all =
      json::parse(run_taut("mouse run --json - " + (*shared / "micromouse/test_maze_01.txt").string()).out);
  EXPECT_EQ(all["optimum"], 17);
  EXPECT_NEAR(all["floor"], 17.6, 1e-12);
  EXPECT_NEAR(all["benchmarks"]["every_cell"], 21.8, 1e-12);
  EXPECT_GE(all["score"], all["floor"]);
}

TEST_F(MouseRun, RunsEveryCompetitionMaze) {
  const auto shared = shared_data_dir();
  if (!shared || !std::filesystem::exists(*shared / "micromouse/competition")) GTEST_SKIP() << "no shared data";
  std::size_t ran = 0, without_route = 0;
  for (const auto& entry : std::filesystem::directory_iterator(*shared / "micromouse/competition")) {
    SCOPED_TRACE(entry.path());
    const Outcome run = run_taut("mouse run --quick --json - '" + entry.path().string() + "'");
    if (run.code == 1) {
      EXPECT_THAT(run.err, HasSubstr("no way from the start to the goal"));
      ++without_route;
      continue;
    }
    ++ran;
    ASSERT_EQ(run.code, 0) << run.err;
    const json all = json::parse(run.out);
    EXPECT_GE(all["score"], all["floor"]);
  }
  EXPECT_EQ(ran + without_route, 66U);
  EXPECT_EQ(without_route, 4U);
}

TEST_F(MouseRun, SaysSoWhenTheGoalCannotBeReached) {
  for (const char* command : {"run", "serve", "speed"}) {
    SCOPED_TRACE(command);
    const Outcome run = run_taut(std::string("mouse ") + command + " " + folder.file("sealed", kSealed));
    EXPECT_EQ(run.code, 1);
    EXPECT_EQ(run.out, "");
    EXPECT_THAT(run.err, HasSubstr("no way from the start to the goal"));
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1);
  }
}

TEST_F(MouseRun, RefusesWhatIsNoGridMaze) {
  const Outcome run = run_taut("mouse run " + maze("maze_5x7.txt"));
  EXPECT_EQ(run.code, 3);
  EXPECT_THAT(run.err, HasSubstr("not a grid maze"));
  EXPECT_EQ(run_taut("mouse run " + in_folder("absent")).code, 3);
  EXPECT_EQ(run_taut("mouse run --explorer magic " + maze("mouse_12.cells")).code, 2);
  EXPECT_EQ(run_taut("mouse run --svg - --json - " + maze("mouse_12.cells")).code, 2);
  EXPECT_EQ(run_taut("mouse").code, 2);
  EXPECT_EQ(run_taut("mouse run --json " + in_folder("no/such/x") + " " + maze("mouse_12.cells")).code, 3);
}

TEST_F(MouseRun, MeasuresLongMazesAndSaysWhenNoRandomWalkerFinishes) {
  const std::string slim = in_folder("slim");
  ASSERT_EQ(run_taut("generate --kind backtracker --size 250x2 --format num -o " + slim).code, 0);
  const Outcome run = run_taut("mouse run --explorer flood " + slim);
  EXPECT_EQ(run.err, "");
  EXPECT_THAT(run.out, HasSubstr("\n  floor with proof "));
  EXPECT_THAT(run.out, HasSubstr("\n  benchmark 2               -  not ten of 1000 random walkers finish\n"));
}

TEST_F(MouseRun, FailsWithItsReasonWhenTheStepsRunOut) {
  const Outcome run = run_taut("mouse run --quick --max-steps 5 --json - " + maze("mouse_16.maz"));
  EXPECT_EQ(run.code, 4);
  EXPECT_EQ(json::parse(run.out)["score"], nullptr);
  EXPECT_THAT(run.err, HasSubstr("the steps ran out"));
}

TEST_F(MouseRun, NamesTheFileOfAMazeThatIsTooLarge) {
  const std::string large = in_folder("large");
  ASSERT_EQ(run_taut("generate --kind backtracker --size 257 --format drawing -o " + large).code, 0);
  for (const char* command : {"run", "serve", "speed", "compare"}) {
    const Outcome run = run_taut(std::string("mouse ") + command + " " + large);
    EXPECT_EQ(run.code, 3);
    EXPECT_THAT(run.err, HasSubstr(large + ": maze of 257 x 257 cells"));
  }
}

TEST_F(MouseRun, ClosesAnOpenBorderAndSaysSo) {
  const Outcome run = run_taut("mouse run --quick -", "o---o---o\n|     G |\no   o---o\n  S |   |\no---o---o\n");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.err, HasSubstr("the border has 1 opening"));
}

TEST_F(MouseRun, GivesTheSameBytesEachTime) {
  const std::string command = "mouse run --quick --explorer random --seed 3 --svg - " + maze("mouse_12.cells");
  EXPECT_EQ(run_taut(command).out, run_taut(command).out);
}

TEST_F(MouseCheck, AcceptsACertificateAndRefusesOnesThatWereTamperedWith) {
  const std::string file = in_folder("proof.json"), check = "mouse check " + maze("mouse_12.cells") + " --certificate ";
  ASSERT_EQ(run_taut("mouse run --quick -q --mode prove " + maze("mouse_12.cells") + " --certificate " + file).code, 0);
  const Outcome valid = run_taut(check + file);
  EXPECT_EQ(valid.code, 0) << valid.err;
  EXPECT_THAT(valid.out, HasSubstr(": valid: no run 2 has fewer than "));
  const json proof = json::parse(contents(file));
  const auto expect_refusal = [&](const char* what, const json& other) {
    SCOPED_TRACE(what);
    const Outcome run = run_taut(check + folder.file("other.json", other.dump()));
    EXPECT_EQ(run.code, 1) << run.out << run.err;
    EXPECT_THAT(run.out, HasSubstr("not valid: "));
  };
  json other = proof;
  other["steps"] = proof["steps"].get<int>() - 1;
  expect_refusal("fewer steps", other);
  other = proof;
  other["walls"].erase(0);
  expect_refusal("a wall missing", other);
  other = proof;
  other["walls"][0]["step"] = proof["walls"][0]["step"].get<int>() + 1;
  expect_refusal("another step", other);
  other = proof;
  other["run1"].erase(1);
  expect_refusal("a step of run 1 missing", other);
  other = proof;
  other["route"][1] = {7, 7};
  expect_refusal("another route", other);
  other = proof;
  other["openings"][0]["cell"] = {-5, 900000};
  expect_refusal("an opening nowhere", other);
  EXPECT_EQ(run_taut("mouse check " + maze("mouse_16.maz") + " --certificate " + file).code, 1);
}

TEST_F(MouseCheck, NamesWhatIsWrongWithACertificateFile) {
  const std::string check = "mouse check " + maze("mouse_12.cells") + " --certificate ";
  const auto expect_error = [&](const std::string& bytes, const char* says) {
    const Outcome run = run_taut(check + folder.file("bad.json", bytes));
    EXPECT_EQ(run.code, 3) << bytes;
    EXPECT_THAT(run.err, HasSubstr(says));
  };
  expect_error("", "not JSON");
  expect_error("{\n\"certificate\": 1,\n]", "bad.json:3: is no certificate: this is not JSON");
  expect_error("[]", "'certificate' is missing");
  expect_error("{\"certificate\": 2}", "a format other than 1");
  expect_error("{\"certificate\": 1, \"width\": 1e9}", "'width' is not a whole number");
  expect_error("{\"certificate\": 1, \"width\": 99999999999}", "'width' is out of range");
  expect_error("{\"certificate\": 1e400}", "bad.json: is no certificate: a number in it is too large");
  expect_error(std::string(100000, '['), "nested too deep");
}

TEST_F(MouseCheck, WritesNoCertificateWhereNothingIsProven) {
  const Outcome run = run_taut("mouse run --quick --explorer flood --certificate " + in_folder("none.json") + " " +
                               maze("mouse_16.maz"));
  if (run.code == 0) GTEST_SKIP() << "flood happened to prove it";
  EXPECT_EQ(run.code, 4);
  EXPECT_THAT(run.err, HasSubstr("does not prove"));
  EXPECT_FALSE(std::filesystem::exists(in_folder("none.json")));
}

TEST_F(MouseCheck, NamesEachViolationOnALine) {
  const Outcome run = run_taut("mouse check -", kBend);
  EXPECT_EQ(run.code, 1);
  EXPECT_THAT(run.out, HasSubstr("<stdin>: not legal: size 2 x 2"));
  EXPECT_THAT(run.out, HasSubstr("the goal is not the room in the middle"));
  const Outcome open = run_taut("mouse check -", "o---o---o\n|     G |\no   o   o\n  S     |\no---o---o\n");
  EXPECT_THAT(open.out, HasSubstr("the outer wall is open at (0,0) west"));
  EXPECT_THAT(open.out, HasSubstr("the start (0,0) is open to the right (east)"));
  EXPECT_THAT(open.out, HasSubstr("no wall touches the post at the upper right of (0,0)"));
  const Outcome sealed = run_taut("mouse check --json - -", kSealed);
  EXPECT_EQ(sealed.code, 1);
  EXPECT_THAT(json::parse(sealed.out)["faults"].dump(), HasSubstr("there is no way from the start to the goal"));
}

TEST_F(MouseCheck, AcceptsTheMazesOfRealContests) {
  const auto shared = shared_data_dir();
  if (!shared) GTEST_SKIP() << "no shared data";
  for (const char* name : {"japan2008ef.maz", "us96.maz", "apec2013.txt", "32MM2016HX.maze", "uk2012f.maz"}) {
    const Outcome run = run_taut("mouse check " + (*shared / "micromouse/competition" / name).string());
    EXPECT_EQ(run.code, 0) << run.out << run.err;
    EXPECT_THAT(run.out, HasSubstr(": legal, "));
  }
  const std::string course = "mouse check " + (*shared / "micromouse/test_maze_01.txt").string();
  EXPECT_EQ(run_taut(course + " --rules course").code, 0);
  EXPECT_EQ(run_taut(course).code, 1);
}

TEST_F(MouseCompare, SummarisesAllExplorersOverManyMazes) {
  const Outcome run = run_taut("mouse compare " + maze("mouse_12.cells") + " " + maze("mouse_16.maz"));
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, StartsWith("explorer "));
  EXPECT_THAT(run.out, ContainsRegex("\nscore +[0-9.]+ +[0-9.]+ +[0-9.]+ +0 "));
  EXPECT_EQ(lines_of(run.out).size(), 11U);
}

TEST_F(MouseCompare, AgreesWithSingleRuns) {
  const json all = json::parse(
      run_taut("mouse compare --explorers flood,score --json - " + maze("mouse_12.cells") + " " + maze("mouse_16.num"))
          .out);
  ASSERT_EQ(all["explorers"].size(), 2U);
  for (const json& explorer : all["explorers"]) {
    double sum = 0;
    for (const json& one : explorer["runs"]) {
      const json single =
          json::parse(run_taut("mouse run --quick --json - --explorer " + explorer["explorer"].get<std::string>() +
                               " " + one["maze"].get<std::string>())
                          .out);
      EXPECT_EQ(single["score"], one["score"]);
      sum += one["score"].get<double>();
    }
    EXPECT_NEAR(explorer["mean"], sum / 2, 1e-9);
    EXPECT_EQ(explorer["failures"], 0);
  }
}

TEST_F(MouseCompare, LeavesOutMazesWithoutARoute) {
  const std::string sealed = folder.file("sealed", kSealed);
  const Outcome run = run_taut("mouse compare --explorers flood " + sealed + " " + maze("mouse_12.cells"));
  EXPECT_EQ(run.code, 0);
  EXPECT_THAT(run.err, HasSubstr("left out"));
  EXPECT_EQ(run_taut("mouse compare " + sealed).code, 1);
  EXPECT_EQ(run_taut("mouse compare --explorers magic " + sealed).code, 2);
}

TEST_F(MouseServe, SpeaksALineAStepAndEndsWithTheScore) {
  // Up to the goal, reset, up again.
  const std::string bend = folder.file("bend", kBend);
  const Outcome run = run_taut("mouse serve " + bend, "0 1\n90 1\nreset\n0 1\n90 1\n");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.out, "0 1 0\n0 0 1\n0 0 0\n0 1 0\n0 0 1\nscore 2.100 run1 3 run2 2\n");
}

TEST_F(MouseServe, NamesTheLineThatIsGarbage) {
  const std::string serve = "mouse serve " + maze("mouse_12.cells");
  const auto expect_error = [&](const std::string& input, const char* says) {
    const Outcome run = run_taut(serve, input);
    EXPECT_EQ(run.code, 3) << input;
    EXPECT_THAT(run.err, HasSubstr(says));
    EXPECT_EQ(lines_of(run.err).size(), 1U) << run.err;
  };
  expect_error("", "<stdin>:1: ends after step 0");
  expect_error("0 1\n\n# mine\n", "<stdin>:4: ends after step 1");
  expect_error("0 1\n0 x\n", "<stdin>:2: this is neither");
  expect_error("0\n", "<stdin>:1: this is neither");
  expect_error("0 1 2\n", "<stdin>:1: this is neither");
  expect_error("reset now\n", "<stdin>:1: this is neither");
  expect_error("0 99999999999999999999\n", "<stdin>:1: this is neither");
  expect_error(std::string(5000, 'a'), "<stdin>:1: the line is too long");
}

TEST_F(MouseServe, CountsStepsThatBreakTheRulesAndNamesThem) {
  const Outcome run = run_taut("mouse serve --max-steps 4 " + folder.file("bend", kBend), "45 0\n0 9\nreset\n90 -1\n");
  EXPECT_EQ(run.code, 4);
  EXPECT_THAT(run.out, EndsWith("failed the steps ran out before run 1 reached the goal\n"));
  EXPECT_THAT(run.err, HasSubstr("<stdin>:1: rotation other than -90, 0, 90"));
  EXPECT_THAT(run.err, HasSubstr("<stdin>:2: movement beyond 3 cells"));
  EXPECT_THAT(run.err, HasSubstr("<stdin>:3: reset before the goal"));
}

TEST_F(MouseServe, GreetsWhenAsked) {
  const Outcome run = run_taut("mouse serve --hello " + folder.file("bend", kBend), "0 1\n");
  EXPECT_THAT(run.out, StartsWith("maze 2 2 0 0 1000\ngoal 1 1\n0 1 0\n"));
}

TEST_F(MouseServe, ReplaysABuiltInExplorerToTheSameScore) {
  const json own = json::parse(run_taut("mouse run --quick --json - " + maze("mouse_16.maz")).out);
  std::string actions;
  for (const json& step : own["steps"])
    actions += step.contains("reset") ? "reset\n"
                                      : std::to_string(step["action"][0].get<int>()) + " " +
                                            std::to_string(step["action"][1].get<int>()) + "\n";
  const Outcome served = run_taut("mouse serve " + maze("mouse_16.maz"), actions);
  EXPECT_EQ(served.code, 0) << served.err;
  EXPECT_THAT(served.out, HasSubstr("run1 " + std::to_string(own["run1"].get<int>()) + " run2 " +
                                    std::to_string(own["run2"].get<int>())));
}

// A robot that keeps the wall to its left, in Python: twice.
constexpr const char* kWallFollower = R"(
import sys
def line():
    text = sys.stdin.readline()
    if not text or text[0] in "sf":
        sys.stderr.write(text)
        sys.exit(0)
    return [int(word) for word in text.split()]
goal, cell, heading, run = {(1, 1)}, (0, 0), 0, 1
while True:
    left, front, right = line()
    if cell in goal and run == 1:
        print("reset", flush=True)
        cell, heading, run = (0, 0), 0, 2
        continue
    turn = -90 if left else 0 if front else 90
    go = 1 if left or front or right else 0
    heading = (heading + turn // 90) % 4
    dx, dy = [(0, 1), (1, 0), (0, -1), (-1, 0)][heading]
    cell = (cell[0] + go * dx, cell[1] + go * dy)
    print(turn, go, flush=True)
)";

TEST_F(MouseServe, LetsAProgramInAnotherLanguageBeTheRobot) {
  if (run_script("command -v python3 >/dev/null && command -v mkfifo >/dev/null").code != 0)
    GTEST_SKIP() << "no python3";
  const std::string robot = folder.file("robot.py", kWallFollower), bend = folder.file("bend", kBend);
  const std::string back = in_folder("back");
  const Outcome run = run_script("mkfifo " + back + " && \"$taut\" mouse serve " + bend + " < " + back + " | python3 " +
                                 robot + " > " + back);
  EXPECT_EQ(run.code, 0);
  EXPECT_THAT(run.err, HasSubstr("score 2.100 run1 3 run2 2"));
}

TEST_F(MouseServe, OutlivesARobotThatGoesAway) {
  const Outcome run = run_script("(printf '0 1\\n'; sleep 0.3; printf '0 1\\n0 1\\n') | { \"$taut\" mouse serve " +
                                 maze("mouse_12.cells") + "; echo code $? >&2; } | head -n 1");
  EXPECT_THAT(run.err, ContainsRegex("code [34]"));
}

TEST_F(MousePictures, ShowWhatWasSeenAndBothRoutes) {
  const Outcome run = run_taut("mouse run --quick --svg - " + maze("mouse_12.cells"));
  EXPECT_THAT(run.out, StartsWith("<svg xmlns="));
  EXPECT_THAT(run.out, EndsWith("</svg>\n"));
  for (const char* group : {"sight", "goal", "start", "seen", "unseen", "posts", "run1", "run2"})
    EXPECT_THAT(run.out, HasSubstr("<g class=\"" + std::string(group) + "\">"));
  EXPECT_THAT(run.out, Not(HasSubstr("class=\"flood\"")));
  const Outcome flood = run_taut("mouse run --quick --flood --svg - " + maze("mouse_12.cells"));
  EXPECT_THAT(flood.out, HasSubstr("class=\"flood\""));
}

TEST_F(MousePictures, PlayWithoutScript) {
  const Outcome run = run_taut("mouse run --quick --animate - " + maze("mouse_12.cells"));
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("<animateTransform attributeName=\"transform\" type=\"translate\""));
  EXPECT_THAT(run.out, HasSubstr("type=\"rotate\""));
  EXPECT_THAT(run.out, Not(HasSubstr("<script")));
  EXPECT_THAT(run.out, HasSubstr("run 2 \xC2\xB7 step 1<"));
  EXPECT_EQ(run_taut("mouse run --quick --animate - " + maze("mouse_12.cells")).out, run.out);
}

// Every list of key times rises from 0 to at most 1 and has as many entries as its values.
TEST_F(MousePictures, KeepTheirKeyTimesInOrder) {
  const std::string film = run_taut("mouse run --quick --explorer dfs --animate - " + maze("mouse_16.maz")).out;
  std::size_t lists = 0;
  for (std::size_t at = 0; (at = film.find("values=\"", at)) != std::string::npos; ++lists) {
    const std::size_t values_from = at + 8, values_to = film.find('"', values_from);
    const std::size_t keys_from = film.find("keyTimes=\"", values_to) + 10, keys_to = film.find('"', keys_from);
    const std::string keys = film.substr(keys_from, keys_to - keys_from);
    EXPECT_EQ(count(keys, ";"), count(film.substr(values_from, values_to - values_from), ";"));
    double last = 0;
    for (std::size_t from = 0; from <= keys.size();) {
      const double key = std::stod(keys.substr(from));
      EXPECT_GE(key, last);
      EXPECT_LE(key, 1.0);
      last = key;
      from = std::min(keys.find(';', from), keys.size()) + 1;
    }
    at = keys_to;
  }
  EXPECT_GT(lists, 100U);
}

TEST_F(MouseSpeed, ShowsTheFastestBesideTheShortest) {
  const Outcome run = run_taut("mouse speed " + maze("mouse_16.maz"));
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, ContainsRegex("\n  fastest +[0-9.]+ +[0-9.]+ +[0-9]+ +[0-9]+ "));
  const json all = json::parse(run_taut("mouse speed --json - " + maze("mouse_16.maz")).out);
  EXPECT_LE(all["fastest"]["seconds"], all["shortest"]["seconds"]);
  EXPECT_LE(all["shortest"]["cells"], all["fastest"]["cells"]);
  double seconds = 0;
  for (const json& drive : all["fastest"]["drives"]) seconds += drive["seconds"].get<double>();
  EXPECT_NEAR(all["fastest"]["seconds"], seconds, 1e-12);
  EXPECT_EQ(all["differences"].empty(), all["fastest"]["route"] == all["shortest"]["route"]);
}

TEST_F(MouseSpeed, TakesItsModelFromAFile) {
  const std::string query = "mouse speed --json - " + maze("mouse_16.num"), model = " --model ";
  EXPECT_EQ(run_taut(query).out, run_taut(query + model + maze("mouse_speed.json")).out);
  const std::string slow = folder.file("slow.json", R"({"straight": {"top_speed": 1.6}})");
  EXPECT_GT(json::parse(run_taut(query + model + slow).out)["fastest"]["seconds"],
            json::parse(run_taut(query).out)["fastest"]["seconds"]);
  const Outcome bad = run_taut(query + model + folder.file("bad.json", "{\"wheels\": 4}"));
  EXPECT_EQ(bad.code, 3);
  EXPECT_THAT(bad.err, HasSubstr("bad.json: unknown name 'wheels'"));
  const Outcome huge = run_taut(query + model + folder.file("huge.json", "{\"cell\": 1e400}"));
  EXPECT_EQ(huge.code, 3);
  EXPECT_THAT(huge.err, HasSubstr("huge.json: is no speed model: a number in it is too large"));
}

TEST_F(MouseSpeed, DrawsBothAndListsItsDrives) {
  const Outcome picture = run_taut("mouse speed --svg - " + maze("mouse_16.maz"));
  EXPECT_THAT(picture.out, HasSubstr("<g class=\"fastest\">"));
  EXPECT_THAT(picture.out, EndsWith("</svg>\n"));
  const Outcome drives = run_taut("mouse speed -q --drives " + maze("mouse_16.maz"));
  EXPECT_THAT(drives.out, HasSubstr(" -> 0.00 m/s\n"));
}

TEST_F(Diff, CountsTheWallsThatDiffer) {
  const std::string bend = folder.file("bend", kBend), sealed = folder.file("sealed", kSealed);
  EXPECT_EQ(run_taut("diff " + bend + " " + bend).code, 0);
  const Outcome one = run_taut("diff " + bend + " " + sealed);
  EXPECT_EQ(one.code, 1);
  EXPECT_EQ(one.out, "(0,1) east: open / wall\n1 wall differs\n");
  const json all = json::parse(run_taut("diff --json - " + bend + " " + sealed).out);
  EXPECT_EQ(all["differ"], 1);
  EXPECT_EQ(all["walls"][0]["side"], "east");
}

TEST_F(Diff, ComparesAcrossFormatsAndSizes) {
  const std::string drawing = in_folder("drawing");
  ASSERT_EQ(run_taut("convert --to drawing " + maze("mouse_16.maz") + " " + drawing).code, 0);
  const Outcome same = run_taut("diff " + maze("mouse_16.maz") + " " + drawing);
  EXPECT_EQ(same.code, 0);
  EXPECT_EQ(same.out, "no wall differs\n");
  const Outcome sizes = run_taut("diff " + maze("mouse_16.maz") + " " + maze("mouse_12.cells"));
  EXPECT_EQ(sizes.code, 1);
  EXPECT_EQ(sizes.out, "the sizes differ: 16 x 16 / 12 x 12\n");
  EXPECT_EQ(run_taut("diff " + drawing).code, 2);
  EXPECT_EQ(run_taut("diff - -").code, 3);
}

}  // namespace
}  // namespace taut::test
