// What a file says of its path's length.
#pragma once

#include <string>

#include <taut/geometry/length.h>
#include <taut/io/worlds/read_path.h>

namespace taut::cli {

/// Why the claim is wrong; empty where it is right or there is none. Right is what adding up the legs in doubles can
/// give, in whatever order: (n + 2) / 2^53 of the length for n points. Of curves that the file holds 1e-9 of it; of
/// legs that stand for curves anything above, too.
std::string false_claim(const ClaimedPath& claimed, const Length& legs);

}  // namespace taut::cli
