// What a World fills in when its parts leave it out.
#pragma once

#include <taut/geometry/world.h>

namespace taut::detail {

/// Would World have the same areas and boundary, had it been given none?
bool area_is_implied(const World& world);

/// Are start and goal the midpoints of the world's two openings, as World sets them?
bool ends_are_implied(const World& world);

}  // namespace taut::detail
