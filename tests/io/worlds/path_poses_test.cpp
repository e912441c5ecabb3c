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

TEST(PathPoses, AreRefusedWhereTheParserWouldNeverComeBack) {
  const std::string nothing = ": is no YAML: what stands here belongs to nothing";
  EXPECT_EQ(refusal("\"\",\nposes:\n"), "p.yaml:1" + nothing);
  EXPECT_EQ(refusal("poses: []\n---\n\"poses\", more\n"), "p.yaml:3" + nothing);
  EXPECT_NE(refusal(std::string(",I\0r:\nposes:\n @\n-1)\n", 20)), "accepted");
  EXPECT_NE(refusal(std::string("poses:\n- \0\n", 11)), "accepted");
}

}  // namespace
}  // namespace taut
