// Turn, straight, turn: what is exact and what is not.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include <taut/geometry/draws.h>
#include <taut/robots/roadblocks/detail/steering.h>

namespace taut::roadblocks::detail {
namespace {

constexpr double kCircle = 2 * std::numbers::pi;

Pose driven(Pose pose, const std::vector<double>& controls) {
  for (const double control : controls) pose = stepped(pose, control);
  return pose;
}

Pose any_pose(taut::Draws& draws) {
  const double x = draws.unit();
  const double y = draws.unit();
  const double heading = draws.unit();
  return {12 * x, 12 * y, 20 * heading - 10};
}

TEST(Steering, HitsTheHeadingAndMissesThePositionByLittle) {
  taut::Draws draws(1);
  int with_ways = 0;
  for (int i = 0; i < 400; ++i) {
    const Pose from = any_pose(draws), to = any_pose(draws);
    const auto ways = steerings(from, to);
    with_ways += !ways.empty();
    int before = 0;
    for (const Steering& way : ways) {
      const std::vector<double> controls = way.controls();
      const Pose end = driven(from, controls);
      EXPECT_EQ(static_cast<int>(controls.size()), way.steps());
      EXPECT_GE(way.steps(), before);
      before = way.steps();
      EXPECT_NEAR(std::remainder(end.heading - to.heading, kCircle), 0, 1e-9);
      const double miss = std::hypot(end.x - to.x, end.y - to.y);
      EXPECT_LE(miss, kLanding + 1e-9);
      EXPECT_NEAR(miss, way.error, 1e-9);
    }
  }
  EXPECT_GT(with_ways, 390);
}

TEST(Steering, KnowsWhereATurnEndsWithoutDrivingIt) {
  for (const bool on_the_spot : {false, true})
    for (const bool fraction_first : {false, true})
      for (const double angle : {0.0, 0.05, -0.12, 0.4, -1.57, 3.1}) {
        const Turn turn{angle, on_the_spot, fraction_first};
        std::vector<double> controls;
        turn.append_to(controls);
        EXPECT_EQ(static_cast<int>(controls.size()), turn.steps());
        const Pose end = driven({0, 0, 0.7}, controls);
        EXPECT_NEAR(end.heading, 0.7 + angle, 1e-9);
        EXPECT_NEAR(end.x, turn.shift(0.7).x, 1e-9);
        EXPECT_NEAR(end.y, turn.shift(0.7).y, 1e-9);
        EXPECT_TRUE(!on_the_spot || std::hypot(end.x, end.y) < 0.01) << angle;
      }
}

TEST(Steering, UndoesAStep) {
  const Pose pose{3, 4, 0.9};
  for (const double control : {0.0, 1.0, -0.37, kReverse}) {
    const Pose back = stepped(unstepped(pose, control), control);
    EXPECT_NEAR(back.x, pose.x, 1e-12);
    EXPECT_NEAR(back.y, pose.y, 1e-12);
    EXPECT_NEAR(back.heading, pose.heading, 1e-12);
  }
}

}  // namespace
}  // namespace taut::roadblocks::detail
