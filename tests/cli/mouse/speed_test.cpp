// taut mouse speed, as its users run it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "support/program_test.h"

namespace taut::test {
namespace {

using nlohmann::json;
using testing::ContainsRegex;
using testing::EndsWith;
using testing::HasSubstr;

class MouseSpeed : public ProgramTest {};

TEST_F(MouseSpeed, ShowsTheFastestBesideTheShortest) {
  const Outcome run = run_taut("mouse speed " + data_file("mouse_16.maz"));
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, ContainsRegex("\n  fastest +[0-9.]+ +[0-9.]+ +[0-9]+ +[0-9]+ "));
  const json all = json::parse(run_taut("mouse speed --json - " + data_file("mouse_16.maz")).out)["result"];
  EXPECT_LE(all["fastest"]["seconds"], all["shortest"]["seconds"]);
  EXPECT_LE(all["fastest"]["seconds"], all["steady"]["seconds"]);
  EXPECT_LE(all["shortest"]["cells"], all["fastest"]["cells"]);
  const double seconds_of_fastest = all["fastest"]["seconds"];
  EXPECT_LE(all["bound"]["seconds"], seconds_of_fastest);
  EXPECT_GE(all["bound"]["seconds"], 0.99 * seconds_of_fastest);
  EXPECT_LT(all["any_curve"]["seconds"], all["bound"]["seconds"]);
  EXPECT_LT(all["any_curve"]["metres"], all["shortest"]["metres"]);
  EXPECT_THAT(run.out, ContainsRegex("\n  steady +[0-9.]+ +[0-9.]+ +[0-9]+ +[0-9]+ "));
  EXPECT_THAT(run.out, ContainsRegex("\n  bound +[0-9.]+ +no run "));
  EXPECT_THAT(run.out, ContainsRegex("\n  any curve +[0-9.]+ +[0-9.]+ "));
  double seconds = 0;
  for (const json& drive : all["fastest"]["drives"]) seconds += drive["seconds"].get<double>();
  EXPECT_NEAR(all["fastest"]["seconds"], seconds, 1e-12);
  EXPECT_EQ(all["differences"].empty(), all["fastest"]["route"] == all["shortest"]["route"]);
}

TEST_F(MouseSpeed, TakesItsModelFromAFile) {
  const std::string query = "mouse speed --json - " + data_file("mouse_16.num"), model = " --model ";
  const auto fastest = [&](const std::string& more) {
    return json::parse(run_taut(query + more).out)["result"]["fastest"];
  };
  EXPECT_EQ(fastest(""), fastest(model + data_file("mouse_speed.json")));
  const std::string slow = folder.file("slow.json", R"({"straight": {"top_speed": 1.6}})");
  EXPECT_GT(fastest(model + slow)["seconds"], fastest("")["seconds"]);
  const Outcome bad = run_taut(query + model + folder.file("bad.json", "{\"wheels\": 4}"));
  EXPECT_EQ(bad.code, 3);
  EXPECT_THAT(bad.err, HasSubstr("bad.json:1: unknown name 'wheels'"));
  const Outcome huge = run_taut(query + model + folder.file("huge.json", "{\"cell\": 1e400}"));
  EXPECT_EQ(huge.code, 3);
  EXPECT_THAT(huge.err, HasSubstr("huge.json:1: not valid JSON"));
}

TEST_F(MouseSpeed, DrawsBothAndListsItsDrives) {
  const Outcome picture = run_taut("mouse speed --svg - " + data_file("mouse_16.maz"));
  EXPECT_THAT(picture.out, HasSubstr("<g class=\"fastest\">"));
  EXPECT_THAT(picture.out, EndsWith("</svg>\n"));
  const Outcome drives = run_taut("mouse speed -q --drives " + data_file("mouse_16.maz"));
  EXPECT_THAT(drives.out, HasSubstr(" -> 0.00 m/s\n"));
}

}  // namespace
}  // namespace taut::test
