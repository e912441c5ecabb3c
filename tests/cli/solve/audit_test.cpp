// taut audit: anybody's plans.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "support/program_test.h"

namespace taut::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

constexpr const char* kRoom = "boundary 0 0 4 4\nstart 0.5 1\ngoal 3.5 1\n2 0 2 3\n";

class Audit : public ProgramTest {
 protected:
  Outcome audit(const std::string& plans, const std::string& options = "", const std::string& world = kRoom) const {
    return run_taut("audit - " + folder.file("plans", plans) + " " + options, world);
  }
  json result(const std::string& plans, const std::string& options = "") const {
    const Outcome run = audit(plans, options + " --json " + in_folder("answer"));
    return json::parse(contents(in_folder("answer")))["result"];
  }
};

TEST_F(Audit, SaysHowMuchLongerAPathIs) {
  const json plan = result("0.5 1\n0.5 3.5\n3.5 3.5\n3.5 1\n")["plans"][0];
  EXPECT_EQ(plan["valid"], true);
  EXPECT_EQ(plan["length"], 8);
  EXPECT_EQ(plan["shortest"], 5);
  EXPECT_EQ(plan["gap"], 3);
  EXPECT_EQ(plan["clearance"], 0.5);
  EXPECT_EQ(plan["bound"], nullptr);
}

TEST_F(Audit, HasTheGapProvenByTheJudge) {
  const json plan = result("0.5 1\n0.5 3.5\n3.5 3.5\n3.5 1\n", "--prove")["plans"][0];
  EXPECT_NEAR(plan["bound"], 5, 1e-9);
  EXPECT_LE(plan["bound"], 5);
  const Outcome run = audit("0.5,1\n2,3\n3.5,1\n", "--prove");
  EXPECT_EQ(run.code, 0);
  EXPECT_THAT(run.out, HasSubstr("no path is shorter, proven"));
}

TEST_F(Audit, NamesTheFirstContactOfEachPath) {
  const Outcome run = audit("x,y\n0.5,1\n3.5,1\n", "--svg " + in_folder("faults.svg"));
  EXPECT_EQ(run.code, 1);
  EXPECT_THAT(run.out, HasSubstr("path 1: not valid: leg 0, (0.5, 1) to (3.5, 1), crosses the wall (2, 0) to (2, 3); "
                                 "first at (2, 1), the wall from (2, 0) to (2, 3), line 4"));
  EXPECT_THAT(contents(in_folder("faults.svg")), HasSubstr("separation"));
}

TEST_F(Audit, ReadsWhatOmplPrints) {
  const Outcome run = audit("0.5 1 0\n0.5 3.5 0\n3.5 3.5 1.5\n\n0.5 1 0\n3.5 1 0 \n\n");
  EXPECT_EQ(run.code, 1);
  EXPECT_THAT(run.out, HasSubstr("path 1: valid"));
  EXPECT_THAT(run.out, HasSubstr("path 2: not valid"));
  EXPECT_THAT(run.out, HasSubstr("2 paths, 1 valid, 1 not"));
}

TEST_F(Audit, ReadsGeoJsonAndPosesOfRos) {
  EXPECT_EQ(audit(R"({"type": "LineString", "coordinates": [[0.5, 1], [2, 3], [3.5, 1]]})").code, 0);
  EXPECT_EQ(audit("header:\n  frame_id: map\nposes:\n- pose:\n    position: {x: 0.5, y: 1.0, z: 0}\n"
                  "- pose:\n    position: {x: 3.5, y: 1.0, z: 0}\n")
                .code,
            1);
}

TEST_F(Audit, KnowsDiscsAndSquares) {
  const std::string around = "0.5 1\n0.5 3.5\n3.5 3.5\n3.5 1\n";
  EXPECT_EQ(audit(around, "--robot disc:0.5").code, 0);
  EXPECT_EQ(audit(around, "--robot disc:0.51").code, 1);
  EXPECT_EQ(audit(around, "--robot square:0.5").code, 0);
  EXPECT_EQ(audit(around, "--robot square:0.51").code, 1);
  EXPECT_THAT(audit(around, "--robot disc:0.51").out, HasSubstr("comes nearer than 0.51 to the wall"));
}

