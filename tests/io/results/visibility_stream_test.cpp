#include <taut/io/results/visibility_stream.h>

#include <algorithm>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "support/random_world.h"

namespace taut {
namespace {

using test::SmallWorld;

TEST(VisibilityStream, WritesVerticesThenEdgesThenTheirNumber) {
  const SmallWorld world{.walls = {{{3, 3}, {3, 7}}, {{7, 3}, {7, 7}}}, .solids = {}};
  std::string text;
  const VisibilityRows rows(world.space(), VisibilityKind::reduced);
  EXPECT_EQ(stream_visibility(rows, [&](std::string_view piece) { text += piece; }), 6u);
  EXPECT_EQ(std::count(text.begin(), text.end(), 'v'), 4);
  EXPECT_EQ(text.substr(0, 2), "v ");
  EXPECT_NE(text.find("v 3 3\n"), std::string::npos);
  EXPECT_EQ(text.substr(text.rfind("end")), "end 6\n");
}

}  // namespace
}  // namespace taut
