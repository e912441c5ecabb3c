#include <taut/io/saved/all_radii_file.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include <taut/geometry/errors.h>
#include <taut/io/worlds/read_world.h>
#include <taut/roadmaps/exact/all_radii_parts.h>
#include <taut/search/arc_search.h>

#include "support/refusal.h"

namespace taut {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

constexpr const char* kRoom = "0 0 4 0\n4 0 4 4\n4 4 0 4\n0 4 0 0\n2 0 2 3\n1 0.1 1 1\nstart 1 2\ngoal 3 2\n";

World world(const std::string& text, const std::string& source = "room.txt") {
  return read_world(text, ReadOptions{.source = source});
}

class AllRadiiFile : public testing::Test {
 protected:
  static std::string refusal(const std::string& bytes, const FreeSpace& of) {
    return test::refusal_of([&] { read_all_radii(bytes, "kept.radii", of); });
  }

  FreeSpace space{world(kRoom)};
  std::string good = all_radii_file(AllRadii(space));
};

TEST_F(AllRadiiFile, HasTheSameGraphsAsTheIndexItCameFrom) {
  const AllRadii built(space), read = read_all_radii(good, "kept.radii", space);
  EXPECT_EQ(read.parts().legs, built.parts().legs);
  EXPECT_EQ(read.parts().spans, built.parts().spans);
  EXPECT_EQ(all_radii_file(read), good);
  for (const double r : {0.1, 0.25, 0.4, 0.5}) {
    const ArcSearchResult ours = arc_search(read.at_radius(r), {1, 2}, {3, 2}),
                          theirs = arc_search(built.at_radius(r), {1, 2}, {3, 2});
    EXPECT_EQ(ours.path.bends, theirs.path.bends);
    EXPECT_EQ(ours.status, theirs.status);
  }
}

TEST_F(AllRadiiFile, IsRefusedForAnotherWorld) {
  const FreeSpace other(world(std::string(kRoom) + "3 3 3 4\n", "other.txt"));
  EXPECT_THAT(refusal(good, other), AllOf(HasSubstr("kept.radii: was built of room.txt"), HasSubstr("not of other.txt"),
                                          Not(HasSubstr("\n"))));
}

TEST_F(AllRadiiFile, IsRefusedWhenItIsNoneOrCutOffOrDamaged) {
  EXPECT_THAT(refusal("", space), HasSubstr("is no saved index of radii"));
  EXPECT_THAT(refusal("taut radii 7\n", space), HasSubstr("of version 7; this program reads version 1"));
  EXPECT_THAT(refusal(good.substr(0, 40), space), HasSubstr("is damaged"));
  EXPECT_THAT(refusal(good.substr(0, good.size() - 1), space), HasSubstr("is cut off or damaged"));
  for (std::size_t i = good.find("end\n") + 4; i < good.size(); i += 37) {
    std::string bad = good;
    bad[i] ^= 4;
    EXPECT_THAT(refusal(bad, space), HasSubstr("is cut off or damaged")) << i;
  }
}

}  // namespace
}  // namespace taut
