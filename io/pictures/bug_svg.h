// Pictures of a bug's journey.
#pragma once

#include <string>
#include <vector>

#include <taut/io/results/end_moves.h>
#include <taut/robots/bug/bug.h>

namespace taut::bug {

/// Of which journey, and what stands below.
struct BugPicture {
  std::string title{};
  std::vector<std::string> facts{};
  Point start;
  Point goal;
  Algorithm algorithm = Algorithm::bug2;
  std::vector<EndMove> end_moves{};
  bool moves = false;  ///< the robot runs along its path, what it sees follows it
};

/// The free space with the path, the m-line of those that keep one, what was in sight where views were recorded, and
/// the contacts: H1, H2, ... hit points, M1, ... where a contour begins to be followed, L1, ... leave points; those of
/// one place share a label, which stands beside the path. Same input, same bytes.
std::string bug_svg(const FreeSpace& space, const Journey& journey, const BugPicture& picture);

}  // namespace taut::bug
