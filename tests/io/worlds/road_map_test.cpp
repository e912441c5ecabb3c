// Files of mazes with roadblocks.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include <taut/io/worlds/roadblock_map.h>

#include "support/refusal.h"

namespace taut {
namespace {

using testing::HasSubstr;

TEST(RoadMapReader, NamesTheLineAndTheCulprit) {
  const auto message = [](const std::string& text) {
    return test::refusal_of([&] { read_roadblock_map(text, "m.txt"); });
  };
  const std::string head = "# c\r\nstart 1 1\r\ngoal 2 1\r\n";
  EXPECT_EQ(message(head + "grid 3 1\r\n...\r\n"), "accepted");
  EXPECT_THAT(message(head + "grid 3 1\n..\n"), HasSubstr("m.txt:5: a row of 2 cells"));
  EXPECT_THAT(message(head + "grid 3 1\n..x\n"), HasSubstr("m.txt:5: 'x' in column 3"));
  EXPECT_THAT(message(head + "grid 3 2\n...\n"), HasSubstr("the grid ends after 1 rows"));
  EXPECT_THAT(message(head + "roadblock A 1 1 2\ngrid 3 1\n..A\n"), HasSubstr("m.txt:4: P_OPEN '2'"));
  EXPECT_THAT(message(head + "roadblock A 3 1\ngrid 3 1\n..A\nsamples 1\n1 2\n"), HasSubstr("m.txt:8: '2' is not"));
  EXPECT_EQ(read_roadblock_map(head + "grid 3 1\n#.#\n").course.walls, (std::vector<std::uint8_t>{1, 0, 1}));
}

}  // namespace
}  // namespace taut
