// taut bug: what it prints, writes and returns.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "support/paths.h"
#include "support/run_program.h"

namespace taut::test {
namespace {

constexpr const char* kRoom = "0 0 4 0\n4 0 4 4\n4 4 0 4\n0 4 0 0\n2 0 2 3\nstart 1 2\ngoal 3 2\n";
constexpr const char* kSealed = "0 0 4 0\n4 0 4 4\n4 4 0 4\n0 4 0 0\n2 0 2 4\nstart 1 2\ngoal 3 2\n";

TEST(BugCommand, GivesLengthBoundAndContactsAsJson) {
  if (!program()) GTEST_SKIP() << "the program is not built";
  const Outcome run = run_taut("bug - --algorithm 2 --turn left --json -", kRoom);
  ASSERT_EQ(run.code, 0) << run.err;
  const auto json = nlohmann::json::parse(run.out);
  EXPECT_EQ(json["status"], "found");
  EXPECT_EQ(json["length"], 4);
  EXPECT_GE(json["bound"], json["length"]);
  EXPECT_EQ(json["hits"].size(), 1U);
  EXPECT_EQ(json["leaves"].size(), 1U);
}

TEST(BugCommand, EndsWithOneWhenThereIsNoPathAndTwoOnNonsense) {
  if (!program()) GTEST_SKIP() << "the program is not built";
  EXPECT_EQ(run_taut("bug - --algorithm 1", kSealed).code, 1);
  EXPECT_EQ(run_taut("bug - --algorithm 2", kSealed).code, 1);
  EXPECT_EQ(run_taut("bug - --algorithm 3", kSealed).code, 2);
  EXPECT_EQ(run_taut("bug - --from 9,9", kSealed).code, 3);
}

}  // namespace
}  // namespace taut::test
