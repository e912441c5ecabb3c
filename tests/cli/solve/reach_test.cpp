// taut reach.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "support/program_test.h"

namespace taut::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

constexpr const char* kHall = "0 0 10 0\n10 0 10 10\n10 10 0 10\n0 10 0 0\n0 5 4 5\n5.5 5 10 5\nstart 2 2\n";

class Reach : public ProgramTest {};

TEST_F(Reach, NamesTheGateAndItsWallsThatKeepTheDiscFromTheRest) {
  const Outcome run = run_taut("reach - --robot disc:1", kHall);
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("this gate is too narrow: 3/2 between (4, 5) and (5.5, 5), of the walls "));
  EXPECT_THAT(run.out, HasSubstr("(0, 5)-(4, 5)"));
  EXPECT_THAT(run.out, HasSubstr("(5.5, 5)-(10, 5)"));
  const json gates = json::parse(run_taut("reach - --robot disc:1 --json -", kHall).out)["result"]["gates"];
  ASSERT_EQ(gates.size(), 1U);
  EXPECT_EQ(gates[0]["walls"].size(), 2U);
}

TEST_F(Reach, SaysOfAPlaceWhetherTheDiscGetsThereAndWhichIsNearest) {
  const json there = json::parse(run_taut("reach - --robot disc:1 --ask 5,2 --json -", kHall).out)["result"]["asked"];
  EXPECT_EQ(there["reached"], true);
  EXPECT_EQ(there["nearest"]["distance"], 0);
  const json beyond = json::parse(run_taut("reach - --robot disc:1 --ask 5,8 --json -", kHall).out)["result"]["asked"];
  EXPECT_EQ(beyond["reached"], false);
  EXPECT_EQ(beyond["nearest"]["reached"], false);
  const json rim = json::parse(run_taut("reach - --robot disc:1 --ask 5,0.25 --json -", kHall).out)["result"]["asked"];
  EXPECT_EQ(rim["reached"], false);
  EXPECT_EQ(rim["nearest"]["point"], json::parse("[5, 1]"));
  EXPECT_EQ(rim["nearest"]["reached"], true);
  EXPECT_THAT(run_taut("reach - --robot disc:1 --ask 5,0.25", kHall).out,
              HasSubstr("it does not get to (5, 0.25), the nearest place (5, 1) is 0.75 away"));
}

}  // namespace
}  // namespace taut::test
