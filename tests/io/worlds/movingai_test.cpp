#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <taut/geometry/errors.h>
#include <taut/geometry/free_space.h>
#include <taut/io/worlds/movingai.h>
#include <taut/io/worlds/read_world.h>

#include "support/refusal.h"

namespace taut {
namespace {

using testing::HasSubstr;

constexpr const char* kSmall =
    "type octile\n"
    "height 3\n"
    "width 4\n"
    "map\n"
    ".GS.\n"
    "@OTW\n"
    "..@.\n";

std::string refusal(const std::string& text) {
  return test::refusal_of([&] { read_movingai_map(text, "x.map"); });
}

TEST(MovingAi, ReadsFreeAndBlockedCells) {
  const OccupancyGrid grid = read_movingai_map(kSmall, "x.map");
  EXPECT_EQ(grid.width, 4U);
  EXPECT_EQ(grid.height, 3U);
  EXPECT_EQ(grid.blocked, (std::vector<std::uint8_t>{0, 0, 0, 0, 1, 1, 1, 1, 0, 0, 1, 0}));
  EXPECT_TRUE(grid.free(3, 0));
  EXPECT_FALSE(grid.free(2, 2));
  EXPECT_FALSE(grid.free(-1, 0));
}

TEST(MovingAi, ToleratesDosLineEndsTrailingBlanksAndAMissingLastLineEnd) {
  const OccupancyGrid grid = read_movingai_map("type octile\r\nheight 2 \r\nwidth  2\r\nmap\r\n.@  \r\n@.\r\n\r\n", "");
  EXPECT_EQ(grid.blocked, (std::vector<std::uint8_t>{0, 1, 1, 0}));
  EXPECT_EQ(read_movingai_map("height 1\nwidth 1\nmap\n.", "").blocked, std::vector<std::uint8_t>{0});
}

TEST(MovingAi, SaysWhereHeaderAndRowsDisagree) {
  EXPECT_EQ(refusal("type octile\nheight 2\nwidth 3\nmap\n...\n..\n"),
            "x.map:6: a row of 2 cells; line 3 says width 3");
  EXPECT_EQ(refusal("type octile\nheight 1\nwidth 3\nmap\n...\n...\n"),
            "x.map:6: a row too many: line 2 says height 1");
  EXPECT_EQ(refusal("type octile\nheight 3\nwidth 3\nmap\n...\n...\n"),
            "x.map:6: the map ends after 2 rows; line 2 says height 3");
  EXPECT_EQ(refusal("type octile\nheight 1\nwidth 3\nmap\n.x.\n"), "x.map:5: 'x' in column 1 is none of . G S @ O T W");
}

TEST(MovingAi, RefusesABrokenHeader) {
  EXPECT_THAT(refusal("type tile\nheight 1\nwidth 1\nmap\n.\n"), HasSubstr("x.map:1: type 'tile'"));
  EXPECT_THAT(refusal("type octile\nheight 0\nwidth 1\nmap\n"), HasSubstr("x.map:2: height '0'"));
  EXPECT_THAT(refusal("type octile\nheight 99999999999\nwidth 1\nmap\n"), HasSubstr("x.map:2: height"));
  EXPECT_THAT(refusal("type octile\nheight 1\nheight 1\nwidth 1\nmap\n.\n"), HasSubstr("a second height"));
  EXPECT_THAT(refusal("type octile\nheight 1\nmap\n.\n"), HasSubstr("no width"));
  EXPECT_THAT(refusal("type octile\nheight 1\nwidth 1\n"), HasSubstr("no line `map`"));
  EXPECT_THAT(refusal("type octile\ndepth 1\n"), HasSubstr("'depth 1'"));
}

TEST(MovingAi, MapsAreReadBackAsWritten) {
  const OccupancyGrid grid = read_movingai_map(kSmall, "");
  const OccupancyGrid again = read_movingai_map(movingai_map_text(grid), "");
  EXPECT_EQ(again.width, grid.width);
  EXPECT_EQ(again.blocked, grid.blocked);
}

TEST(MovingAi, ScenariosAreReadBackAsWritten) {
  const std::string text = "version 1\n0\tmaps/a b\n";
  EXPECT_THROW(read_movingai_scenarios(text, "x.scen"), InputError);
  const std::string good = "version 1\n0\ta.map\t4\t3\t0\t1\t3\t2\t4.41421356\n7\ta.map\t4\t3\t1\t1\t1\t1\t0\n";
  const std::vector<Scenario> scenarios = read_movingai_scenarios(good, "x.scen");
  ASSERT_EQ(scenarios.size(), 2U);
  EXPECT_EQ(scenarios[0].map, "a.map");
  EXPECT_EQ(scenarios[0].goal_column, 3U);
  EXPECT_EQ(scenarios[0].optimal, 4.41421356);
  EXPECT_EQ(scenarios[1].bucket, 7U);
  EXPECT_EQ(scenarios[1].line, 3U);
  EXPECT_EQ(movingai_scenario_text(scenarios), good);
}

TEST(MovingAi, LengthsHaveTheZerosThatTheFileLeftOut) {
  const auto units = [](const std::string& lengths) {
    std::string text = "version 1\n";
    for (std::size_t from = 0; from < lengths.size();) {
      const std::size_t end = std::min(lengths.find(' ', from), lengths.size());
      text += "0 a 9 9 0 0 1 1 " + lengths.substr(from, end - from) + "\n";
      from = end + 1;
    }
    std::vector<double> all;
    for (const Scenario& s : read_movingai_scenarios(text, "x.scen")) all.push_back(s.unit());
    return all;
  };
  EXPECT_THAT(units("3.41421 12 123.5"), testing::ElementsAre(1e-5, 1e-4, 1e-3));
  EXPECT_THAT(units("3.41 12.00 123.50"), testing::ElementsAre(1e-2, 1e-2, 1e-2));
  EXPECT_THAT(units("1 22"), testing::ElementsAre(1e-5, 1e-4));
}

TEST(MovingAi, PointsOfAnyAngleScenariosMayLieOnTheFarSide) {
  const std::string line = "0 a 4 4 0 0 4 4 5.65685";
  EXPECT_EQ(movingai_scenario(line, "x.scen", 2, ScenarioPlaces::corners).goal_column, 4U);
  EXPECT_THROW(movingai_scenario(line, "x.scen", 2, ScenarioPlaces::cells), InputError);
}

TEST(MovingAi, BrokenScenariosNameTheirLine) {
  const auto refuse = [](const std::string& text) -> std::string {
    return test::refusal_of([&] { read_movingai_scenarios(text, "x.scen"); });
  };
  EXPECT_THAT(refuse(""), HasSubstr("empty"));
  EXPECT_EQ(refuse("0 a 1 1 0 0 0 0 0\n"), "accepted") << "without a version";
  EXPECT_THAT(refuse("a 1 1 0 0 0 0 0\n"), HasSubstr("x.scen:1: a scenario begins with `version 1`"));
  EXPECT_THAT(refuse("0 a 1 1 0 0 0 0 0\nversion 1\n"), HasSubstr("x.scen:2: "));
  EXPECT_THAT(refuse("version 2\n"), HasSubstr("version '2'"));
  EXPECT_THAT(refuse("version 1\n0 a 4 4 0 0 4 0 1\n"), HasSubstr("x.scen:2: the goal lies outside"));
  EXPECT_THAT(refuse("version 1\n0 a 4 4 0 0 1 0\n"), HasSubstr("the length is missing"));
  EXPECT_THAT(refuse("version 1\n0 a 4 4 0 0 1 0 1 1\n"), HasSubstr("follows the length"));
}

TEST(MovingAi, IsAWorldInItsOwnCoordinatesKnownByItsContent) {
  EXPECT_EQ(detect_format(kSmall), Format::movingai);
  const FreeSpace space(read_world(kSmall));
  EXPECT_EQ(space.locate({0.5, 0.5}).kind, Location::Kind::triangle);
  EXPECT_EQ(space.locate({0.5, 1.5}).kind, Location::Kind::outside);
  EXPECT_EQ(space.locate({1.5, 2.5}).kind, Location::Kind::triangle);
  EXPECT_EQ(space.locate({2.5, 2.5}).kind, Location::Kind::outside);
  EXPECT_EQ(space.component_count(), 3U);
}

}  // namespace
}  // namespace taut
