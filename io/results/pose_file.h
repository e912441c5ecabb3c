// Paths as poses, for ROS.
#pragma once

#include <span>
#include <string>

#include <taut/io/results/path_file.h>

namespace taut {

/// Each path as a message nav_msgs/msg/Path in YAML, as `ros2 topic echo` prints and `ros2 topic pub` takes it; `---`
/// between several. frame_id is `map`, z is 0. A pose a point: position as the shortest decimals that read back as the
/// same double, orientation a turn about z by the yaw: the column `heading` (degrees) where there is one, else the
/// direction in which the path goes on; at its end that in which it came. The column `second` becomes the stamp.
/// What is approximated says so in a `#` line in front. read_paths() reads it back.
std::string path_poses(std::span<const PathToWrite> paths);

}  // namespace taut