TEST_F(Audit, TakesAClaimedLengthAtItsWord) {
  const auto claim = [&](const char* length) {
    return audit(std::string(R"({"points": [[0.5, 1], [2, 3], [3.5, 1]], "length": )") + length + "}").code;
  };
  EXPECT_EQ(claim("5"), 0);
  EXPECT_EQ(claim("5.000000000001"), 1);
}

TEST_F(Audit, AsksForTheEndsOfTheWorldWhereItShould) {
  EXPECT_EQ(audit("0.5 2\n2 3\n3.5 1\n").code, 0);
  EXPECT_THAT(audit("0.5 2\n2 3\n3.5 1\n", "--ends").out, HasSubstr("it starts at (0.5, 2), not at (0.5, 1)"));
  EXPECT_EQ(audit("0.5 1\n2 3\n3.5 1\n", "--ends").code, 0);
}

TEST_F(Audit, ReadsTheProgramsOwnPaths) {
  const std::string plan = in_folder("plan.json");
  ASSERT_EQ(run_taut("solve - --robot disc:0.2 --arcs --json " + plan, kRoom).code, 0);
  const Outcome arcs = run_taut("audit - " + plan + " --ends", kRoom);
  EXPECT_EQ(arcs.code, 0) << arcs.out << arcs.err;
  EXPECT_THAT(arcs.out, HasSubstr("no path is shorter"));
}

TEST_F(Audit, JudgesDrives) {
  const std::string drive = in_folder("drive.json"), car = "--car length=0.4,width=0.2,radius=0.3";
  ASSERT_EQ(run_taut("drive - " + car + " --json " + drive, kRoom).code, 0);
  const Outcome run = run_taut("audit - " + drive, kRoom);
  EXPECT_EQ(run.code, 0) << run.out << run.err;
  EXPECT_THAT(run.out, HasSubstr("no such car drives less than "));
  const Outcome blocked = run_taut("audit - " + drive + " --json - -q", "boundary 0 0 4 4\n2 0 2 3.4\n");
  EXPECT_EQ(blocked.code, 1);
  const json result = json::parse(blocked.out)["result"];
  EXPECT_EQ(result["contact"]["wall"]["line"], 2);
  EXPECT_NEAR(result["contact"]["at"][0], 2, 0.5);
}

TEST_F(Audit, FindsTheFirstCollisionOfManyRobots) {
  const std::string plans = "a 0 0.5 1\na 2 0.5 3\nb 0 0.5 3\nb 2 0.5 1\nc 0 3 1\nc 9 3 2\n";
  const Outcome run = audit(plans, "--robot disc:0.25 --json " + in_folder("answer") + " --svg " + in_folder("a.svg"));
  EXPECT_EQ(run.code, 1);
  EXPECT_THAT(run.out,
              HasSubstr("3 robots, 3 legs: not valid: robots a and b collide from 0.75 to 1.25, at (0.5, 1.75) "
                        "and (0.5, 2.25)"));
  const json result = json::parse(contents(in_folder("answer")))["result"];
  EXPECT_EQ(result["collisions"], 1);
  EXPECT_EQ(result["first_collisions"][0]["robots"], json::parse(R"(["a", "b"])"));
  EXPECT_THAT(contents(in_folder("a.svg")), HasSubstr("discs"));
}

TEST_F(Audit, KeepsManyRobotsFromWallsToo) {
  const Outcome run = audit("id,t,x,y,r\na,0,1,1,0.5\na,4,3,1,0.5\n");
  EXPECT_EQ(run.code, 1);
  EXPECT_THAT(run.out, HasSubstr("robot a: leg 0, (1, 1) to (3, 1), comes nearer than 0.5 to the wall"));
  EXPECT_THAT(run.out, HasSubstr("at time 1"));
  EXPECT_EQ(audit("a 0 1 1\na 4 1 3\n", "--robot disc:0.5").code, 0);
}

TEST_F(Audit, NamesTheLineOfWhatItCannotRead) {
  EXPECT_THAT(audit("a 0 1 1\na 0 1 3\n", "--robot disc:0.5").err, HasSubstr(":2: robot 'a' is at time 0 after 0"));
  EXPECT_THAT(audit("a 0 1 1\n").err, HasSubstr("has no radius"));
  EXPECT_THAT(audit("1 1\n2\n").err, HasSubstr(":2: "));
  EXPECT_THAT(audit("{\"legs\": [{\"headings\": [0, 64]}]}").err, HasSubstr(":1: "));
}

}  // namespace
}  // namespace taut::test
