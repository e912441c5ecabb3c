// Mazes for a car with roadblocks, from a seed.
#pragma once

#include <cstdint>

#include <taut/robots/roadblocks/roadblock_map.h>

namespace taut::roadblocks {

inline constexpr int kLeastLane = 2;
inline constexpr int kLeastRoom = 6;  ///< a side of a room

struct RoadblockMapRecipe {
  int width = 50;  ///< cells, kLeastMazeSide .. kLargestSide
  int height = 50;
  int roadblocks = 4;  ///< at most Course::kMostRoadblocks; fewer only where all lanes are full
  int samples = 10;    ///< drawn with the roadblocks' probabilities
  std::uint64_t seed = 1;
  int narrowest = kLeastLane;  ///< open cells across a lane, at least: kLeastLane .. kLeastRoom
};

inline constexpr int kLeastMazeSide = 24;

/// Rooms, one a slot of a raster of slots, joined by straight lanes: a spanning tree and most loops. Wall points on
/// both sides of a lane are 3 or 4 apart, of some 5 to 7, so that the car can hardly turn there (no lane is narrower
/// than `narrowest`: where walls are squares the car fills one of two cells and needs three); rooms are wide enough
/// to turn, some have pillars. Roadblocks stand in lanes, mostly as one cell, anywhere from mouth to mouth: many show
/// only from inside, and behind some there is but a dead end. Where they are more than the lanes, two
/// thirds of the lanes take them, several in series, those after the first open with 0.7 to 0.9; the last third only
/// when the others are full. A sample may leave no way to the goal. Start and goal lie in rooms at opposite corners.
/// Same recipe, same map, everywhere. Throws InputError when the recipe is out of range.
RoadblockMap generate_roadblock_map(const RoadblockMapRecipe& recipe);

}  // namespace taut::roadblocks
