// Pictures of a meeting with a moving target.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <taut/geometry/free_space.h>
#include <taut/io/results/end_moves.h>
#include <taut/robots/pursuit/interception.h>

namespace taut::pursuit {

/// What stands around it.
struct InterceptionPicture {
  std::string title{};
  std::vector<std::string> facts{};
  std::vector<EndMove> end_moves{};
  bool moves = false;  ///< robot and target run, by one clock; the last twentieth of the time they stand still
};

/// The free space with the target's way (dashed), the robot's path to the meeting, and marks with the same round times
/// on both. Same input, same bytes.
std::string interception_svg(const FreeSpace& space, const Interception& question,
                             const std::optional<MeetingPlace>& meeting, const InterceptionPicture& what);

}  // namespace taut::pursuit
