// Paths as poses for ROS, YAML: what is wrong with them is one line, whatever YAML's own words hold.
#include <gtest/gtest.h>

#include <string>

#include <taut/io/worlds/read_path.h>

#include "support/refusal.h"

namespace taut {
namespace {

std::string refusal(const std::string& text) {
  return test::refusal_of([&] { read_paths(text, "p.yaml"); });
}

TEST(PathPoses, AreRefusedInOneLineWhereAnEscapeIsALineEnd) {
  const std::string said = refusal("header:\n  frame_id: map\nposes:\n- pose: \"\\\x01\"\n");
  EXPECT_EQ(said, "p.yaml:4: is no YAML: unknown escape character: ?");
}

TEST(PathPoses, AreRefusedInOneLineAsTheFuzzerFoundThem) {
  const std::string bytes("header:\n  frame_id: map\0\nposes:\n-\xa0pose:\n    position: {x: \xb1qqqq0  \n 2}\n", 70);
  const std::string said = refusal(bytes);
  EXPECT_EQ(said.find('\n'), std::string::npos) << said;
  EXPECT_NE(said, "accepted");
}

}  // namespace
}  // namespace taut
