// Dubins and Reeds-Shepp paths against random drives: no drive to a pose is shorter than the path to it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <set>
#include <string>
#include <vector>

#include <taut/robots/car/curve_bound.h>
#include <taut/robots/car/curve_path.h>

namespace taut::car {
namespace {

using Kind = CurveSegment::Kind;
constexpr double kPi = std::numbers::pi;

/// Draws that are the same everywhere.
class Draws {
 public:
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() >> 8) / (1 << 24);
  }
  int below(int n) { return static_cast<int>(engine_() % static_cast<unsigned>(n)); }
  Pose pose() {
    const double x = between(-4, 4), y = between(-4, 4);
    return {x, y, between(-7, 7)};
  }

 private:
  std::mt19937 engine_{7};
};

double miss(const Pose& a, const Pose& b) {
  return std::max(std::hypot(a.x - b.x, a.y - b.y), std::abs(std::remainder(a.heading - b.heading, 2 * kPi)));
}

/// The end of the path by another road: tiny steps of the differential equation (midpoint rule).
Pose integrated(const CurvePath& path) {
  Pose pose = path.from();
  for (const CurveSegment& s : path.segments()) {
    constexpr int kSteps = 4000;
    const double step = s.length / kSteps, curvature = s.kind == Kind::left    ? 1 / path.radius()
                                                       : s.kind == Kind::right ? -1 / path.radius()
                                                                               : 0;
    for (int i = 0; i < kSteps; ++i) {
      const double middle = pose.heading + curvature * step / 2;
      pose = {pose.x + step * std::cos(middle), pose.y + step * std::sin(middle), pose.heading + curvature * step};
    }
  }
  return pose;
}

TEST(CurvePath, EndsInItsGoal) {
  Draws draws;
  for (int i = 0; i < 5000; ++i) {
    const Pose from = draws.pose(), to = draws.pose();
    const double radius = draws.between(0.2, 3);
    EXPECT_LT(miss(dubins_path(from, to, radius).end(), to), 1e-11);
    EXPECT_LT(miss(reeds_shepp_path(from, to, radius).end(), to), 1e-11);
  }
}

TEST(CurvePath, IsDrivenAsItsSegmentsSay) {
  Draws draws;
  for (int i = 0; i < 20; ++i) {
    const CurvePath path = reeds_shepp_path(draws.pose(), draws.pose(), 1.5);
    EXPECT_LT(miss(integrated(path), path.end()), 1e-4) << path.word();
    const std::vector<Pose> poses = path.sampled(0.1);
    for (std::size_t k = 1; k < poses.size(); ++k)
      EXPECT_LE(std::hypot(poses[k].x - poses[k - 1].x, poses[k].y - poses[k - 1].y), 0.1 + 1e-12);
    EXPECT_LT(miss(poses.back(), path.end()), 1e-12);
    EXPECT_LT(miss(path.pose_at(0.25 * path.length()), path.pose_at(0.25 * path.length() + 1e-9)), 1e-8);
  }
}

// Random drives of up to five segments: the path to where they end is never longer, and for short drives it often is as
// long.
TEST(Dubins, IsNoLongerThanAnyDrive) {
  Draws draws;
  std::set<std::string> optimal;
  for (int i = 0; i < 30'000; ++i) {
    std::vector<CurveSegment> segments;
    for (int n = 1 + draws.below(5); n > 0; --n)
      segments.push_back({static_cast<Kind>(draws.below(3)), draws.between(0, 1) * draws.between(0, 6)});
    const CurvePath drive(draws.pose(), 1, segments);
    const CurvePath best = dubins_path(drive.from(), drive.end(), 1);
    ASSERT_LE(best.length(), drive.length() + 1e-9) << drive.word() << " beats " << best.word();
    if (best.length() > drive.length() - 1e-9 && best.segments().size() == 3) optimal.insert(best.word());
  }
  EXPECT_THAT(optimal, testing::ElementsAre("LRL", "LSL", "LSR", "RLR", "RSL", "RSR"));
}

TEST(ReedsShepp, IsNoLongerThanAnyDrive) {
  Draws draws;
  int as_long = 0;
  for (int i = 0; i < 30'000; ++i) {
    std::vector<CurveSegment> segments;
    const bool short_arcs = draws.below(3) == 0;
    for (int n = 1 + draws.below(5); n > 0; --n) {
      const Kind kind = static_cast<Kind>(draws.below(3));
      double length = draws.between(0, 1) * draws.between(0, 4);
      if (short_arcs && kind != Kind::straight) length = std::min(length, kPi / 2);
      segments.push_back({kind, draws.below(2) == 0 ? length : -length});
    }
    const CurvePath drive(draws.pose(), 1, segments);
    const CurvePath best = reeds_shepp_path(drive.from(), drive.end(), 1);
    ASSERT_LE(best.length(), drive.length() + 1e-9) << drive.word() << " beats " << best.word();
    as_long += best.length() > drive.length() - 1e-9;
  }
  EXPECT_GT(as_long, 5000);
}

TEST(ReedsShepp, NeedsAllOfIts48Words) {
  Draws draws;
  std::set<std::string> words;
  for (int i = 0; i < 20'000; ++i) words.insert(reeds_shepp_path(draws.pose(), draws.pose(), 2).word());
  EXPECT_EQ(words.size(), 48U);
}

TEST(ReedsShepp, IsSymmetricAndNeverLongerThanDubins) {
  Draws draws;
  for (int i = 0; i < 3000; ++i) {
    const Pose a = draws.pose(), b = draws.pose();
    const double there = reeds_shepp_path(a, b, 1).length();
    EXPECT_NEAR(there, reeds_shepp_path(b, a, 1).length(), 1e-9);
    EXPECT_LE(there, dubins_path(a, b, 1).length() + 1e-9);
  }
}

TEST(Dubins, IsNotSymmetric) {
  const Pose a{0, 0, 0}, b{3, 0, 0};
  EXPECT_NEAR(dubins_path(a, b, 1).length(), 3, 1e-12);
  EXPECT_GT(dubins_path(b, a, 1).length(), 3 + kPi);
}

TEST(Dubins, KnowsItsLimits) {
  EXPECT_EQ(dubins_path({1, 2, 3}, {1, 2, 3}, 1).length(), 0);
  EXPECT_EQ(reeds_shepp_path({1, 2, 3}, {1, 2, 3}, 1).length(), 0);
  EXPECT_NEAR(dubins_path({0, 0, 0}, {0, 2, kPi}, 1).length(), kPi, 1e-9);     // half a circle
  EXPECT_NEAR(reeds_shepp_path({0, 0, 0}, {-2, 0, 0}, 1).length(), 2, 1e-12);  // straight back
  EXPECT_EQ(reeds_shepp_path({0, 0, 0}, {-2, 0, 0}, 1).word(), "S-");
}

TEST(CurveBound, IsNoLongerThanThePathAndHardlyShorter) {
  Draws draws;
  for (int i = 0; i < 3000; ++i) {
    const Pose a = draws.pose(), b = draws.pose();
    const double dubins = dubins_path(a, b, 1.5).length(), reeds = reeds_shepp_path(a, b, 1.5).length();
    EXPECT_LE(detail::dubins_bound(a, b, 1.5), dubins);
    EXPECT_GE(detail::dubins_bound(a, b, 1.5), dubins - 1e-4);
    EXPECT_LE(detail::reeds_shepp_bound(a, b, 1.5), reeds);
    EXPECT_GE(detail::reeds_shepp_bound(a, b, 1.5), reeds - 1e-4);
  }
}

}  // namespace
}  // namespace taut::car
