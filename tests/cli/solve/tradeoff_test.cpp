// taut solve --tradeoff
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "support/program_test.h"

namespace taut::test {
namespace {

using nlohmann::json;
using testing::ContainsRegex;
using testing::HasSubstr;

class SolveTradeoff : public ProgramTest {};

std::string ends_of(const json& rows) {
  std::string ends;
  for (const json& row : rows) ends += (ends.empty() ? "" : " ") + row["then"].get<std::string>();
  return ends;
}

TEST_F(SolveTradeoff, NamesEveryRadiusAtWhichTheWayChanges) {
  const std::string query = "solve --tradeoff " + data_file("three_ways.txt");
  const Outcome run = run_taut(query + " --svg " + in_folder("a.svg"));
  EXPECT_EQ(run.code, 0);
  EXPECT_THAT(run.out, ContainsRegex("^ +radius up to  length from "));
  EXPECT_THAT(run.out,
              ContainsRegex("0.2  +18.000000  18.000000  closed: 2/5 between \\(10, 5.8\\) and \\(10, 6.2\\)\n"));
  EXPECT_THAT(run.out, ContainsRegex("a further corner\n"));
  EXPECT_THAT(run.out, ContainsRegex("0.76268[0-9]+  +18.577717  19.525804  another way is shorter\n"));
  EXPECT_THAT(run.out, ContainsRegex("no larger disc: .*between \\(10, 1\\) and \\(10, 3\\)\n"));
  const json answer = json::parse(run_taut(query + " --json -").out)["result"], rows = answer["tradeoff"];
  EXPECT_EQ(ends_of(rows), "closed bend shorter last");
  EXPECT_EQ(rows[0]["gate"]["width_text"], "2/5");
  EXPECT_NEAR(rows[2]["length"], rows[3]["length_above"], 1e-9);
  EXPECT_EQ(rows[3]["radius"], 1);
  EXPECT_EQ(answer["verified"], true);
  const std::string picture = contents(in_folder("a.svg"));
  EXPECT_THAT(picture, HasSubstr("<g class=\"shades\">"));
  EXPECT_THAT(picture, HasSubstr("radius of the robot"));
  EXPECT_EQ(picture.find("<animate"), std::string::npos);
}

TEST_F(SolveTradeoff, GivesTheLengthOfEveryRadiusAsAFormula) {
  const json row =
      json::parse(run_taut("solve --tradeoff --json - " + data_file("three_ways.txt")).out)["result"]["tradeoff"][2];
  const double r = 0.5;
  double length = row["formula"]["constant"].get<double>() + row["formula"]["angle"].get<double>() * r;
  for (const json& leg : row["formula"]["legs"]) {
    const double d = leg[0], x = leg[1].get<double>() * r;
    length += std::sqrt(d * d - x * x) + x * std::asin(x / d);
  }
  const json alone =
      json::parse(run_taut("solve --arcs --robot disc:0.5 --json - " + data_file("three_ways.txt")).out)["result"];
  EXPECT_NEAR(length, alone["length"], 1e-12);
}

TEST_F(SolveTradeoff, FilmsTheDiscThatGrows) {
  EXPECT_EQ(run_taut("solve --tradeoff --animate " + in_folder("a.svg") + " " + data_file("three_ways.txt")).code, 0);
  const std::string film = contents(in_folder("a.svg"));
  EXPECT_THAT(film, HasSubstr("<animate attributeName=\"stroke-width\""));
  EXPECT_THAT(film, HasSubstr("<animate attributeName=\"cx\""));
  EXPECT_THAT(film, HasSubstr("class=\"pause\""));
  EXPECT_EQ(run_taut("solve --animate " + in_folder("a.svg") + " " + data_file("three_ways.txt")).code, 2);
}

// The start is 0.05 from a wall, the doors are 0.4 and 1.2 wide.
TEST_F(SolveTradeoff, GoesOnWhereAnEndIsNearAWall) {
  const std::string world = "boundary 0 0 10 6\nstart 1 1.05\ngoal 9 1\n0 1 3 1\n5 0 5 0.8\n5 1.2 5 2.6\n5 3.8 5 6\n";
  const json rows = json::parse(run_taut("solve - --tradeoff --json -", world).out)["result"]["tradeoff"];
  const auto ends_by = [&](const char* end) {
    return std::ranges::find_if(rows, [&](const json& row) { return row["then"] == end; });
  };
  const auto left = ends_by("left");
  ASSERT_NE(left, rows.end());
  EXPECT_EQ((*left)["radius"], 0.05);
  const json next = *(left + 1);
  EXPECT_NEAR(next["aside"].get<double>(), 0.55, 1e-12);
  EXPECT_EQ(next["way"]["start"], json::parse("[1, 1.6]"));
  EXPECT_EQ(rows.back()["radius"], 0.6);
  const auto closed = ends_by("closed");
  ASSERT_NE(closed, rows.end());
  EXPECT_EQ((*closed)["radius"], 0.2);
}

TEST_F(SolveTradeoff, SaysWhichWallsLeaveNoWay) {
  const Outcome run = run_taut("solve - --tradeoff", "boundary 0 0 4 4\nstart 1 1\ngoal 3 3\n2 0 2 4\n");
  EXPECT_EQ(run.code, 1);
  EXPECT_THAT(run.out, HasSubstr("no path: this wall separates start and goal"));
}

// A wall with doors, each wider and farther off than the one before: every door is a trade.
std::string doors(int count) {
  const std::string height = std::to_string(4 * count + 4);
  std::string world = "boundary 0 0 40 " + height + "\nstart 10 3\ngoal 30 3\n";
  std::string from = "0";
  for (int i = 1; i <= count; ++i) {
    world += "20 " + from + " 20 " + std::to_string(4 * i) + "\n";
    from = std::to_string(4 * i + 1 + i / 1000.0);
  }
  return world + "20 " + from + " 20 " + height + "\n";
}

TEST_F(SolveTradeoff, KeepsTheWaysWhenItIsStopped) {
  const std::string world = folder.file("doors.txt", doors(25));
  for (double seconds = 0.02; seconds < 60; seconds *= 1.6) {
    const Outcome run = run_taut("solve --tradeoff --max-seconds " + std::to_string(seconds) + " --json " +
                                 in_folder("a.json") + " " + world);
    const json answer = json::parse(contents(in_folder("a.json"))), result = answer["result"];
    if (run.code == 0) {
      EXPECT_GE(result["tradeoff"].size(), 25U);
      break;
    }
    ASSERT_EQ(run.code, 4) << run.err;
    EXPECT_EQ(answer["status"], "stopped");
    if (!result.contains("verified")) continue;  // before the first search
    EXPECT_EQ(result["verified"], false);
    EXPECT_EQ(static_cast<std::size_t>(std::count(run.out.begin(), run.out.end(), '\n')),
              result["tradeoff"].empty() ? 0 : 1 + result["tradeoff"].size());
  }
}

TEST_F(SolveTradeoff, IsTheSameEveryTime) {
  const std::string query = "solve --tradeoff " + data_file("maze_25x25.txt");
  EXPECT_EQ(run_taut(query).out, run_taut(query).out);
  EXPECT_EQ(run_taut(query + " --path").code, 2);
}

}  // namespace
}  // namespace taut::test
