#include <taut/geometry/nested_areas.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <string>

#include <taut/geometry/mend_rings.h>

#include "support/geos_opinion.h"
#include "support/refusal.h"

namespace taut {
namespace {

Ring square(double x0, double y0, double x1, double y1) { return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}; }
Ring hole(double x0, double y0, double x1, double y1) { return {{x0, y0}, {x0, y1}, {x1, y1}, {x1, y0}}; }

// `1<0` for each: area 1 in area 0.
std::string nesting(const std::vector<Polygon>& polygons) {
  std::vector<Area> areas;
  for (const Polygon& polygon : polygons) areas.push_back({polygon});
  std::string text;
  for (const NestedArea& n : nested_areas(areas)) text += std::to_string(n.inner) + "<" + std::to_string(n.outer) + " ";
  return text;
}

TEST(NestedAreas, LieInsideAnother) {
  const Polygon room{square(0, 0, 9, 9), {}};
  EXPECT_EQ(nesting({room, {square(1, 1, 2, 2), {}}}), "1<0 ");
  EXPECT_EQ(nesting({{square(1, 1, 2, 2), {}}, room, {square(8, 8, 10, 10), {}}, {square(9, 0, 10, 9), {}}}), "0<1 ");
}

TEST(NestedAreas, MayTouchFromInside) {
  const Polygon room{square(0, 0, 9, 9), {}};
  EXPECT_EQ(nesting({room, {square(0, 1, 2, 2), {}}, {{{0, 4}, {9, 4}, {4, 9}}, {}}}), "1<0 2<0 ");
  EXPECT_EQ(nesting({{{{0, 0}, {9, 0}, {9, 9}, {5, 3}}, {}}, {{{5, 3}, {9, 0}, {9, 9}}, {}}}), "1<0 ");
  EXPECT_EQ(nesting({{{{0, 0}, {9, 0}, {9, 9}, {5, 3}}, {}}, {{{0, 0}, {9, 0}, {9, 9}}, {}}}), "0<1 ");
}

TEST(NestedAreas, DoNotFillHoles) {
  EXPECT_EQ(nesting({{square(0, 0, 9, 9), {hole(1, 1, 4, 4)}}, {square(1, 1, 4, 4), {}}}), "");
  EXPECT_EQ(nesting({{square(0, 0, 9, 9), {hole(1, 1, 4, 4)}}, {square(2, 2, 3, 3), {}}}), "");
  EXPECT_EQ(nesting({{square(0, 0, 9, 9), {hole(2, 2, 3, 3)}}, {square(1, 1, 4, 4), {}}}), "");
  EXPECT_EQ(nesting({{square(0, 0, 9, 9), {hole(2, 2, 3, 3)}}, {square(1, 1, 4, 4), {hole(2, 2, 3, 3)}}}), "1<0 ");
}

TEST(NestedAreas, AreEqualButForTheFirst) {
  const Polygon room{square(0, 0, 9, 9), {}};
  EXPECT_EQ(nesting({room, room, room}), "1<0 2<0 ");
  EXPECT_EQ(nesting({{square(0, 0, 9, 9), {hole(1, 1, 4, 4)}}, room}), "0<1 ");
}

TEST(NestedAreas, MeanWhatWasWritten) {
  const Polygon plan{{{0, 0.6}, {4, 3.1}, {0, 9}}, {}};
  EXPECT_EQ(nesting({plan, {{{0.8, 1.1}, {1, 3}, {0.5, 3}}, {}}}), "1<0 ") << "(0.8, 1.1) is on the side";
  EXPECT_EQ(nesting({plan, {{{0.8, 1.09999}, {1, 3}, {0.5, 3}}, {}}}), "");
}

// Polygons with holes that touch each other and themselves, of few places; none of a crossing, which would be rounded.
std::vector<Area> random_areas() {
  std::vector<Area> all;
  for (int n = *rc::gen::inRange(2, 6); n > 0; --n) {
    Ring ring;
    for (int i = *rc::gen::inRange(3, 7); i > 0; --i)
      ring.push_back({static_cast<double>(*rc::gen::inRange(0, 5)), static_cast<double>(*rc::gen::inRange(0, 5))});
    WorldParts one;
    one.areas = {{{square(0, 0, *rc::gen::inRange(3, 5), 4), {std::move(ring)}}}};
    if (*rc::gen::arbitrary<bool>()) one.areas = {{{one.areas[0].polygon.holes[0], {}}}};
    if (test::refusal_of([&] { mend_rings(one); }) != "accepted") continue;
    for (Area& area : one.areas) all.push_back(std::move(area));
  }
  return all;
}

RC_GTEST_PROP(NestedAreas, AreThoseThatGeosCallsCovered, ()) {
  const std::vector<Area> areas = random_areas();
  std::string expected, seen;
  for (std::size_t i = 0; i < areas.size(); ++i) {
    const auto in = [&](std::size_t a, std::size_t b) { return test::geos_covers(areas[b].polygon, areas[a].polygon); };
    for (std::size_t j = 0; j < areas.size(); ++j)
      if (i != j && in(i, j) && !(i < j && in(j, i))) {
        expected += std::to_string(i) + " ";
        break;
      }
  }
  for (const NestedArea& n : nested_areas(areas)) seen += std::to_string(n.inner) + " ";
  RC_TAG(seen.empty() ? "apart" : "nested");
  RC_ASSERT(seen == expected);
}

}  // namespace
}  // namespace taut
