// Paths as poses, as ROS writes them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <taut/io/worlds/read_path.h>

namespace taut::detail {

/// Is it YAML with `poses`?
bool holds_poses(std::string_view bytes);

/// See read_paths().
std::vector<ClaimedPath> read_paths_poses(std::string_view bytes, const std::string& source);

}  // namespace taut::detail
