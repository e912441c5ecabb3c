// The judge of certificates: what it reads, what it approves, what it says of the rest.
#include <taut/verify/judge.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <string>

#include <fmt/format.h>

namespace taut::proof {
namespace {

using testing::HasSubstr;

// A wall from the floor to three quarters of the height.
constexpr const char* kRoom = "taut integers 1\nunit 1/10\nboundary limit\narea 0 0 40 0 40 40 0 40\nwall 20 0 20 30\n";

// FNV-1a, 64 bits.
std::string fingerprint(const std::string& text) {
  std::uint64_t hash = 14695981039346656037U;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211U;
  return fmt::format("{:016x}", hash);
}

std::string certificate(const std::string& world, const std::string& path, const std::string& potentials,
                        const std::string& kind = "shortest", int reach = 50) {
  const std::string goal = path.size() > 2 ? "[" + path.substr(path.rfind('[')) : path;  // its last place
  return R"({"format": "taut certificate 1", "kind": ")" + kind + R"(", "world": ")" + fingerprint(world) +
         R"(", "scale": 1, "fraction_bits": 0, "horizon": 1000, "reach": )" + std::to_string(reach) + R"(, "goal": )" +
         goal + R"(, "path": )" + path + R"(, "potentials": )" + potentials + "}";
}

// 25 + 25 around the wall's end, 3-4-5 triangles.
Judgement judge_room(const std::string& path, const std::string& potentials, int reach = 50) {
  return judge(kRoom, certificate(kRoom, path, potentials, "shortest", reach));
}

TEST(Judge, ApprovesAPathWhosePotentialsRiseByNoMoreThanLegsAreLong) {
  const Judgement said = judge_room("[[5, 10], [20, 30], [35, 10]]", "[[5, 10, 0], [20, 30, 25]]");
  EXPECT_TRUE(said.proven) << said.words;
  EXPECT_DOUBLE_EQ(static_cast<double>(said.bound), 5);
  EXPECT_THAT(said.words, HasSubstr("no path is shorter than"));
}

TEST(Judge, NamesALegThatIsShorterThanPotentialsSay) {
  const Judgement said = judge_room("[[5, 10], [20, 30], [35, 10]]", "[[5, 10, 0], [20, 30, 25]]", 51);
  EXPECT_FALSE(said.proven);
  EXPECT_EQ(said.words, "nothing stops the leg (2, 3)-(3.5, 1), shorter than potentials say");
}

// Legs of 25 each, of which a root rounded down is 25 and no more.
TEST(Judge, AddsOneToARootRoundedDownForTheLengthOfALeg) {
  const Judgement said = judge_room("[[5, 10], [20, 30], [35, 10]]", "[[5, 10, 0], [20, 30, 25]]");
  EXPECT_DOUBLE_EQ(static_cast<double>(said.length), 5.2);
}

// The wall's end, 25 from both, is not listed: it has 25 less than the horizon, or one less still.
TEST(Judge, GivesWhatIsNotListedTheHorizonLessItsWayToTheGoalAndNotAUnitLess) {
  const auto judge_horizon = [](const std::string& horizon) {
    std::string claim = certificate(kRoom, "[[5, 10], [20, 30], [35, 10]]", "[[5, 10, 0]]", "shortest", 49);
    claim.replace(claim.find("1000"), 4, horizon);
    return judge(kRoom, claim);
  };
  EXPECT_TRUE(judge_horizon("50").proven) << judge_horizon("50").words;
  EXPECT_EQ(judge_horizon("51").words, "nothing stops the leg (0.5, 1)-(2, 3), shorter than potentials say");
}

TEST(Judge, RefusesAPathThroughAWall) {
  const Judgement said = judge_room("[[5, 10], [35, 10]]", "[[5, 10, 0], [20, 30, 25]]");
  EXPECT_EQ(said.words, "the path does not get from (0.5, 1) to (3.5, 1)");
}

