// A goal room and the world around it. Private.
#pragma once

#include <string>
#include <vector>

#include <taut/geometry/point.h>

namespace taut::detail {

bool is_within(const Box& inner, const Box& outer);

/// Cuts off what reaches beyond `world` and drops boxes of which nothing with an area is left; those within stay as
/// they are. Throws InputError when nothing at all is left of a room.
void cut_room(std::vector<Box>& room, const Box& world, const std::string& source);

}  // namespace taut::detail
