// Anybody's paths: where they first meet a wall, how near they come.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include <taut/io/worlds/read_world.h>
#include <taut/search/path_audit.h>

namespace taut {
namespace {

using testing::HasSubstr;

World world(const std::string& text) { return read_world(text, {}); }

const char* const kRoom = "boundary 0 0 4 4\n2 0 2 3\n1 4 1 3.5\n";

TEST(PathAudit, NamesTheFirstWallInTheWayWithItsLine) {
  const PathAuditor auditor(world("boundary 0 0 4 4\n3 0 3 3\n2 0 2 3\n"), Footprint::point());
  const PathAudit audit = auditor.audit({{0.5, 3.5}, {0.5, 1}, {3.5, 1}});
  EXPECT_FALSE(audit.valid);
  ASSERT_TRUE(audit.contact);
  EXPECT_EQ(audit.contact->leg, 1U);
  EXPECT_EQ(audit.contact->at, (Point{2, 1}));
  EXPECT_EQ(audit.contact->wall.line, 3);
  EXPECT_THAT(audit.reason, HasSubstr("leg 1, (0.5, 1) to (3.5, 1), crosses the wall"));
}

TEST(PathAudit, SaysWhereAPathSlipsThroughAJoint) {
  const PathAuditor auditor(world("boundary 0 0 4 4\n2 0 2 2\n2 2 2 4\n"), Footprint::point());
  const PathAudit audit = auditor.audit({{1, 1}, {2, 2}, {3, 3}});
  ASSERT_TRUE(audit.contact);
  EXPECT_EQ(audit.contact->at, (Point{2, 2}));
}

TEST(PathAudit, MeasuresClearanceAndLengthExactly) {
  const PathAuditor auditor(world(kRoom), Footprint::point());
  const PathAudit audit = auditor.audit({{1.75, 1}, {1.75, 3.5}, {3, 3.5}});
  EXPECT_TRUE(audit.valid) << audit.reason;
  EXPECT_EQ(audit.clearance, 0.25);
  EXPECT_EQ(audit.length.value(), 3.75);
  ASSERT_TRUE(audit.nearest);
  EXPECT_EQ(audit.nearest->line, 2);
}

TEST(PathAudit, LetsADiscTouchAndNoMore) {
  const PathAuditor touching(world(kRoom), Footprint::disc(0.5));
  EXPECT_TRUE(touching.audit({{1.5, 1}, {1.5, 3.5}}).valid);
  EXPECT_EQ(touching.audit({{1.5, 1}, {1.5, 3.5}}).clearance, 0);
  const PathAuditor larger(world(kRoom), Footprint::disc(0.500000000000001));
  const PathAudit audit = larger.audit({{1.5, 1}, {1.5, 3.5}});
  EXPECT_FALSE(audit.valid);
  EXPECT_THAT(audit.reason, HasSubstr("comes nearer than 0.500000000000001 to the wall from (2, 0) to (2, 3), line 2"));
}

TEST(PathAudit, FindsWhereADiscMeetsAWall) {
  const PathAuditor auditor(world(kRoom), Footprint::disc(0.25));
  const PathAudit audit = auditor.audit({{0.5, 1}, {3, 1}});
  ASSERT_TRUE(audit.contact);
  EXPECT_NEAR(audit.contact->at.x, 1.75, 1e-12);
  EXPECT_NEAR(audit.contact->on.x, 2, 1e-12);
  const PathAudit corner = auditor.audit({{1, 3.1}, {3, 3.1}});  // past the wall's end
  ASSERT_TRUE(corner.contact);
  EXPECT_NEAR(corner.contact->at.x, 2 - std::sqrt(0.0625 - 0.01), 1e-9);
  EXPECT_EQ(corner.contact->on, (Point{2, 3}));
}

TEST(PathAudit, LetsADiscStickOutOfAnOpeningButNotLeaveThroughIt) {
  const PathAuditor auditor(world("boundary 0 0 4 4\n0 0 4 0\n0 0 0 4\n4 0 4 4\n"), Footprint::disc(0.5));
  EXPECT_TRUE(auditor.audit({{1, 1}, {2, 4}, {3, 1}}).valid);
  EXPECT_FALSE(auditor.audit({{1, 1}, {2, 4.1}, {3, 1}}).valid);
  EXPECT_FALSE(auditor.audit({{-1, 5}, {5, 9}}).valid);
}

TEST(PathAudit, RefusesWhatIsNoPath) {
  for (const Footprint& robot : {Footprint::point(), Footprint::disc(0.1)}) {
    const PathAuditor auditor(world(kRoom), robot);
    EXPECT_FALSE(auditor.audit({}).valid);
    EXPECT_FALSE(auditor.audit({{1, 1}, {NAN, 1}}).valid);
    EXPECT_FALSE(auditor.audit({{9, 9}}).valid);
    EXPECT_TRUE(auditor.audit({{1, 1}}).valid);
  }
}

TEST(PathAudit, KnowsTheShortestPathOfPointAndDisc) {
  const World room = world("boundary 0 0 4 4\n2 0 2 3\n");
  EXPECT_EQ(PathAuditor(room, Footprint::point()).shortest({0.5, 1}, {3.5, 1})->value, 5);
  const auto disc = PathAuditor(room, Footprint::disc(0.1)).shortest({0.5, 1}, {3.5, 1});
  ASSERT_TRUE(disc);
  EXPECT_GT(disc->enclosure.lo, 5);
  EXPECT_FALSE(PathAuditor(room, Footprint::point()).shortest({0.5, 1}, {9, 9}));
}

/// By all legs and all walls, in doubles: clear of the radius by more than they can err, or nearer.
double least_distance(const std::vector<Point>& points, const World& walls) {
  double least = HUGE_VAL;
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
    for (const Wall& wall : walls.walls())
      for (int k = 0; k <= 1000; ++k) {
        const double t = k / 1000.0;
        const Point p{points[i].x + t * (points[i + 1].x - points[i].x),
                      points[i].y + t * (points[i + 1].y - points[i].y)};
        const double ux = wall.b.x - wall.a.x, uy = wall.b.y - wall.a.y, u2 = ux * ux + uy * uy;
        const double s = u2 > 0 ? std::clamp((ux * (p.x - wall.a.x) + uy * (p.y - wall.a.y)) / u2, 0.0, 1.0) : 0;
        least = std::min(least, std::hypot(wall.a.x + s * ux - p.x, wall.a.y + s * uy - p.y));
      }
  return least;
}

RC_GTEST_PROP(PathAudit, AgreesWithSamplesOnRandomDiscs, ()) {
  WorldParts parts;
  parts.areas.push_back({{{{-100, -100}, {100, -100}, {100, 100}, {-100, 100}}, {}}, 0});
  const auto place = [] { return Point{*rc::gen::inRange(0, 21) / 2.0, *rc::gen::inRange(0, 21) / 2.0}; };
  for (int i = *rc::gen::inRange(1, 6); i > 0; --i) parts.walls.push_back({place(), place(), 0, i});
  const World random(parts);
  RC_PRE(!random.walls().empty());
  const std::vector<Point> points{place(), place(), place()};
  const double r = *rc::gen::inRange(1, 9) / 4.0, least = least_distance(points, random);
  const PathAudit audit = PathAuditor(random, Footprint::disc(r)).audit(points);
  if (least < r - 1e-9) RC_ASSERT(!audit.valid && audit.contact);
  if (least > r + 0.02) RC_ASSERT(audit.valid);
  if (audit.valid) RC_ASSERT(std::abs(audit.clearance + r - least) < 0.02);
  if (audit.contact) {
    const PathContact& c = *audit.contact;
    RC_ASSERT(std::hypot(c.at.x - c.on.x, c.at.y - c.on.y) <= r + 1e-9);
    RC_ASSERT(c.leg > 0 || least_distance({points[0], c.at}, random) >= r - 1e-6 || c.at == points[0]);
  }
}

}  // namespace
}  // namespace taut
