#include <taut/geometry/mend_rings.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <taut/geometry/predicates.h>

#include "support/geos_opinion.h"
#include "support/refusal.h"

namespace taut {
namespace {

Ring square(double x0, double y0, double x1, double y1) { return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}; }

double area(const std::vector<Area>& areas) {
  double twice = 0;
  for (const Area& a : areas) {
    twice += ring_area(a.polygon.outer);
    for (const Ring& hole : a.polygon.holes) twice += ring_area(hole);
  }
  return twice / 2;
}

// Points of a small lattice, of integers, as GEOS takes doubles for what they are: rings touch themselves, fold back,
// cross and repeat.
Ring random_ring(int most) {
  Ring ring;
  for (int i = *rc::gen::inRange(3, most); i > 0; --i)
    ring.push_back({static_cast<double>(*rc::gen::inRange(0, 9)), static_cast<double>(*rc::gen::inRange(0, 9))});
  return ring;
}

Polygon random_polygon() {
  Polygon polygon{random_ring(14), {}};
  if (*rc::gen::arbitrary<bool>()) polygon.outer = square(0, 0, 7, 8);
  for (int holes = *rc::gen::inRange(0, 4); holes > 0; --holes) polygon.holes.push_back(random_ring(7));
  return polygon;
}

TEST(MendRings, SaysEachKindOnce) {
  WorldParts parts;
  parts.source = "plan";
  for (int line : {3, 4, 5}) parts.areas.push_back({{{{0, 0}, {4, 0}, {4, 4}, {4, 4}, {4, 8}, {4, 4}}, {}}, line});
  EXPECT_EQ(
      mend_rings(parts),
      (std::vector<std::string>{
          "line 3: ring repeats the point (4, 4): taken once; 2 more like it",
          "line 3: ring has a spike at (4, 8): side (4, 8)-(4, 4) folds back over side (4, 4)-(4, 8): what has no "
          "width is left out; 2 more like it",
          "line 3: ring touches itself at (4, 4): side (4, 0)-(4, 4) and side (4, 8)-(4, 4): taken as its inside; "
          "2 more like it"}));
  EXPECT_EQ(area(parts.areas), 24);
}

TEST(MendRings, NamesThePlaceOfWhatHasTwoMeanings) {
  WorldParts parts;
  parts.source = "plan";
  parts.areas = {{{square(0, 0, 9, 9), {}}, 1}, {{{{0, 0}, {4, 4}, {4, 0}, {0, 4}}, {}}, 2}};
  try {
    mend_rings(parts);
    FAIL();
  } catch (const AmbiguousRing& ring) {
    EXPECT_STREQ(ring.what(), "plan:2: ring crosses itself: side (0, 0)-(4, 4) and side (4, 0)-(0, 4)");
    EXPECT_EQ(ring.even_odd(), "taken by the even-odd rule");
  }
}

TEST(MendRings, MendsSlitsThatAreThinnerThanDoublesTell) {
  // Their sides cross, an ulp apart at both ends.
  const double up = 1.0000000000000002;
  WorldParts parts;
  parts.areas = {{{{{0, 1}, {1, up}, {1, 3}, {-1, 3}, {-1, -1}, {1, -1}, {1, 1}, {0, up}}, {}}, 7}};
  EXPECT_EQ(test::refusal_of([&] { mend_rings(parts, Crossings::even_odd); }), "accepted");
  EXPECT_NEAR(area(parts.areas), 8, 1e-12);
}

bool runs_along_itself(const std::vector<std::string>& remarks) {
  return std::any_of(remarks.begin(), remarks.end(), [](const std::string& remark) {
    return remark.find("overlaps") != std::string::npos || remark.find("spike") != std::string::npos ||
           remark.find("touches") != std::string::npos;
  });
}

RC_GTEST_PROP(MendRings, KeepsTheAreaThatGeosMakesOfRings, (const bool repair)) {
  const Polygon polygon = random_polygon();
  WorldParts parts;
  parts.areas = {{polygon}, {{square(20, 20, 21, 21), {}}}};
  std::vector<std::string> remarks;
  try {
    remarks = mend_rings(parts, repair ? Crossings::even_odd : Crossings::refuse);
  } catch (const AmbiguousRing&) {
    RC_ASSERT(!repair);
    RC_TAG("refused");
    return;
  }
  RC_TAG(repair ? "repaired" : "accepted");
  const double seen = area(parts.areas) - 1;
  RC_ASSERT(std::abs(seen - test::geos_area(polygon)) < 1e-9);
  // Make-valid fills what a stretch that is there twice closes off; that has no inside.
  if (!runs_along_itself(remarks)) RC_ASSERT(std::abs(seen - test::geos_valid_area(polygon)) < 1e-9);
}

RC_GTEST_PROP(EvenOddAreas, AreThoseOfGeos, ()) {
  std::vector<Area> areas;
  std::vector<Polygon> polygons;
  for (int n = *rc::gen::inRange(1, 4); n > 0; --n) polygons.push_back(random_polygon());
  for (const Polygon& polygon : polygons) areas.push_back({polygon});
  RC_ASSERT(std::abs(area(even_odd_areas(areas)) - test::geos_even_odd_area(polygons)) < 1e-9);
}

TEST(EvenOddAreas, AreRoomsWithHolesAndIslands) {
  const std::vector<Area> plan =
      even_odd_areas({{{square(0, 0, 9, 9), {}}, 4}, {{square(2, 2, 7, 7), {}}, 5}, {{square(3, 3, 4, 4), {}}, 6}});
  ASSERT_EQ(plan.size(), 2U);
  EXPECT_EQ(plan[0].polygon.holes.size(), 1U);
  EXPECT_EQ(area(plan), 81 - 25 + 1);
  EXPECT_TRUE(even_odd_areas({}).empty());
}

}  // namespace
}  // namespace taut
