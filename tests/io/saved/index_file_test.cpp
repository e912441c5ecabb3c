#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include <taut/geometry/errors.h>
#include <taut/io/saved/index_file.h>
#include <taut/io/worlds/read_world.h>

#include "support/refusal.h"
#include "support/run_program.h"

namespace taut {
namespace {

using namespace test;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

constexpr const char* kRoom = "0 0 4 0\n4 0 4 4\n4 4 0 4\n0 4 0 0\n2 0 2 3\n1 0.1 1 1\nstart 1 2\ngoal 3 2\n";

World world(const std::string& text, const std::string& source = "room.txt") {
  return read_world(text, ReadOptions{.source = source});
}

class IndexFile : public testing::Test {
 protected:
  std::string kept(const std::string& bytes) { return folder.file("kept.index", bytes); }
  std::string refusal(const std::string& bytes, const FreeSpace& of) {
    const std::string path = kept(bytes);
    return refusal_of([&] { load_index(path, of); });
  }

  Folder folder;
  FreeSpace space{world(kRoom)};
  std::string good = index_file(Index(space));
};

TEST_F(IndexFile, AnswersAsTheIndexItCameFrom) {
  IndexSearch built{Index(space)}, loaded{load_index(kept(good), space)};
  for (const Point from : {Point{0.5, 0.5}, Point{1, 0.5}, Point{2, 3}, Point{1.37, 3.9}})
    for (const Point to : {Point{3, 1}, Point{2, 1}, Point{4, 4}}) {
      EXPECT_EQ(built.find(from, to), SearchStatus::found);
      EXPECT_EQ(loaded.find(from, to), SearchStatus::found);
      EXPECT_EQ(loaded.points(), built.points());
    }
}

TEST_F(IndexFile, OutlivesTheNameOfItsFile) {
  const std::string path = kept(good);
  const Index index = load_index(path, space);
  std::filesystem::remove(path);
  IndexSearch search(index);
  EXPECT_EQ(search.find({0.5, 0.5}, {3, 1}), SearchStatus::found);
}

TEST_F(IndexFile, IsTheSameEachTime) { EXPECT_EQ(index_file(Index(FreeSpace(world(kRoom)))), good); }

TEST_F(IndexFile, IsRefusedForAnotherWorldOrRobot) {
  const FreeSpace other(world(std::string(kRoom) + "3 3 3 4\n", "other.txt"));
  EXPECT_THAT(refusal(good, other), AllOf(HasSubstr("kept.index: was built of room.txt"), HasSubstr("not of other.txt"),
                                          Not(HasSubstr("\n"))));
  EXPECT_THAT(refusal(good, FreeSpace(world(kRoom), Footprint::disc(0.1))),
              HasSubstr("was built for the robot `point`, not for `disc 0.1`"));
}

TEST_F(IndexFile, IsRefusedWhenItIsNoneOrCutOffOrDamaged) {
  EXPECT_THAT(refusal("", space), HasSubstr("is no saved index"));
  EXPECT_THAT(refusal("taut roadmap 1\n", space), HasSubstr("is no saved index"));
  EXPECT_THAT(refusal("taut index 7\n", space),
              HasSubstr("is a saved index of version 7; this program reads version 1"));
  EXPECT_THAT(refusal(good.substr(0, 40), space), HasSubstr("is damaged"));
  for (const std::size_t size : {good.find("end\n") + 4, good.size() / 2, good.size() - 4})
    EXPECT_THAT(refusal(good.substr(0, size), space), HasSubstr("kept.index: is cut off"));
  for (std::size_t i = good.find("end\n") + 64; i < good.size(); i += 37) {
    std::string bad = good;
    bad[i] ^= 4;
    EXPECT_THAT(refusal(bad, space), HasSubstr("kept.index: ")) << i;
  }
}

TEST_F(IndexFile, IsRefusedWhereThereIsNoSuchFile) {
  EXPECT_THAT(refusal_of([&] { load_index((folder / "none").string(), space); }), HasSubstr("cannot be opened"));
  EXPECT_THAT(refusal_of([&] { load_index((folder / "").string(), space); }), HasSubstr("is no regular file"));
}

}  // namespace
}  // namespace taut
