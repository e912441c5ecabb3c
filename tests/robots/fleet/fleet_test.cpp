// Robots with times: who collides with whom, when and where.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>
#include <taut/geometry/exact/numbers.h>

#include <cmath>
#include <limits>
#include <random>
#include <set>

#include <taut/robots/fleet/fleet.h>

namespace taut::fleet {
namespace {

Robot robot(double radius, std::vector<TimedPoint> points) { return {"r", radius, std::move(points)}; }

TEST(Fleet, CollidesHeadOn) {
  const std::vector<Robot> robots{robot(0.5, {{0, {0, 0}}, {10, {10, 0}}}), robot(0.5, {{0, {10, 0}}, {10, {0, 0}}})};
  const auto found = collisions(robots);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].first, 0U);
  EXPECT_EQ(found[0].second, 1U);
  EXPECT_DOUBLE_EQ(found[0].from, 4.5);
  EXPECT_DOUBLE_EQ(found[0].to, 5.5);
  EXPECT_NEAR(found[0].first_at.x, 4.5, 1e-12);
  EXPECT_NEAR(found[0].second_at.x, 5.5, 1e-12);
}

TEST(Fleet, MayTouch) {
  const auto passing = [](double apart) {
    return collisions(
        std::vector<Robot>{robot(0.1, {{0, {0, 0}}, {1, {1, 0}}}), robot(0.2, {{0, {1, apart}}, {1, {0, apart}}})});
  };
  EXPECT_TRUE(passing(0.3).empty());  // the decimals, whose doubles say something else
  EXPECT_EQ(passing(0.299999999999999).size(), 1U);
}

TEST(Fleet, StandsWhereItEndsOrVanishes) {
  const std::vector<Robot> robots{robot(0.5, {{0, {0, 0}}, {1, {5, 0}}}), robot(0.5, {{3, {0, 0}}, {4, {9, 0}}})};
  EXPECT_EQ(collisions(robots).size(), 2U);  // one waits where the other one begins, and later in its way
  EXPECT_TRUE(collisions(robots, Ends::vanish).empty());
  const auto late = collisions(std::vector{robots[0], robot(0.5, {{3, {0, 3}}, {4, {9, 3}}, {5, {5, 0}}})});
  ASSERT_EQ(late.size(), 1U);
  EXPECT_EQ(late[0].to, std::numeric_limits<double>::infinity());
}

TEST(Fleet, TakesACollisionThatGoesOnAsOne) {
  const std::vector<Robot> robots{robot(1, {{0, {0, 0}}, {1, {1, 0}}, {2, {2, 0}}, {3, {3, 0}}}),
                                  robot(1, {{0, {0, 1}}, {1.5, {1.5, 1}}, {3, {3, 1}}})};
  const auto found = collisions(robots, Ends::vanish);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].from, 0);
  EXPECT_EQ(found[0].to, 3);
}

TEST(Fleet, GivesThemByTime) {
  std::vector<Robot> robots;
  for (int i = 0; i < 5; ++i) {
    const double y = 10.0 * i, start = 5.0 - i;
    robots.push_back(robot(1, {{start, {0, y}}, {start + 10, {10, y}}}));
    robots.push_back(robot(1, {{start, {10, y}}, {start + 10, {0, y}}}));
  }
  const auto found = collisions(robots);
  ASSERT_EQ(found.size(), 5U);
  for (std::size_t i = 0; i < 5; ++i) EXPECT_DOUBLE_EQ(found[i].from, 1 + static_cast<double>(i) + 4);
}

/// The least squared distance of two robots while both move, over all pairs of legs, in rationals: coordinates and
/// times are whole or halves.
bool meet(const Robot& a, const Robot& b) {
  const Rational reach = Rational(a.radius) + Rational(b.radius);
  for (std::size_t i = 0; i + 1 < a.points.size(); ++i)
    for (std::size_t k = 0; k + 1 < b.points.size(); ++k) {
      const Rational from = std::max(a.points[i].time, b.points[k].time);
      const Rational to = std::min(a.points[i + 1].time, b.points[k + 1].time);
      if (from > to) continue;
      const auto at = [](const Robot& r, std::size_t leg, const Rational& time) {
        const TimedPoint &p = r.points[leg], &q = r.points[leg + 1];
        const Rational part = (time - p.time) / (Rational(q.time) - p.time);
        return std::pair<Rational, Rational>(p.at.x + part * (Rational(q.at.x) - p.at.x),
                                             p.at.y + part * (Rational(q.at.y) - p.at.y));
      };
      const auto apart = [&](const Rational& time) {
        const auto [x, y] = at(a, i, time);
        const auto [u, v] = at(b, k, time);
        return std::pair<Rational, Rational>(u - x, v - y);
      };
      // The sign of the quadratic |d + t (e - d)|^2 - reach^2 at its ends and at its lowest point.
      const auto [dx, dy] = apart(from);
      const auto [ex, ey] = apart(to);
      const Rational qa = (ex - dx) * (ex - dx) + (ey - dy) * (ey - dy), qb = 2 * (dx * (ex - dx) + dy * (ey - dy)),
                     qc = dx * dx + dy * dy - reach * reach;
      if (qc < 0 || qa + qb + qc < 0) return true;
      if (qa > 0 && qb < 0 && -qb < 2 * qa && 4 * qa * qc < qb * qb) return true;
    }
  return false;
}

RC_GTEST_PROP(Fleet, AgreesWithAllPairsInRationals, ()) {
  std::vector<Robot> robots(*rc::gen::inRange<std::size_t>(2, 7));
  for (Robot& r : robots) {
    r.radius = *rc::gen::inRange(1, 4) / 2.0;
    double time = *rc::gen::inRange(0, 5);
    for (int i = *rc::gen::inRange(2, 5); i > 0; --i) {
      r.points.push_back({time, {*rc::gen::inRange(0, 13) / 1.0, *rc::gen::inRange(0, 13) / 1.0}});
      time += *rc::gen::inRange(1, 5) / 2.0;
    }
  }
  std::set<std::pair<std::size_t, std::size_t>> expected, found;
  for (std::size_t i = 0; i < robots.size(); ++i)
    for (std::size_t k = i + 1; k < robots.size(); ++k)
      if (meet(robots[i], robots[k])) expected.insert({i, k});
  for (const Collision& c : collisions(robots, Ends::vanish)) {
    found.insert({c.first, c.second});
    const double reach = robots[c.first].radius + robots[c.second].radius;
    RC_ASSERT(std::hypot(c.first_at.x - c.second_at.x, c.first_at.y - c.second_at.y) <= reach + 1e-9);
    RC_ASSERT(c.from <= c.to);
  }
  RC_ASSERT(found == expected);
}

// Lanes side by side, robots that turn back and forth on them: touching neighbours, no collision but the one planted.
TEST(Fleet, IsAskedInTimeThatGrowsWithTheLegs) {
  std::vector<Robot> robots;
  for (int i = 0; i < 200; ++i) {
    Robot r{std::to_string(i), 0.25, {}};
    for (int t = 0; t <= 50; ++t) r.points.push_back({t / 10.0, {(t + i) % 2 == 0 ? 0.3 : 0.7, i / 2.0}});
    robots.push_back(r);
  }
  EXPECT_TRUE(collisions(robots).empty());
  robots[77].points[30].at.y += 0.01;
  const auto found = collisions(robots);
  ASSERT_FALSE(found.empty());
  for (const Collision& c : found) EXPECT_TRUE(c.first == 77 || c.second == 77);
}

}  // namespace
}  // namespace taut::fleet
