#include <gtest/gtest.h>

#include <taut/geometry/expects.h>
#include <taut/geometry/free_space.h>
#include <taut/geometry/grid_maze.h>
#include <taut/roadmaps/roadmap.h>

#include "support/small_world.h"

namespace taut {
namespace {

#ifdef TAUT_CHECKS
TEST(Preconditions, AreCheckedInThisBuild) {
  const FreeSpace space = test::SmallWorld{}.space();
  EXPECT_THROW(space.clearance({-1, -1}), PreconditionError);
  EXPECT_THROW(space.visibility_polygon({-1, -1}), PreconditionError);
  EXPECT_THROW(space.separation({-1, -1}, {5, 5}), PreconditionError);
  EXPECT_THROW(GridMaze(2, 2, true).wall({2, 0}, Side::north), PreconditionError);
  const std::vector<std::pair<Roadmap::Vertex, Roadmap::Vertex>> beyond{{0, 7}};
  EXPECT_THROW(Roadmap({Point{0, 0}}, beyond), PreconditionError);
}
#endif

}  // namespace
}  // namespace taut
