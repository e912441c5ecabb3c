// taut space: the free space as polygons with holes.
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

// A room with a wall that a square goes around on either side.
constexpr const char* kRoom = "boundary 0 0 10 10\n4 5 6 5\nstart 5 2\ngoal 5 8\n";

class SpaceProgram : public ProgramTest {};

TEST_F(SpaceProgram, WritesWhatTheNameOfTheFileSays) {
  const Outcome wkt = run_taut("space - --wall-thickness 1 --robot square:0.5 -o " + in_folder("a.wkt"), kRoom);
  EXPECT_EQ(wkt.code, 0) << wkt.err;
  EXPECT_THAT(wkt.out, HasSubstr("1 polygon, 1 hole, 8 corners, area 92"));
  EXPECT_EQ(contents(folder / "a.wkt"), "POLYGON ((0 0, 10 0, 10 10, 0 10, 0 0), (3 4, 3 6, 7 6, 7 4, 3 4))\n");
  EXPECT_EQ(run_taut("space - -o " + in_folder("a.geojson"), kRoom).code, 0);
  EXPECT_EQ(json::parse(contents(folder / "a.geojson"))["type"], "FeatureCollection");
  EXPECT_EQ(run_taut("space - -o " + in_folder("a.svg"), kRoom).code, 0);
  EXPECT_THAT(contents(folder / "a.svg"), StartsWith("<svg"));
}

TEST_F(SpaceProgram, WritesToStandardOutputAlone) {
  const Outcome run = run_taut("space - -o - --as wkt", kRoom);
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.out, "POLYGON ((0 0, 10 0, 10 10, 0 10, 0 0))\nLINESTRING (4 5, 6 5)\n");
}

TEST_F(SpaceProgram, GivesAPointThePathOfTheRobot) {
  const std::string ends = " --from 5,2 --to 5,8 --path -q";
  const std::string robot = " --wall-thickness 0.25 --robot disc:0.75";
  const Outcome space = run_taut("space - -o - --as wkt" + robot, kRoom);
  const Outcome of_robot = run_taut("solve -" + ends + robot, kRoom), of_point = run_taut("solve -" + ends, space.out);
  EXPECT_EQ(of_robot.code, 0) << of_robot.err;
  EXPECT_EQ(of_point.out, of_robot.out);
}

TEST_F(SpaceProgram, SaysThatNothingIsFree) {
  const Outcome run =
      run_taut("space - --robot square:6 -o " + in_folder("none.wkt"), "POLYGON ((0 0, 10 0, 10 10, 0 10, 0 0))");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("nothing is free"));
  EXPECT_EQ(contents(folder / "none.wkt"), "POLYGON EMPTY\n");
}

TEST_F(SpaceProgram, RefusesAFormatItCannotTell) {
  for (const char* options : {"", "-o -", "-o a.pdf", "-o noext", "-o - --as maz", "-o a.wkt --robot cube:1"}) {
    const Outcome run = run_taut(std::string("space - ") + options, kRoom);
    EXPECT_EQ(run.code, 2) << options << run.err;
    EXPECT_EQ(run.out, "") << options;
  }
  EXPECT_THAT(run_taut("space - -o a.pdf", kRoom).err, HasSubstr("--as"));
}

}  // namespace
}  // namespace taut::test
