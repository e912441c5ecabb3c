// taut diff, as its users run it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "cli/mouse/mazes.h"
#include "support/program_test.h"

namespace taut::test {
namespace {

using nlohmann::json;

class Diff : public ProgramTest {};

TEST_F(Diff, CountsTheWallsThatDiffer) {
  const std::string bend = folder.file("bend", kBend), sealed = folder.file("sealed", kSealed);
  EXPECT_EQ(run_taut("diff " + bend + " " + bend).code, 0);
  const Outcome one = run_taut("diff " + bend + " " + sealed);
  EXPECT_EQ(one.code, 1);
  EXPECT_EQ(one.out, "(0,1) east: open / wall\n1 wall differs\n");
  const json all = json::parse(run_taut("diff --json - " + bend + " " + sealed).out)["result"];
  EXPECT_EQ(all["differ"], 1);
  EXPECT_EQ(all["walls"][0]["side"], "east");
}

TEST_F(Diff, ComparesAcrossFormatsAndSizes) {
  const std::string drawing = in_folder("drawing");
  ASSERT_EQ(run_taut("convert --as drawing " + data_file("mouse_16.maz") + " " + drawing).code, 0);
  const Outcome same = run_taut("diff " + data_file("mouse_16.maz") + " " + drawing);
  EXPECT_EQ(same.code, 0);
  EXPECT_EQ(same.out, "no wall differs\n");
  const Outcome sizes = run_taut("diff " + data_file("mouse_16.maz") + " " + data_file("mouse_12.cells"));
  EXPECT_EQ(sizes.code, 1);
  EXPECT_EQ(sizes.out, "the sizes differ: 16 x 16 / 12 x 12\n");
  EXPECT_EQ(run_taut("diff " + drawing).code, 2);
  EXPECT_EQ(run_taut("diff - -").code, 3);
}

}  // namespace
}  // namespace taut::test
