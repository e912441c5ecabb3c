// --snap: what nearly touches, seen and joined, in every subcommand that reads a world.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "support/program_test.h"
#include "support/turned.h"
#include "taut/geometry/text.h"

namespace taut::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

// A room whose last corner was clicked 0.01 mm beside the first one, on a floor of 12 m.
constexpr const char* kCracked =
    "boundary -1 -1 11 11\n0 0 4 1\n4 1 4 5\n4 5 0 5\n0 5 -0.000006 0.000008\nstart 2 3\ngoal 8 8\n";

/// A wall across, and one on it at x, turned by 20 degrees: nothing passes from the one side to the other.
std::string turned(double x = 3) {
  const Turn turn(20);
  std::string file;
  const auto line = [&](const char* head, std::vector<Point> points) {
    file += head;
    for (const Point p : points) {
      append(file += ' ', turn(p).x);
      append(file += ' ', turn(p).y);
    }
    file += '\n';
  };
  line("boundary", {{0, 0}, {10, 0}, {10, 10}, {0, 10}});
  line("", {{0, 4}, {10, 4}});
  line("", {{x, 4}, {x, 10}});
  line("start", {{1, 8}});
  line("goal", {{9, 8}});
  return file;
}

class SnapProgram : public ProgramTest {};

TEST_F(SnapProgram, ClosesACrackThatItIsToldOf) {
  const Outcome open = run_taut("solve -", kCracked);
  EXPECT_EQ(open.code, 0);
  EXPECT_THAT(open.err, HasSubstr("nearly touch"));
  for (const char* how : {"auto", "0.00001", "0.001"}) {
    const Outcome closed = run_taut(std::string("solve - --json - --snap ") + how, kCracked);
    EXPECT_EQ(closed.code, 1) << how << closed.err;
    EXPECT_THAT(closed.err, HasSubstr("1 end joined to other walls, moved by at most 1e-05"));
    const json snap = json::parse(closed.out)["result"]["snap"];
    EXPECT_EQ(snap["joined"], 1);
    EXPECT_DOUBLE_EQ(snap["displacement"], 0.00001);
  }
  EXPECT_EQ(run_taut("solve - --snap 0.000009", kCracked).code, 0);
}

TEST_F(SnapProgram, JoinsByItselfOnlyWhatRoundingKeptApart) {
  int open = 0;
  for (const double x : {2.0, 3.0, 4.7, 5.3}) {
    const Outcome joined = run_taut("solve -", turned(x));
    EXPECT_EQ(joined.code, 1) << joined.err;
    EXPECT_THAT(joined.err, HasSubstr("joined to other walls, moved by at most"));
    open += run_taut("solve - --snap 0", turned(x)).code == 0;
  }
  EXPECT_GT(open, 0);
}

TEST_F(SnapProgram, ListsWhatNearlyTouchesInCheck) {
  const Outcome check = run_taut("check - --json " + in_folder("a.json"), kCracked);
  EXPECT_EQ(check.code, 0);
  EXPECT_THAT(check.out, HasSubstr("(line 2)"));
  EXPECT_THAT(check.out, HasSubstr("is 1e-05 from"));
  const json near = json::parse(contents(folder / "a.json"))["result"]["near"];
  ASSERT_EQ(near.size(), 1U);
  EXPECT_DOUBLE_EQ(near[0]["distance"], 0.00001);
  EXPECT_THAT(run_taut("check - --snap auto", kCracked).out,
              HasSubstr("joined      1 contact, moved by at most 1e-05"));
}

TEST_F(SnapProgram, RefusesWhatItWouldHaveToMoveFarther) {
  constexpr const char* kRow = "boundary 0 0 10 10\n5 1 5 9\n5.03 1 5.03 0\n5.06 1 5.06 9\n5.09 1 5.09 0\n";
  const Outcome run = run_taut("check - --snap 0.04", kRow);
  EXPECT_EQ(run.code, 3);
  EXPECT_THAT(run.err, HasSubstr("leaves contacts that it would have to move farther for"));
  EXPECT_EQ(run_taut("check - --snap 0.1", kRow).code, 0);
}

TEST_F(SnapProgram, IsTheSameForAllThatReadWorlds) {
  const std::string file = folder.file("cracked.txt", kCracked);
  for (const char* command :
       {"solve", "compare", "bug", "solve --arcs --robot disc:0.0000001", "roadmap", "space -o - --as wkt"}) {
    const Outcome run = run_taut(std::string(command) + " " + file + " --snap auto");
    EXPECT_THAT(run.err, HasSubstr("1 end joined")) << command;
  }
  EXPECT_THAT(run_taut("drive " + file + " --car length=0.1,width=0.05,radius=0.1 --snap auto").err,
              HasSubstr("1 end joined"));
  EXPECT_THAT(run_taut("batch " + file + " - --snap auto", "2 3 8 8\n").out, HasSubstr("none"));
}

TEST_F(SnapProgram, CopiesAWorldAsItIsUnlessToldOtherwise) {
  EXPECT_THAT(run_taut("convert - --as segments", turned()).err, Not(HasSubstr("joined")));
  EXPECT_THAT(run_taut("convert - --as segments --snap auto", turned()).err, HasSubstr("joined"));
}

TEST_F(SnapProgram, PutsQueriesOnTheWallThatTheyAreWithinRoundingOf) {
  const Turn turn(20);
  const auto place = [&](Point p) { return text(turn(p).x) + " " + text(turn(p).y); };
  const std::string file = folder.file("turned.txt", turned());
  // From a point on the first wall to both of its sides.
  for (const Point to : {Point{1, 9}, Point{1, 1}}) {
    const Outcome run = run_taut("batch " + file + " -", place({1, 4}) + " " + place(to) + "\n");
    EXPECT_THAT(run.out, Not(HasSubstr("none"))) << run.err;
  }
}

TEST_F(SnapProgram, WantsADistance) {
  for (const char* wrong : {"-1", "much", "nan"})
    EXPECT_EQ(run_taut(std::string("check - --snap=") + wrong, kCracked).code, 2) << wrong;
}

}  // namespace
}  // namespace taut::test
