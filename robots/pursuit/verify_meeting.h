// A second look at a meeting.
#pragma once

#include <string>

#include <taut/geometry/free_space.h>
#include <taut/robots/pursuit/interception.h>

namespace taut::pursuit {

/// What is wrong with a meeting, empty when nothing is: the path up to its last place, which is rounded, has to pass
/// the check that shares nothing with the search (verify), and all of it has to be as short as the robot can go until
/// then. That nobody meets the target earlier is not looked at.
std::string meeting_fault(const FreeSpace& space, const Interception& question, const MeetingPlace& meeting);

}  // namespace taut::pursuit
