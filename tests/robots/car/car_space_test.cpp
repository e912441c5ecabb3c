// Exact sweeps of a general car: two exact methods that share nothing, and many sampled poses, must agree.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

#include <taut/geometry/errors.h>
#include <taut/robots/car/car_space.h>
#include <taut/robots/car/detail/prepared_leg.h>
#include <taut/robots/car/verify_drive.h>

namespace taut::car {
namespace {

using detail::Answer;

TEST(Heading, IsAUnitVectorExactly) {
  for (int h = 0; h < kHeadings; ++h) {
    const HeadingVector v = heading_vector(h), quarter = heading_vector((h + 16) % kHeadings);
    EXPECT_EQ(std::int64_t{v.x} * v.x + std::int64_t{v.y} * v.y, std::int64_t{kHeadingScale} * kHeadingScale) << h;
    EXPECT_EQ(quarter, (HeadingVector{-v.y, v.x}));
    const double off =
        std::remainder(heading_angle(h) - h * std::numbers::pi / 32, 2 * std::numbers::pi) * 180 / std::numbers::pi;
    EXPECT_LE(std::abs(off), h % 16 == 8 ? 0.24 : 0.19) << h;
    EXPECT_EQ(nearest_heading(heading_angle(h) + 4 * std::numbers::pi), h);
    if (h % 16 != 8) {
      EXPECT_EQ(heading_vector((80 - h) % kHeadings), (HeadingVector{v.y, v.x})) << h;
    }
  }
}

/// A car, a leg that it can drive, and a wall that it does not meet at the beginning.
struct Case {
  CarShape shape;
  Leg leg;
  Segment wall;
};

class Cases {
 public:
  explicit Cases(bool quarters) : quarters_(quarters) {}

  Case next() {
    for (;;) {
      Case c = draw();
      if (c.wall.a == c.wall.b || validate(c.leg, c.shape) || stand_meets(c.leg.from, c.shape, c.wall)) continue;
      return c;
    }
  }

 private:
  int below(int n) { return static_cast<int>(engine_() % static_cast<unsigned>(n)); }
  /// In [low, high]; of `quarters_` a multiple of 1/4, so that much touches and is in line.
  double number(double low, double high) {
    const double t = static_cast<double>(engine_() >> 8) / (1 << 24), x = low + (high - low) * t;
    return quarters_ ? std::round(4 * x) / 4 : x;
  }
  Point point(double low, double high) {
    const double x = number(low, high);
    return {x, number(low, high)};
  }

  Case draw() {
    Case c;
    const double front = number(0.25, 1);
    const double back = number(0, 0.5), half = number(0.25, 0.5);
    c.shape = {front, back, half, number(0.25, 0.8), true};
    const int strides[] = {16, 4, 1};
    const int stride = strides[below(3)];
    c.leg.from.heading = below(64 / stride) * stride;
    c.leg.to.heading = (c.leg.from.heading + (below(24 / stride * 2 + 1) - 24 / stride) * stride + 64) % 64;
    c.leg.backward = below(2) != 0;
    c.leg.from.at = point(0, 2);
    c.leg.to.at = point(0, 2);
    c.wall.a = point(-0.5, 2.5);
    const double long_wall = below(3) == 0 ? 0.05 : 1.5;
    c.wall.b = {c.wall.a.x + number(-long_wall, long_wall), c.wall.a.y + number(-long_wall, long_wall)};
    return c;
  }

