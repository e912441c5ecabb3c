// taut chase plane, as its users run it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "support/program_test.h"

namespace taut::test {
namespace {

using nlohmann::json;
using testing::ContainsRegex;
using testing::HasSubstr;

constexpr const char* kRoom = "boundary 0 0 10 10\nstart 1 1\n5 0 5 8\n";

class ChasePlane : public ProgramTest {
 protected:
  std::string plane(const std::string& way, const std::string& options = "") {
    return "chase plane " + folder.file("room", kRoom) + " --target " + folder.file("way", way) + " " + options;
  }
};

TEST_F(ChasePlane, SaysWhenAndWhere) {
  const Outcome run = run_taut(plane("# comes down\nt,x,y\n0,1,9\n8,1,1\n"));
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("room: caught after 4 at 1,5, at this speed nobody does earlier (proven)"));
}

TEST_F(ChasePlane, WritesJsonAndPictures) {
  const std::string command = plane("2 9 1\n3 9 1\n", "--stays --speed 2 ");
  const json envelope = json::parse(run_taut(command + "--json -").out), answer = envelope["result"];
  EXPECT_EQ(envelope["command"], "chase plane");
  EXPECT_EQ(envelope["status"], "found");
  EXPECT_EQ(answer["caught"], true);
  EXPECT_NEAR(answer["time"], std::sqrt(65.0), 1e-12);
  EXPECT_LE(answer["time_interval"][0], answer["time"]);
  EXPECT_EQ(answer["path"], json::parse("[[1, 1], [5, 8], [9, 1]]"));
  EXPECT_EQ(answer["waits"], 0);
  const std::string still = run_taut(command + "--svg -").out, moving = run_taut(command + "--animate -").out;
  EXPECT_THAT(still, HasSubstr("caught after 8.062258"));
  EXPECT_THAT(still, Not(HasSubstr("<animate")));
  // One clock: both dots have the same round.
  EXPECT_THAT(moving, HasSubstr("<g class=\"goal moving\">"));
  EXPECT_THAT(moving, HasSubstr("<g class=\"runner moving\">"));
  EXPECT_THAT(moving, ContainsRegex("keyTimes=\"0;[0-9.;]*0.95;1\""));
  EXPECT_EQ(moving, run_taut(command + "--animate -").out);
}

TEST_F(ChasePlane, SaysWhenNobodyCatchesIt) {
  const Outcome late = run_taut(plane("0 9 1\n3 9 1\n"));
  EXPECT_EQ(late.code, 1);
  EXPECT_THAT(late.out, HasSubstr("never caught, proven"));
  EXPECT_THAT(json::parse(run_taut(plane("0 9 1\n3 9 1\n", "--json -")).out)["reason"].get<std::string>(),
              HasSubstr("ends at 3"));
  const std::string sealed = folder.file("sealed", "boundary 0 0 10 10\nstart 1 1\n5 0 5 10\n");
  const json shut = json::parse(
      run_taut("chase plane " + sealed + " --stays --json - --target " + folder.file("way", "0 9 1\n")).out);
  EXPECT_EQ(shut["status"], "none");
  EXPECT_EQ(shut["reason"], "walls separate robot and target");
}

TEST_F(ChasePlane, RefusesWaysThatCannotBeWalked) {
  const Outcome through = run_taut(plane("0 1 9\n4 4 9\n5 9 1\n"));
  EXPECT_EQ(through.code, 3);
  EXPECT_THAT(through.err, HasSubstr("way:3: a wall is in the target's way to this place"));
  EXPECT_THAT(run_taut(plane("0 11 9\n")).err, HasSubstr("way:1: the target is in a wall, or outside"));
  EXPECT_THAT(run_taut(plane("0 1 9\n0 2 9\n")).err, HasSubstr("way:2: time 0 comes after 0"));
  EXPECT_THAT(run_taut(plane("0 1\n")).err, HasSubstr("way:1: a line is `t x y`, not 2 numbers"));
  const Outcome still = run_taut(plane("0 1 9\n", "--speed 0"));
  EXPECT_EQ(still.code, 2);
  EXPECT_THAT(still.err, HasSubstr("--speed: '0' is not above 0"));
  EXPECT_EQ(run_taut(plane("0 1 9\n", "--to 3,3")).code, 2);
}

}  // namespace
}  // namespace taut::test
