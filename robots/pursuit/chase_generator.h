// Cost maps with a moving target from a seed.
#pragma once

#include <cstdint>

#include <taut/robots/pursuit/chase_map.h>

namespace taut::pursuit {

/// Where the walls are.
enum class ChaseGround {
  town,      ///< rectangular buildings with a door or two, some of them solid
  building,  ///< one building: corridors, rooms, doors
};

/// What to make. Sizes in cells.
struct ChaseRecipe {
  int x_size = 200;
  int y_size = 200;
  int seconds = 400;  ///< trajectory entries
  /// Smooth hills of cost 1..100 over a town, costs that rise towards walls in a building; else every free cell costs 1
  bool costly = false;
  double buildings = 0.2;  ///< share of the town, roughly, under buildings: 0 .. 0.6
  std::uint64_t seed = 1;
  ChaseGround ground = ChaseGround::town;
  /// In a costly building a cell costs 1 + 10 for each cell of wall no farther than this in x and y: 1 .. 100
  int inflation = 12;
};

/// The target walks on ways of fewest moves from one random place to the next. All free cells are connected with the
/// robot's start, so the target can be met, given the seconds. Same recipe, same map, everywhere. Throws InputError
/// unless 3 <= sizes <= ChaseMap::kLongestSide, seconds >= 1 and the rest is in range. O(cells) a place.
ChaseMap generate_chase_map(const ChaseRecipe& recipe);

}  // namespace taut::pursuit
