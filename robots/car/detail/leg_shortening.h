// Longer legs instead of many short ones. Private.
#pragma once

#include <vector>

#include <taut/robots/car/car_space.h>

namespace taut::car::detail {

/// A drive between the same poses that is nowhere longer: runs of legs in one gear are replaced by one leg, or by two
/// that meet half way in one of the 64 headings nearest to the straight line, where these are drivable, free and
/// shorter. Not the shortest: a lattice's zigzag goes. O(legs) tries.
std::vector<Leg> shortened(const CarSpace& space, std::vector<Leg> legs);

}  // namespace taut::car::detail
