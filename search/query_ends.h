// Is a query's start or goal a place where the robot can be?
#pragma once

#include <string_view>

#include <taut/geometry/free_space.h>

namespace taut {

/// Throws InputError when p is no place for the robot, naming what is there: `start (3, 4) lies outside the world`, or
/// `goal (0.5, 1.5) lies inside the wall (0, 1) to (2, 1), line 7`. `role` is the word the message starts with.
void require_free(const FreeSpace& space, Point p, std::string_view role);

}  // namespace taut
