// Files that say how fast a mouse is.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include <taut/io/worlds/speed_model_file.h>

#include "support/paths.h"
#include "support/refusal.h"

namespace taut {
namespace {

using micromouse::SpeedModel;
using micromouse::Turn;
using testing::HasSubstr;

TEST(SpeedModelFile, OfTheDataFolderIsTheDefault) {
  std::ifstream in(test::data_dir() / "mouse_speed.json");
  std::stringstream text;
  text << in.rdbuf();
  EXPECT_EQ(read_speed_model(text.str()), SpeedModel{});
  EXPECT_EQ(read_speed_model("{}"), SpeedModel{});
  EXPECT_EQ(read_speed_model(R"({"turns": {"180": {"time": 0.5}}})").seconds(Turn::turn_180), 0.5);
}

TEST(SpeedModelFile, NamesWhatIsWrongWithAFile) {
  const auto message = [](const char* text) { return test::refusal_of([&] { read_speed_model(text, "model.json"); }); };
  EXPECT_THAT(message("{\n\n!"), HasSubstr("model.json:3: not valid JSON"));
  EXPECT_THAT(message("[]"), HasSubstr("the model is not an object"));
  EXPECT_THAT(message(R"({"sell": 1})"), HasSubstr("unknown name 'sell' in the model"));
  EXPECT_THAT(message(R"({"cell": -1})"), HasSubstr("'cell' is not a number above 0"));
  EXPECT_THAT(message(R"({"cell": "x"})"), HasSubstr("'cell' is not a number above 0"));
  EXPECT_THAT(message(R"({"cell": 1e400})"), HasSubstr("model.json:1: not valid JSON"));
  EXPECT_THAT(message(R"({"turns": {"46": {}}})"), HasSubstr("unknown name '46' in 'turns'"));
  EXPECT_THAT(message(R"({"turns": {"45": {"speed": 3.5}}})"), HasSubstr("'45' is faster than"));
  EXPECT_THAT(message(R"({"straight": 4})"), HasSubstr("'straight' is not an object"));
}

TEST(SpeedModelFile, IsNotRepeatedWhereANameInItIsLong) {
  const std::string text = "{\"" + std::string(4000, 'x') + "\": 1}";
  EXPECT_LT(test::refusal_of([&] { read_speed_model(text, "model.json"); }).size(), 100U);
}

}  // namespace
}  // namespace taut