TEST(Judge, SaysHowMuchLongerAPathIsThatBendsAtNothing) {
  const Judgement said = judge_room("[[5, 10], [20, 33], [35, 10]]", "[[5, 10, 0], [20, 30, 25]]");
  EXPECT_TRUE(said.proven) << said.words;
  EXPECT_DOUBLE_EQ(static_cast<double>(said.bound), 5);
  EXPECT_GT(said.length, 5.4);
  EXPECT_THAT(said.words, HasSubstr("no path is shorter than 5.00000"));
}

TEST(Judge, RefusesAPathThatBendsOnAWallWhereNothingEnds) {
  const Judgement said = judge_room("[[5, 10], [20, 20], [5, 30], [20, 30], [35, 10]]", "[[5, 10, 0], [20, 30, 25]]");
  EXPECT_EQ(said.words, "the path bends at (2, 2), on a wall");
}

TEST(Judge, RefusesAPathThatBeginsInASolid) {
  const std::string world = "unit 1\narea 0 0 9 0 9 9 0 9\nsolid 1 1 8 1 8 8 1 8\n";
  const std::string claim = certificate(world, "[[2, 2], [5, 6]]", "[[2, 2, 0], [5, 6, 5]]");
  EXPECT_EQ(judge(world, claim).words, "the path does not get from (2, 2) to (5, 6)");
}

TEST(Judge, KnowsACertificateOfAnotherWorld) {
  std::string other = kRoom;
  other += "wall 0 0 1 1\n";
  EXPECT_EQ(judge(other, certificate(kRoom, "[[5, 10]]", "[]")).words, "the certificate is of another world");
}

TEST(Judge, DoesNotAskWhereTheWorldStartsAndEnds) {
  std::string with_ends = kRoom;
  with_ends += "start 0.5 1\ngoal 3.5 1\n";
  EXPECT_TRUE(
      judge(with_ends, certificate(kRoom, "[[5, 10], [20, 30], [35, 10]]", "[[5, 10, 0], [20, 30, 25]]")).proven);
}

TEST(Judge, ApprovesThatThereIsNoPathWhenNothingLeadsOutOfWhatIsReached) {
  const std::string world = "unit 1\narea 0 0 4 0 4 4 0 4\nwall 2 0 2 4\n";
  EXPECT_TRUE(judge(world, certificate(world, "[[1, 1], [3, 3]]", "[[1, 1, 0]]", "none")).proven);
}

TEST(Judge, RefusesThatThereIsNoPathWhereOneLeadsPastAWallsEnd) {
  const Judgement said = judge(kRoom, certificate(kRoom, "[[5, 10], [35, 10]]", "[[5, 10, 0]]", "none"));
  EXPECT_EQ(said.words, "nothing stops the leg (0.5, 1)-(2, 3), shorter than potentials say");
}

TEST(Judge, SaysWhatItCannotRead) {
  const auto refusal = [](const std::string& world, const std::string& claim) -> std::string {
    try {
      return judge(world, claim).words;
    } catch (const BadInput& error) {
      return error.what();
    }
  };
  EXPECT_THAT(refusal(kRoom, "{"), HasSubstr("the certificate cannot be read"));
  EXPECT_THAT(refusal(kRoom, "{}"), HasSubstr("the certificate cannot be read"));
  EXPECT_THAT(refusal(kRoom, certificate("", "[]", "[]", "longest")), HasSubstr("another format"));
  EXPECT_THAT(refusal(kRoom, certificate(kRoom, "[[5, 100]]", "[]")), HasSubstr("out of range"));
  EXPECT_THAT(refusal("unit 1\nwall 0 0 1\n", certificate("unit 1\nwall 0 0 1\n", "[[5, 100]]", "[]")),
              HasSubstr("cannot be read at 'wall 0 0 1'"));
}

}  // namespace
}  // namespace taut::proof
