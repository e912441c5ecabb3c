// What is said on stderr.
#pragma once

#include <string_view>

namespace taut::cli {

/// Writes `taut: message` and a line end to stderr in one piece, "taut:" in red on a terminal unless NO_COLOR is set.
/// Control characters (of file names) become `?`. Allocates nothing.
void complain(std::string_view message) noexcept;

/// Writes a line of information to stderr.
void note(std::string_view line) noexcept;

}  // namespace taut::cli
