#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <taut/cli/meter.h>

namespace taut::cli {
namespace {

using testing::Optional;

/// A meter whose clock stands still until it is moved.
class MeterTest : public testing::Test {
 protected:
  Meter meter(Surface surface) {
    return {surface, [this] { return now_; }};
  }

  double now_ = 1000;
};

TEST_F(MeterTest, SaysHowMuchIsDoneHowFastAndHowLongTheRestTakes) {
  Meter meter = this->meter(Surface::file);
  meter.told({"corners", 0, 8000});
  now_ += 10;
  meter.told({"corners", 1200, 8000});
  EXPECT_THAT(meter.due("roadmap"),
              Optional(std::string("roadmap: 1200 of 8000 corners, 120 a second, about 57 s left")));
}

TEST_F(MeterTest, SaysALineEveryTenSecondsWhereThereIsNoTerminal) {
  Meter meter = this->meter(Surface::file);
  meter.told({"corners", 0, 8000});
  int lines = 0;
  for (int second = 1; second <= 35; ++second) {
    now_ += 1;
    meter.told({"corners", static_cast<std::size_t>(second), 8000});
    lines += meter.due("").has_value();
  }
  EXPECT_EQ(lines, 3);
}

TEST_F(MeterTest, SaysSoAgainAndAgainOnATerminal) {
  Meter meter = this->meter(Surface::terminal);
  meter.told({"corners", 0, 100});
  EXPECT_FALSE(meter.due(""));
  now_ += 0.25;
  EXPECT_TRUE(meter.due(""));
  EXPECT_FALSE(meter.due(""));
  now_ += 0.25;
  EXPECT_TRUE(meter.due(""));
}

TEST_F(MeterTest, SaysNothingOfShortWorkHoweverOftenItBegins) {
  Meter meter = this->meter(Surface::file);
  for (int work = 0; work < 9; ++work) {
    meter.told({"corners", 0, 10});
    now_ += 1;
    EXPECT_FALSE(meter.due(""));
    meter.told({"corners", 10, 10});
  }
  now_ += 5;
  EXPECT_FALSE(meter.due("")) << "all of it is done";
}

TEST_F(MeterTest, GoesOnWithItsTenSecondsFromOneWorkToTheNext) {
  Meter meter = this->meter(Surface::file);
  meter.told({"corners", 0, 10});
  now_ += 6;
  meter.told({"runs", 0, 4});
  now_ += 6;
  EXPECT_THAT(meter.due("planners"), Optional(std::string("planners: 0 of 4 runs, 6 s so far")));
}

TEST_F(MeterTest, TellsOfTheFirstItemThatIsNotYetDone) {
  Meter meter = this->meter(Surface::file);
  meter.told({"runs", 0, 4});
  now_ += 120.5;
  EXPECT_THAT(meter.due("prm"), Optional(std::string("prm: 0 of 4 runs, 3 min so far")));
}

TEST_F(MeterTest, MeasuresTheRateFromTheFirstCountOn) {
  Meter meter = this->meter(Surface::file);
  meter.told({"items", 500, 1000});  // of an earlier run
  now_ += 100;
  meter.told({"items", 510, 1000});
  EXPECT_THAT(meter.due(""), Optional(std::string("510 of 1000 items, 6.0 a minute, about 82 min left")));
}

TEST_F(MeterTest, KnowsNoRestWhereNobodyKnowsHowMuchThereIs) {
  Meter meter = this->meter(Surface::file);
  meter.told({"samples", 0, 0});
  now_ += 20;
  meter.told({"samples", 50, 0});
  EXPECT_THAT(meter.due("roadmap"), Optional(std::string("roadmap: 50 samples, 2.5 a second")));
}

TEST_F(MeterTest, SaysNothingOnceAllIsOver) {
  Meter meter = this->meter(Surface::file);
  meter.told({"samples", 7, 0});
  meter.over();
  now_ += 100;
  EXPECT_FALSE(meter.due(""));
}

TEST_F(MeterTest, CountsHoursWhereItTakesThem) {
  Meter meter = this->meter(Surface::file);
  meter.told({"queries", 0, 100000});
  now_ += 10;
  meter.told({"queries", 10, 100000});
  EXPECT_THAT(meter.due(""), Optional(std::string("10 of 100000 queries, 1.0 a second, about 27.8 h left")));
}

}  // namespace
}  // namespace taut::cli
