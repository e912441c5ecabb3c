// Rings that nearly touch themselves: joined first, they have one meaning.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include <taut/geometry/errors.h>
#include <taut/geometry/free_space.h>
#include <taut/geometry/text.h>
#include <taut/io/worlds/read_world.h>

#include "support/turned.h"

namespace taut::test {
namespace {

std::string wkt(const std::vector<Ring>& rings, const Turn& turn, Point offset) {
  std::string text = "POLYGON (";
  for (const Ring& ring : rings) {
    text += text.back() == '(' ? "(" : ", (";
    for (std::size_t i = 0; i <= ring.size(); ++i) {
      const Point p = turn(ring[i % ring.size()]);
      append(text += i == 0 ? "" : ", ", p.x + offset.x);
      append(text += ' ', p.y + offset.y);
    }
    text += ')';
  }
  return text + ")";
}

double area(const FreeSpace& space) {
  double twice = 0;
  const auto add = [&](const Ring& ring) {
    const Point o = ring[0];
    for (std::size_t i = 1; i + 1 < ring.size(); ++i)
      twice += (ring[i].x - o.x) * (ring[i + 1].y - o.y) - (ring[i + 1].x - o.x) * (ring[i].y - o.y);
  };
  for (const Polygon& polygon : space.polygons()) {
    add(polygon.outer);
    for (const Ring& hole : polygon.holes) add(hole);
  }
  return twice / 2;
}

struct Plan {
  std::vector<Ring> rings;
  double area;
  std::size_t components;
};
const std::vector<Plan> kTouching{
    {{{{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}}}, 8, 2},                                // a corner on a side
    {{{{0, 0}, {10, 0}, {10, 6}, {6, 6}, {6, 0}, {4, 0}, {4, 6}, {0, 6}}}, 48, 2},     // sides on a side
    {{{{0, 0}, {9, 0}, {9, 6}, {0, 6}}, {{3, 0}, {5, 2}, {2, 3}}}, 50, 1},             // a hole's corner
    {{{{0, 0}, {10, 3}, {7, 13}, {-3, 10}}, {{2, 0.6}, {6, 1.8}, {3, 5}}}, 100.8, 1},  // a hole's side
    {{{{0, 0}, {9, 0}, {9, 6}, {0, 6}}, {{2, 1}, {4, 1}, {4, 3}, {2, 3}}, {{4, 2}, {6, 2}, {6, 5}, {4, 5}}}, 44, 1},
};

TEST(ReadShapes, RingsThatTouchMeanTheSameWhenTurned) {
  for (const Plan& plan : kTouching)
    for (const Point offset : {Point{0, 0}, Point{5e5, 5.4e6}})
      for (int degrees = 0; degrees < 90; degrees += 7) {
        const std::string text = wkt(plan.rings, Turn(degrees), offset);
        SCOPED_TRACE(text);
        ReadNotes notes;
        const FreeSpace space(read_world(text, {}, &notes));
        EXPECT_NEAR(area(space), plan.area, 1e-6);
        EXPECT_EQ(space.component_count(), plan.components);
        EXPECT_LE(notes.snap.displacement, notes.snap.tolerance);
      }
}

TEST(ReadShapes, RingsAreLeftAsTheyAreWhereNothingIsToBeJoined) {
  ReadOptions options;
  options.snap.what = Snap::What::nothing;
  int refused = 0;
  for (int degrees = 1; degrees < 90; ++degrees) try {
      read_world(wkt(kTouching[1].rings, Turn(degrees), {0, 0}), options);
    } catch (const InputError&) {
      ++refused;
    }
  EXPECT_GT(refused, 0);
}

TEST(ReadShapes, ACrossingNoLargerThanWhatIsJoinedIsNone) {
  constexpr const char* kNeck = "POLYGON ((0 0, 5 2.0003, 10 0, 10 4, 5 1.9999, 0 4, 0 0))";
  EXPECT_THROW(read_world(kNeck), InputError);
  ReadOptions options;
  options.snap = {Snap::What::within, 0.001};
  ReadNotes notes;
  EXPECT_EQ(FreeSpace(read_world(kNeck, options, &notes)).component_count(), 2U);
  EXPECT_EQ(notes.snap.joined, 1U);
  EXPECT_EQ(notes.remarks.size(), 2U);
  options.snap.tolerance = 0.0001;
  EXPECT_THROW(read_world(kNeck, options), InputError);
}

}  // namespace
}  // namespace taut::test
