// Cost maps with a moving target from a seed.
#pragma once

#include <cstdint>

#include <taut/robots/pursuit/chase_map.h>

namespace taut::pursuit {

struct ChaseRecipe {
  int x_size = 200;
  int y_size = 200;
  int seconds = 400;       ///< trajectory entries
  bool costly = false;     ///< cost fields: smooth hills of cost 1..100 over the floor; else every free cell costs 1
  double buildings = 0.2;  ///< share of the map, roughly, under buildings: 0 .. 0.6
  std::uint64_t seed = 1;
};

/// A town: buildings are rectangular walls with a door or two, some of them solid; the target walks on ways of fewest moves from one random place to
/// the next. All free cells are connected with the robot's start, so the target can be met, given the seconds. Same recipe, same map, everywhere.
/// Throws InputError unless 3 <= sizes <= ChaseMap::kLongestSide, seconds >= 1 and the share is in range. O(cells) a place.
ChaseMap generate_chase_map(const ChaseRecipe& recipe);

}  // namespace taut::pursuit
