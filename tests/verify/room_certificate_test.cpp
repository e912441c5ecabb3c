// Certificates of goals that are rooms: where a path enters, and what closes the border.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

#include "support/certified.h"
#include "support/small_world.h"

namespace taut {
namespace {

using nlohmann::json;
using testing::HasSubstr;

const Goal kRoom{std::nullopt, {{{7, 4}, {8, 6}}}};

FreeSpace with_walls(std::vector<Segment> walls) { return test::SmallWorld{.walls = std::move(walls)}.space(); }

json certificate(const FreeSpace& space, Point from, const Goal& to = kRoom) {
  return json::parse(test::certificate_of(space, from, to).value());
}

proof::Judgement judged(const FreeSpace& space, const json& claim) {
  return proof::judge(write_integers(space.world()), claim.dump());
}

void expect_shortest(const FreeSpace& space, Point from, double length) {
  const proof::Judgement said = judged(space, certificate(space, from));
  EXPECT_TRUE(said.proven) << said.words;
  EXPECT_NEAR(static_cast<double>(said.bound), length, 1e-9);
  EXPECT_NEAR(static_cast<double>(said.length), length, 1e-9);
}

TEST(RoomCertificate, ProvesThePathToTheNearestSide) { expect_shortest(with_walls({{{5, 0}, {5, 5}}}), {2, 5}, 5); }

TEST(RoomCertificate, ProvesThePathAroundAWallOnTheBorder) {
  expect_shortest(with_walls({{{7, 3}, {7, 7}}}), {5, 5}, 2 * std::sqrt(2) + 1);
}

TEST(RoomCertificate, ProvesThePathAroundACornerOfTheBorderThatIsWalledOnBothSides) {
  expect_shortest(with_walls({{{7, 4}, {7, 8}}, {{7, 4}, {8, 4}}}), {6, 5}, 1 + std::sqrt(2));
}

TEST(RoomCertificate, ProvesALengthOfZeroInTheRoom) { expect_shortest(with_walls({}), {7.5, 5}, 0); }

TEST(RoomCertificate, ProvesThePathToWhereASlopedWallMeetsTheBorderAtAThird) {
  const FreeSpace space = with_walls({{{5, 3}, {8, 7}}, {{5, 3}, {0, 3}}});  // x = 7 at 17 / 3
  const json claim = certificate(space, {2, 9});
  EXPECT_EQ(claim["scale"].get<std::int64_t>() % 3, 0);
  const proof::Judgement said = judged(space, claim);
  EXPECT_TRUE(said.proven) << said.words;
}

TEST(RoomCertificate, ProvesThatThereIsNoPathToARoomThatIsWalledOnAllSides) {
  const FreeSpace space = with_walls({{{7, 3}, {7, 7}}, {{8, 3}, {8, 7}}, {{6, 4}, {9, 4}}, {{6, 6}, {9, 6}}});
  EXPECT_EQ(judged(space, certificate(space, {2, 5})).words, "there is no path");
}

TEST(RoomCertificate, OfAWorldWithoutOneOfThoseWallsIsRefused) {
  const std::vector<Segment> walls{{{7, 3}, {7, 7}}, {{8, 3}, {8, 7}}, {{6, 4}, {9, 4}}, {{6, 6}, {9, 6}}};
  const json claim = certificate(with_walls(walls), {2, 5});
  for (std::size_t i = 0; i < walls.size(); ++i) {
    std::vector<Segment> others = walls;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
    const FreeSpace open = with_walls(others);
    EXPECT_THAT(proof::judge(write_integers(open.world()), test::about(open.world(), claim)).words,
                HasSubstr("nothing stops the leg"));
  }
}

TEST(RoomCertificate, ThatSaysMoreThanTheFootIsAwayIsRefused) {
  const FreeSpace space = with_walls({{{5, 0}, {5, 5}}});
  json claim = certificate(space, {2, 5});
  claim["reach"] = claim["reach"].get<std::int64_t>() + 1;
  EXPECT_THAT(judged(space, claim).words, HasSubstr("nothing stops the leg"));
}

TEST(RoomCertificate, WhosePathEndsOutsideTheRoomIsRefused) {
  const FreeSpace space = with_walls({{{5, 0}, {5, 5}}});
  json claim = certificate(space, {2, 5});
  for (json& corner : claim["goal"]) corner[0] = corner[0].get<std::int64_t>() + 1;
  EXPECT_THAT(judged(space, claim).words, HasSubstr("not in the goal"));
}

TEST(RoomCertificate, WhosePathEndsAtAWallWithTheRoomBehindItIsRefused) {
  const FreeSpace space = with_walls({{{7, 3}, {7, 7}}});
  json claim = certificate(space, {5, 5});
  const auto scale = claim["scale"].get<std::int64_t>();
  claim["path"] = json::array({{5 * scale, 5 * scale}, {7 * scale, 5 * scale}});
  EXPECT_EQ(judged(space, claim).words, "the path does not get from (5, 5) to (7, 5)");
}

TEST(RoomCertificate, OfAGoalThatIsALineCannotBeRead) {
  const FreeSpace space = with_walls({});
  json claim = certificate(space, {2, 5});
  claim["goal"][1][0] = claim["goal"][0][0];
  EXPECT_THROW(judged(space, claim), proof::BadInput);
}

TEST(RoomCertificate, IsOfRoomsThatAreRectangles) {
  EXPECT_TRUE(is_certifiable({std::nullopt, {{{1, 1}, {2, 3}}, {{2, 1}, {4, 3}}}}));
  EXPECT_FALSE(is_certifiable({std::nullopt, {{{1, 1}, {2, 3}}, {{2, 1}, {4, 2}}}}));
  EXPECT_FALSE(is_certifiable({std::nullopt, {}}));
}

}  // namespace
}  // namespace taut
