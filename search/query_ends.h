// Is a query's start or goal a place where the robot can be?
#pragma once

#include <string>
#include <string_view>

#include <taut/geometry/nearest_free.h>
#include <taut/roadmaps/disc_places.h>

namespace taut {

/// Throws InputError when p is no place for the robot, with blocked_text. `role` is the word the message starts with.
void require_free(const FreeSpace& space, Point p, std::string_view role);
void require_free(const DiscPlaces& places, Point p, std::string_view role);

/// Of a p that is no place for the robot: how far it is from one, what stands there (nearest_obstacle) and where the
/// nearest place is: `start (3, 14) lies 4 outside the world; nearest free point (3, 10)`, or `goal (0.5, 1.03) lies
/// 0.02 inside the wall from (0, 1) to (2, 1), line 7; nearest free point (0.5, 1.05)`.
std::string blocked_text(const World& world, Point p, std::string_view role, const std::optional<FreePlace>& nearest);

}  // namespace taut
