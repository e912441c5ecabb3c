#include <gtest/gtest.h>

#include <taut/geometry/free_space.h>
#include <taut/geometry/world.h>

namespace taut {
namespace {

// A corner of the fourth polygon lay on the long side of the second until that was cut at a crossing and rounded. What
// all five enclose, 0.36 large, then has a triangle of 10^-13 beside that side, which lies within the second as written.
TEST(PolygonTriangles, ANarrowOneDoesNotDecideWhatAWholeRegionIs) {
  WorldParts parts;
  for (const Ring& ring : {
           Ring{{-13, -10}, {-11, -11}, {-10.4791666666667, -8.3958333333333}},
           Ring{{-10.4791666666667, -8.3958333333333}, {-2, -3}, {-10, -6}},
           Ring{{-10, -4}, {-6.4, -5.8}, {-7, -5}, {-4.8571428571429, -6.4285714285714}, {-6, -3}, {-3, -2}},
           Ring{{-6.4, -5.8}, {-4, -9}, {-4.8, -6.6}},
           Ring{{-4.8571428571429, -6.4285714285714}, {-4.8, -6.6}, {-4, -7}},
       })
    parts.areas.push_back({{ring, {}}, 0});
  const FreeSpace space((World(parts)));
  EXPECT_EQ(space.component_count(), 4U);
}

}  // namespace
}  // namespace taut
