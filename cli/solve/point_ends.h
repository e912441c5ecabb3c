// The ends of a query in the plane, as searches that have no rooms want them.
#pragma once

#include <array>
#include <string>
#include <vector>

#include <taut/cli/input.h>
#include <taut/geometry/free_space.h>

namespace taut::cli {

/// Start and goal, both points. `option` wants them so. Throws InputError where one is missing or the goal is a room.
std::array<Point, 2> point_ends(const Input& input, const std::string& option);

/// The goal, or the middles of its room's boxes that are free. Throws InputError where an end is not free or there is
/// no such middle. Precondition: there are ends (require_ends).
std::vector<Point> free_goals(const FreeSpace& space, const Input& input);

}  // namespace taut::cli
