// What saved files say of their world.
#pragma once

#include <string>

#include <taut/geometry/free_space.h>

namespace taut::detail {

/// `point`, `disc 0.2`, `square R`, `polygon x y x y ...`
std::string robot_text(const Footprint& robot);

/// With `?` for line ends and the like.
std::string one_line(std::string text);

/// Throws InputError, in one line: the file `name` was built of another world than the space's (naming both), or for
/// another robot. `source`, `theirs` and `built_for` are what it says of its own.
void require_same_world(const std::string& name, const FreeSpace& space, const std::string& source,
                        const std::string& theirs, const std::string& built_for);

}  // namespace taut::detail
