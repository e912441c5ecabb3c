#include <taut/cli/solve/point_ends.h>

#include <taut/cli/world/snap_ends.h>
#include <taut/geometry/errors.h>
#include <taut/search/query_ends.h>
#include <taut/search/voronoi_search.h>

namespace taut::cli {

std::array<Point, 2> point_ends(const Input& input, const std::string& option) {
  require_ends(input);
  if (!input.world.goal().point)
    throw InputError(input.name, 0, "the goal is a room; " + option + " needs a goal point: --to X,Y");
  return {*input.world.start(), *input.world.goal().point};
}

std::vector<Point> free_goals(const FreeSpace& space, const Input& input) {
  require_free(space, *input.world.start(), "start");
  if (input.world.goal().point) require_free(space, *input.world.goal().point, "goal");
  std::vector<Point> goals = goal_points(space, input.world.goal());
  if (goals.empty()) throw InputError(input.name, 0, "the middles of its goal room are no free places; give --to X,Y");
  return goals;
}

}  // namespace taut::cli
