// Roadblocks that are one door.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <taut/io/worlds/roadblock_map.h>
#include <taut/robots/roadblocks/doors.h>
#include <taut/robots/roadblocks/roadblock_map_generator.h>

namespace taut::roadblocks {
namespace {

constexpr WallReading kPoints = WallReading::points;

using Place = std::pair<int, int>;

/// Two rooms, above each other lanes between them: rows 4 to 5, and 9 to 14.
Course two_rooms(const std::vector<std::vector<Place>>& roadblocks) {
  std::vector<std::string> rows(20, "#" + std::string(48, '.') + "#");
  rows.front() = rows.back() = std::string(50, '#');
  for (std::size_t y = 1; y < 19; ++y)
    for (std::size_t x = 12; x < 36; ++x)
      if (!(y == 3 || y == 4) && !(y >= 8 && y < 14)) rows[y][x] = '#';
  std::string text = "start 5 5\ngoal 45 5\n";
  for (std::size_t b = 0; b < roadblocks.size(); ++b) {
    const char letter = static_cast<char>('A' + b);
    const auto [x, y] = roadblocks[b].front();
    text += "roadblock " + std::string(1, letter) + " " + std::to_string(x) + " " + std::to_string(y) + " 0.5\n";
    for (const auto& [column, row] : roadblocks[b])
      rows[static_cast<std::size_t>(row - 1)][static_cast<std::size_t>(column - 1)] = letter;
  }
  text += "grid 50 20\n";
  for (const std::string& row : rows) text += row + "\n";
  return read_roadblock_map(text).course;
}

std::vector<Place> column(int x, int from, int to) {
  std::vector<Place> cells;
  for (int y = from; y <= to; ++y) cells.emplace_back(x, y);
  return cells;
}

TEST(Doors, AreRoadblocksInSeriesInOneLaneWithTheProductOfTheirProbabilities) {
  const std::vector<Door> found = doors(two_rooms({{{20, 4}}, {{21, 5}}, {{24, 4}}}), kPoints);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].blocks, 7U);
  EXPECT_DOUBLE_EQ(found[0].open_probability, 0.125);
  ASSERT_EQ(found[0].sides.size(), 2U);
  EXPECT_LT(std::min(found[0].sides[0].look.x, found[0].sides[1].look.x), 18);
  EXPECT_GT(std::max(found[0].sides[0].look.x, found[0].sides[1].look.x), 26);
}

TEST(Doors, AreSeveralInSeveralLanesAndFarFromEachOther) {
  const std::vector<Door> found = doors(two_rooms({{{20, 4}}, column(20, 9, 14), {{33, 5}}}), kPoints);
  ASSERT_EQ(found.size(), 3U) << "who stands between A and C does not see both";
  for (std::size_t d = 0; d < 3; ++d) EXPECT_EQ(found[d].blocks, RoadblockSet{1} << d);
}

TEST(Doors, AreTwoWhereEachAloneLetsTheCarThrough) {
  const std::vector<Door> found = doors(two_rooms({column(24, 9, 11), column(24, 12, 14)}), kPoints);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].sides.size(), 2U);
  EXPECT_EQ(found[1].sides.size(), 2U);
}

TEST(Doors, HaveOneSideWhereTheyPartNothing) {
  const std::vector<Door> found = doors(two_rooms({{{43, 12}}}), kPoints);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_LT(found[0].sides.size(), 2U);
}

/// Letters of each door and their probability in thousandths.
std::set<std::pair<std::string, int>> letters(const Course& course) {
  std::set<std::pair<std::string, int>> all;
  for (const Door& door : doors(course, kPoints)) {
    std::string word;
    for (std::size_t b = 0; b < course.roadblocks.size(); ++b)
      if ((door.blocks >> b) & 1) word += course.roadblocks[b].letter;
    std::ranges::sort(word);
    all.emplace(word, static_cast<int>(1000 * door.open_probability + 0.5));
  }
  return all;
}

TEST(Doors, DoNotDependOnTheOrderAndHoldEveryRoadblockOnce) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    SCOPED_TRACE(seed);
    Course course = generate_roadblock_map({50, 50, 16, 0, seed}).course;
    const auto before = letters(course);
    RoadblockSet all = 0;
    for (const Door& door : doors(course, kPoints)) {
      EXPECT_EQ(all & door.blocks, 0U);
      all |= door.blocks;
      double product = 1;
      for (std::size_t b = 0; b < course.roadblocks.size(); ++b)
        if ((door.blocks >> b) & 1) product *= course.roadblocks[b].open_probability;
      EXPECT_DOUBLE_EQ(door.open_probability, product);
    }
    EXPECT_EQ(all, 0xffffU);
    std::ranges::reverse(course.roadblocks);
    EXPECT_EQ(letters(course), before);
    std::ranges::rotate(course.roadblocks, course.roadblocks.begin() + 5);
    EXPECT_EQ(letters(course), before);
  }
}

}  // namespace
}  // namespace taut::roadblocks
