// taut solve --keep.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "support/program_test.h"

namespace taut::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

constexpr const char* kHall =
    "0 0 10 0\n10 0 10 10\n10 10 0 10\n0 10 0 0\n0 5 4 5\n5.5 5 10 5\nstart 2 0.25\ngoal 5 8\n";

class SolveKeep : public ProgramTest {};

TEST_F(SolveKeep, SaysHowMuchOfThePathIsNearerToWalls) {
  const Outcome run = run_taut("solve - --keep 0.5 --svg " + in_folder("a.svg"), kHall);
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("with clearance 0.5, but for 0.250000 at the start (from 0.25)"));
  EXPECT_THAT(contents(in_folder("a.svg")), HasSubstr("<g class=\"discs\">"));
}

TEST_F(SolveKeep, WritesThePartsAsJson) {
  const json answer = json::parse(run_taut("solve - --keep 0.5 --json -", kHall).out)["result"];
  EXPECT_EQ(answer["query"], "keep");
  EXPECT_EQ(answer["verified"], true);
  ASSERT_EQ(answer["parts"].size(), 2U);
  EXPECT_EQ(answer["parts"][0]["leaves"], "start");
  EXPECT_EQ(answer["parts"][1]["radius"], 0.5);
  EXPECT_TRUE(answer["parts"][1]["leaves"].is_null());
  EXPECT_EQ(answer["points"].front(), json::parse("[2, 0.25]"));
  EXPECT_EQ(answer["points"].back(), json::parse("[5, 8]"));
}

TEST_F(SolveKeep, NamesTheGateBetweenPlaces) {
  const Outcome run = run_taut("solve - --keep 0.8", kHall);
  EXPECT_EQ(run.code, 1);
  EXPECT_THAT(run.out, HasSubstr("no path: this gate is narrower than 1.6: 3/2 between (4, 5) and (5.5, 5)"));
}

TEST_F(SolveKeep, GoesIntoTheFilesOfOtherTrades) {
  EXPECT_THAT(run_taut("solve - --keep 0.5 --wkt - --quiet", kHall).out, HasSubstr("COMPOUNDCURVE"));
  EXPECT_THAT(run_taut("solve - --keep 0.5 --path", kHall).out, HasSubstr("2 0.5\n"));
}

TEST_F(SolveKeep, HasASearchOfItsOwn) {
  EXPECT_EQ(run_taut("solve - --keep 0.5 --arcs --robot disc:1", kHall).code, 2);
  const Outcome nothing = run_taut("solve - --keep 0", kHall);
  EXPECT_EQ(nothing.code, 2);
  EXPECT_THAT(nothing.err, HasSubstr("--keep: '0' is not above 0"));
}

}  // namespace
}  // namespace taut::test
