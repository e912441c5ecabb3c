#include <taut/robots/micromouse/speed_model.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "robots/micromouse/slow_speed_run.h"
#include "support/paths.h"
#include "support/refusal.h"

namespace taut::micromouse {
namespace {

using testing::HasSubstr;

TEST(SpeedModel, TimesStraightsAsAnIntegratorDoes) {
  for (const Ramp& ramp : {Ramp{10, 10, 4}, Ramp{8, 12, 3}, Ramp{3, 5, 0.9}})
    for (const double from : {0.0, 0.5, 0.9})
      for (const double to : {0.0, 0.5, 0.9})
        for (const double metres : {0.02, 0.09, 0.5, 3.0}) {
          const auto exact = straight_seconds(ramp, from, to, metres);
          const auto integrated = integrated_seconds(ramp, from, to, metres);
          ASSERT_EQ(exact.has_value(), integrated.has_value()) << from << " " << to << " " << metres;
          if (exact) {
            EXPECT_NEAR(*exact, *integrated, 1e-5);
          }
        }
  EXPECT_EQ(straight_seconds({10, 10, 4}, 1, 1, 0), 0.0);
  EXPECT_EQ(straight_seconds({10, 10, 4}, 0, 0, 0), 0.0);
  EXPECT_FALSE(straight_seconds({10, 10, 4}, 0, 1, 0).has_value());
}

TEST(SpeedModel, OfTheDataFolderIsTheDefault) {
  std::ifstream in(test::data_dir() / "mouse_speed.json");
  std::stringstream text;
  text << in.rdbuf();
  EXPECT_EQ(read_speed_model(text.str()), SpeedModel{});
  EXPECT_EQ(read_speed_model("{}"), SpeedModel{});
  EXPECT_EQ(read_speed_model(R"({"turns": {"180": {"time": 0.5}}})").seconds(Turn::turn_180), 0.5);
}

TEST(SpeedModel, NamesWhatIsWrongWithAFile) {
  const auto message = [](const char* text) { return test::refusal_of([&] { read_speed_model(text, "model.json"); }); };
  EXPECT_THAT(message("{\n\n!"), HasSubstr("model.json:3: is no speed model: this is not JSON"));
  EXPECT_THAT(message("[]"), HasSubstr("the model is not an object"));
  EXPECT_THAT(message(R"({"sell": 1})"), HasSubstr("unknown name 'sell' in the model"));
  EXPECT_THAT(message(R"({"cell": -1})"), HasSubstr("'cell' is not a number above 0"));
  EXPECT_THAT(message(R"({"cell": "x"})"), HasSubstr("'cell' is not a number above 0"));
  EXPECT_THAT(message(R"({"cell": 1e400})"), HasSubstr("model.json"));
  EXPECT_THAT(message(R"({"turns": {"46": {}}})"), HasSubstr("unknown name '46' in 'turns'"));
  EXPECT_THAT(message(R"({"turns": {"45": {"speed": 3.5}}})"), HasSubstr("'45' is faster than"));
  EXPECT_THAT(message(R"({"straight": 4})"), HasSubstr("'straight' is not an object"));
}

}  // namespace
}  // namespace taut::micromouse
