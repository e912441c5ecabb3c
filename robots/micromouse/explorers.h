// The robots that come with the library, by name.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include <taut/robots/micromouse/robot.h>

namespace taut::micromouse {

/// How a robot explores in run 1. All of them race in run 2 along a route with the fewest steps on what they know, and
/// plan anew when run 2 itself learns something.
///
///  random         an open direction and 1 to 3 cells, drawn; reset at the goal
///  wall_follower  keeps the wall to its left, cell by cell; reset at the goal; may circle for ever
///  depth_first    into a cell not yet visited, the one nearer to the goal first, else back; reset at the goal
///  breadth_first  to the nearest unvisited cell, until none is left or the steps get short
///  flood_fill     along the fewest steps to the goal with unknown walls open; reset at the goal
///  a_star         the same by the fewest cells, from where it stands; reset at the goal
///  plain_prove    flood_fill, then to the nearest cell beside an unknown wall of the shortest optimistic route, until
///                 that route is wholly known
///  prove          where the look most likely cuts a shorter plan, until the optimum is proven (lo = hi)
///  score          the same, until knowing more no longer pays its thirtieths
enum class Explorer {
  random,
  wall_follower,
  depth_first,
  breadth_first,
  flood_fill,
  a_star,
  plain_prove,
  prove,
  score
};

const std::vector<Explorer>& all_explorers();
/// `random`, `wall`, `dfs`, `bfs`, `flood`, `astar`, `plain-prove`, `prove`, `score`.
std::string_view name(Explorer explorer);
/// Nothing for any other word.
std::optional<Explorer> explorer_named(std::string_view word);

/// Does it draw? The others do the same for any seed.
bool is_random(Explorer explorer);

/// A robot for this task. `random` draws its way, `prove` and `score` the mazes that they compare.
std::unique_ptr<Robot> make_explorer(Explorer explorer, const Task& task, std::uint64_t seed = 1);

}  // namespace taut::micromouse
