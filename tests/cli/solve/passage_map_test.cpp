// taut passage --matrix and --map, taut batch --widest and --arcs.
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

/// Two rooms with a door 2 wide.
constexpr const char* kRooms =
    "boundary 0 0 10 10\nstart 2 5\ngoal 8 5\n0 0 10 0\n10 0 10 10\n10 10 0 10\n0 10 0 0\n5 0 5 4\n5 6 5 10\n";

class DiscProgram : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    rooms = folder.file("rooms.txt", kRooms);
  }
  std::string rooms;
};

TEST_F(DiscProgram, SaysBetweenAllPairsHowLargeADiscGets) {
  const std::string points = folder.file("points.txt", "2 5\n8 5\n3 3\n");
  const Outcome outcome = run_taut("passage " + rooms + " --matrix " + points);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "2,1,2\n1,2,1\n2,1,2\n");
  EXPECT_EQ(run_taut("passage " + rooms + " --matrix " + folder.file("out.txt", "20 5\n")).code, 3);
}

TEST_F(DiscProgram, MapsHowLargeADiscGetsAnywhere) {
  const Outcome outcome = run_taut("passage " + rooms + " --map - --map-cells 5");
  EXPECT_EQ(outcome.code, 2) << "what it is to be is told by the name";
  const std::string csv = in_folder("map.csv");
  ASSERT_EQ(run_taut("passage " + rooms + " --map " + csv + " --map-cells 5").code, 0);
  EXPECT_EQ(contents(in_folder("map.csv")), "1,1,0,1,1\n1,2,0,1,1\n1,2,1,1,1\n1,2,0,1,1\n1,1,0,1,1\n");
  ASSERT_EQ(run_taut("passage " + rooms + " --map " + in_folder("map.pgm") + " --map-cells 5").code, 0);
  EXPECT_THAT(contents(in_folder("map.pgm")), StartsWith("P5\n# radius 0.00784"));
  ASSERT_EQ(run_taut("passage " + rooms + " --map " + in_folder("map.geojson")).code, 0);
  const json faces = json::parse(contents(in_folder("map.geojson")))["features"];
  double area = 0, behind = 0;
  for (const json& face : faces) {
    const json& ring = face["geometry"]["coordinates"][0];
    double twice = 0;
    for (std::size_t i = 0; i + 1 < ring.size(); ++i)
      twice += ring[i][0].get<double>() * ring[i + 1][1].get<double>() -
               ring[i][1].get<double>() * ring[i + 1][0].get<double>();
    EXPECT_GT(twice, 0) << "outlines run counter-clockwise";
    area += twice / 2;
    if (face["properties"]["radius"] == 1) {
      behind += twice / 2;
      EXPECT_EQ(face["properties"]["gate"], "2 between (5, 4) and (5, 6)");
    }
  }
  EXPECT_DOUBLE_EQ(area, 100) << "faces cover the world";
  EXPECT_DOUBLE_EQ(behind, 50);
  ASSERT_EQ(run_taut("passage " + rooms + " --map " + in_folder("map.svg")).code, 0);
  EXPECT_THAT(contents(in_folder("map.svg")), HasSubstr("<g class=\"fills\">"));
}

TEST_F(DiscProgram, AnswersManyQueriesByOneIndex) {
  const Outcome outcome = run_taut("batch " + rooms + " - --widest", "2 5 8 5\n2 5 3 3 2\n2 5 20 5\n");
  EXPECT_EQ(outcome.out, "1 1\n2 2\n3 blocked\n");
  EXPECT_EQ(outcome.code, 1) << outcome.err;
  const json line = json::parse(run_taut("batch " + rooms + " - --widest --json-lines", "2 5 8 5\n").out);
  EXPECT_EQ(line["radius"], 1);
  EXPECT_EQ(line["limit"], "2 between (5, 4) and (5, 6)");
  EXPECT_EQ(run_taut("batch " + rooms + " - --widest --robot disc:1", "2 5 8 5\n").code, 2);
}

TEST_F(DiscProgram, TakesARadiusALineForPathsWithArcs) {
  const Outcome outcome =
      run_taut("batch " + rooms + " - --arcs", "2 5 8 5 1\n2 5 8 5 1.1\n2 2 8 2 0.5\n2 2 8 2 1\n2 5 8 5 2.5\n");
  EXPECT_NEAR(std::stod(outcome.out.substr(2)), 6, 1e-14);
  EXPECT_THAT(outcome.out, HasSubstr("\n2 none\n3 7."));
  EXPECT_THAT(outcome.out, HasSubstr("\n5 blocked\n"));
  const json alone =
      json::parse(run_taut("solve " + rooms + " --from 2,2 --to 8,2 --robot disc:1 --arcs --json -").out)["result"];
  const json line = json::parse(run_taut("batch " + rooms + " - --arcs --json-lines", "2 2 8 2 1\n").out);
  EXPECT_EQ(line["length"], alone["length"]);
  EXPECT_EQ(run_taut("batch " + rooms + " - --arcs", "2 5 8 5\n").code, 3);
  EXPECT_EQ(run_taut("batch " + rooms + " - --arcs", "2 5 8 5 0\n").code, 3);
}

}  // namespace
}  // namespace taut::test
