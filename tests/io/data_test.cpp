// data/README.md promises a shortest path for each file; here it is kept.
#include <fstream>
#include <regex>

#include <gtest/gtest.h>

#include <taut/io/read_world.h>
#include <taut/search/shortest_path.h>
#include <taut/search/verify.h>

#include "support/paths.h"

namespace taut {
namespace {

TEST(Data, HasTheShortestPathsThatItsReadmePromises) {
  std::ifstream readme(test::data_dir() / "README.md");
  const std::regex row(R"(\| `([^`]+)` \|.*\| length ([0-9.]+), ([0-9]+) corners? \|)");
  std::size_t rows = 0;
  for (std::string line; std::getline(readme, line);) {
    std::smatch match;
    if (!std::regex_match(line, match, row)) continue;
    ++rows;
    const World world = read_world_file((test::data_dir() / match[1].str()).string());
    const FreeSpace space(world);
    const auto path = shortest_path(space, *world.start(), world.goal());
    ASSERT_TRUE(path) << match[1];
    EXPECT_EQ(path->length.decimals(6), match[2].str()) << match[1];
    EXPECT_EQ(std::to_string(path->points.size() - 2), match[3].str()) << match[1];
    EXPECT_TRUE(verify(*path, space, *world.start(), world.goal()).valid) << match[1];
  }
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(test::data_dir()))
    files += entry.is_regular_file() && entry.path().filename() != "README.md";  // folders hold no worlds
  EXPECT_EQ(rows, files);
}

}  // namespace
}  // namespace taut