  bool quarters_;
  std::mt19937 engine_{11};
};

template <class N>
Answer swept(const Case& c) {
  const auto relative = [&](Point p) { return detail::difference<N>(c.leg.from.at, p); };
  return detail::LegSweep<N>(c.leg, c.shape).met_by(relative(c.wall.a), relative(c.wall.b));
}

/// Does the car at the pose, its sides moved out by `by`, meet the wall? In doubles.
bool meets_pose(const Pose& pose, const CarShape& shape, const Segment& wall, double by) {
  const double c = std::cos(pose.heading), s = std::sin(pose.heading);
  const auto inward = [&](Point p) {
    return Point{c * (p.x - pose.x) + s * (p.y - pose.y), c * (p.y - pose.y) - s * (p.x - pose.x)};
  };
  const Point a = inward(wall.a), b = inward(wall.b);
  double low = 0, high = 1;
  const auto clip = [&](double at, double step, double least, double most) {
    if (step == 0) {
      if (at < least || at > most) high = -1;
      return;
    }
    const double t = (least - at) / step, u = (most - at) / step;
    low = std::max(low, std::min(t, u));
    high = std::min(high, std::max(t, u));
  };
  clip(a.x, b.x - a.x, -shape.back - by, shape.front + by);
  clip(a.y, b.y - a.y, -shape.half_width - by, shape.half_width + by);
  return low <= high;
}

bool sampled_meets(const Case& c, int poses, double by) {
  for (int i = 0; i <= poses; ++i)
    if (meets_pose(pose_on(c.leg, static_cast<double>(i) / poses), c.shape, c.wall, by)) return true;
  return false;
}

void compare_methods(bool quarters, int cases, int& met, int& touched) {
  Cases draw(quarters);
  for (int i = 0; i < cases; ++i) {
    const Case c = draw.next();
    const bool exact = drive_meets(c.leg, c.shape, c.wall);
    EXPECT_EQ(swept<detail::Infinitesimal>(c) == Answer::yes, exact) << "case " << i;
    const Answer quick = swept<detail::Approx>(c), closed = swept<Rational>(c);
    EXPECT_TRUE(quick == Answer::doubt || (quick == Answer::yes) == exact) << "case " << i;
    EXPECT_TRUE(!exact || closed == Answer::yes) << "case " << i;
    detail::NearWall wall(c.wall, c.leg.from.at);
    EXPECT_EQ(detail::PreparedLeg(c.leg, c.shape).meets(wall, c.leg, c.shape), exact) << "case " << i;
    met += exact;
    touched += !exact && closed == Answer::yes;
  }
}

TEST(Sweep, AgreesWithTheQuadraticsOnWallsAtRandom) {
  int met = 0, touched = 0;
  compare_methods(false, 600, met, touched);
  EXPECT_GT(met, 80);
}

TEST(Sweep, AgreesWithTheQuadraticsWhereMuchTouches) {
  int met = 0, touched = 0;
  compare_methods(true, 900, met, touched);
  EXPECT_GT(met, 200);
  EXPECT_GT(touched, 30) << "touching is not meeting";
}

TEST(Sweep, MissesNoContactThatSamplesFindAndClaimsNoneWithoutAWitness) {
  Cases draw(false);
  int met = 0;
  for (int i = 0; i < 4000; ++i) {
    const Case c = draw.next();
    detail::NearWall wall(c.wall, c.leg.from.at);
    const bool exact = detail::PreparedLeg(c.leg, c.shape).meets(wall, c.leg, c.shape);
    met += exact;
    EXPECT_TRUE(exact || !sampled_meets(c, 200, -1e-9)) << "case " << i;
    EXPECT_TRUE(!exact || sampled_meets(c, 2000, 1e-3)) << "case " << i;
  }
  EXPECT_GT(met, 500);
}

const CarShape kCar{2, 0.5, 0.5, 1, true};
const Leg kQuarterLeft{{{0, 0}, 0}, {{2, 2}, 16}, false};  // the arc of radius 2 around (0, 2)

TEST(Sweep, FindsAWallThatOnlyASidePassesOver) {
  // Between the inner side, 1.5 from the pivot, and the corners' arcs.
  EXPECT_TRUE(drive_meets(kQuarterLeft, kCar, {{1.13, 0.87}, {1.14, 0.86}}));
  EXPECT_EQ(swept<detail::Approx>({kCar, kQuarterLeft, {{1.13, 0.87}, {1.14, 0.86}}}), Answer::yes);
  // The inner side's foot is nearer to the pivot than any corner: no corner's arc comes this near.
  const Segment inside{{1.08, 0.92}, {1.06, 0.94}};
  EXPECT_GT(std::hypot(0.5, 1.5), std::hypot(1.08, 1.08));
  EXPECT_EQ(swept<detail::Infinitesimal>({kCar, kQuarterLeft, inside}), Answer::yes);
  EXPECT_FALSE(drive_meets(kQuarterLeft, kCar, {{1.05, 0.95}, {0.9, 1.1}}));
  EXPECT_EQ(swept<detail::Infinitesimal>({kCar, kQuarterLeft, {{1.05, 0.95}, {0.9, 1.1}}}), Answer::no);
}

TEST(Sweep, LetsTheCarTouchAndSlideAlongAWall) {
  const Leg straight{{{0, 0}, 0}, {{3, 0}, 0}, false};
  for (const Segment wall : {Segment{{-1, 0.5}, {9, 0.5}}, Segment{{5, -1}, {5, 1}}, Segment{{1, -0.5}, {1, -2}}}) {
    EXPECT_FALSE(drive_meets(straight, kCar, wall));
    EXPECT_EQ(swept<detail::Infinitesimal>({kCar, straight, wall}), Answer::no);
    EXPECT_EQ(swept<Rational>({kCar, straight, wall}), Answer::yes) << "the closed car does";
  }
  EXPECT_TRUE(drive_meets(straight, kCar, {{std::nextafter(5, 0), -1}, {5, 1}}));
}

FreeSpace walls(std::vector<Wall> walls) {
  WorldParts parts;
  parts.areas.push_back({{{{-10, -10}, {20, -10}, {20, 10}, {-10, 10}}, {}}, 0});
  parts.boundary = Boundary::limit;
  parts.walls = std::move(walls);
  return FreeSpace(World(parts));
}

TEST(CarSpace, LetsTheCarThroughAGapOfExactlyItsWidth) {
  const auto passes = [](double upper) {
    const CarSpace space(walls({{{0, -0.5}, {4, -0.5}, 0, 0}, {{0, upper}, {4, upper}, 0, 0}}), kCar);
    return space.is_clear({{{-4, 0}, 0}, {{6, 0}, 0}, false});
  };
  EXPECT_TRUE(passes(0.5));
  EXPECT_FALSE(passes(std::nextafter(0.5, 0)));
}

TEST(CarSpace, RefusesToStandInWallsAndToLeaveTheWorld) {
  const CarSpace space(walls({{{0, -1}, {0, 1}, 0, 0}}), kCar);
  EXPECT_FALSE(space.is_free({{-1, 0}, 0}));
  EXPECT_TRUE(space.is_free({{0.5, 0}, 0})) << "its rear end touches";
  EXPECT_TRUE(space.is_free({{20, 0}, 0})) << "it sticks out of the opening";
  EXPECT_FALSE(space.is_free({{20.1, 0}, 0}));
  EXPECT_TRUE(space.is_clear({{{19, 0}, 0}, {{20, 0}, 0}, false}));
  EXPECT_FALSE(space.is_clear({{{19, 0}, 0}, {{21, 0}, 0}, false}));
}

TEST(Leg, NamesWhatTheCarCannotDrive) {
  using testing::HasSubstr;
  const auto fault = [](const Leg& leg, const CarShape& shape = kCar) { return validate(leg, shape).value_or("none"); };
  EXPECT_EQ(fault(kQuarterLeft), "none");
  EXPECT_THAT(fault(kQuarterLeft, {2, 0.5, 0.5, 2.001, true}), HasSubstr("radius 2"));
  EXPECT_THAT(fault({{{0, 0}, 0}, {{-2, 2}, 16}, false}), HasSubstr("direction"));
  EXPECT_THAT(fault({{{0, 0}, 0}, {{2, 1e-300}, 0}, false}), HasSubstr("not along"));
  EXPECT_THAT(fault({{{0, 0}, 0}, {{2, 0}, 32}, false}), HasSubstr("180"));
  EXPECT_THAT(fault({{{2, 0}, 0}, {{0, 0}, 0}, true}, {2, 0.5, 0.5, 1, false}), HasSubstr("back"));
  EXPECT_EQ(fault({{{2, 0}, 0}, {{0, 0}, 0}, true}), "none");
}

TEST(Leg, HasALengthAndPosesBetween) {
  EXPECT_NEAR(curve_of(kQuarterLeft).length(), std::numbers::pi, 1e-12);
  const Leg longer{{{-1, 0}, 0}, {{2, 2}, 16}, false};
  EXPECT_NEAR(curve_of(longer).length(), std::numbers::pi + 1, 1e-12);
  const Pose middle = pose_on(longer, (1 + std::numbers::pi / 2) / (1 + std::numbers::pi));
  EXPECT_NEAR(middle.x, 2 * std::sin(std::numbers::pi / 4), 1e-12);
  EXPECT_NEAR(middle.heading, std::numbers::pi / 4, 1e-12);
  EXPECT_EQ(pose_on(longer, 1).y, 2);
}

TEST(CarShape, IsRoundedUpAndChecked) {
  const CarShape shape = car_shape(0.4, 0.2, 0.3, 0.1);
  EXPECT_GE(shape.front + 0.1, 0.4);
  EXPECT_THROW(car_shape(0.4, 0.2, 0.3, 0.5), InputError);
  EXPECT_THROW(car_shape(0.4, 0, 0.3, 0.1), InputError);
  EXPECT_THROW(car_shape(0.4, 0.2, std::nan(""), 0.1), InputError);
}

}  // namespace
}  // namespace taut::car
