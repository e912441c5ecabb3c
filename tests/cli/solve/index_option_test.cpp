// taut batch with an index, built, kept and loaded.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "support/program_test.h"

namespace taut::test {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class IndexOption : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    if (IsSkipped()) return;
    maze = in_folder("maze.txt");
    ASSERT_EQ(run_taut("generate --size 20x20 --loops 0.3 --seed 2 -o " + maze).code, 0);
    for (int n = 0; n < 60; ++n)
      for (const int k : {7, 11, 13, 17}) queries += std::to_string(n * k % 20 + 1) + (k < 17 ? ".25 " : "\n");
  }
  Outcome run(const std::string& options) { return run_taut("batch " + maze + " - " + options, queries); }

  std::string maze, queries;
};

TEST_F(IndexOption, AnswersAsWithout) {
  const std::string expected = run("").out;
  EXPECT_EQ(run("--index").out, expected);
  const std::string kept = in_folder("maze.index");
  EXPECT_EQ(run("--save-index " + kept).out, expected);
  EXPECT_EQ(run("--load-index " + kept).out, expected);
}

TEST_F(IndexOption, SaysHowLargeItIs) {
  const json result = json::parse(run("--index --json -").out)["result"];
  EXPECT_GT(result["index"]["bends"], 10);
  EXPECT_GT(result["index"]["bytes"], 1000);
  EXPECT_EQ(result["answers"].size(), 60u);
}

TEST_F(IndexOption, RefusesAFileThatIsDamagedOrOfAnotherWorld) {
  const std::string kept = in_folder("maze.index"), other = in_folder("other.txt");
  ASSERT_EQ(run("--save-index " + kept).code, 0);
  ASSERT_EQ(run_taut("generate --size 20x20 --loops 0.3 --seed 3 -o " + other).code, 0);
  const Outcome foreign = run_taut("batch " + other + " - --load-index " + kept, queries);
  EXPECT_EQ(foreign.code, 3);
  EXPECT_THAT(foreign.err, AllOf(HasSubstr("maze.index: was built of "), HasSubstr("not of ")));
  std::fstream file(kept, std::ios::binary | std::ios::in | std::ios::out);
  file.seekp(1500);
  file.put('\x55');
  file.close();
  const Outcome damaged = run("--load-index " + kept);
  EXPECT_EQ(damaged.code, 3);
  EXPECT_THAT(damaged.err, HasSubstr("maze.index: is damaged"));
  EXPECT_EQ(damaged.out, "");
}

TEST_F(IndexOption, RefusesWhatMakesNoSense) {
  EXPECT_EQ(run("--index --load-index x").code, 2);
  EXPECT_EQ(run("--index --index-memory much").code, 2);
}

}  // namespace
}  // namespace taut::test
