// What is said on stderr.
#pragma once

#include <string>
#include <string_view>

namespace taut::cli {

/// Writes `taut: message` and a line end to stderr in one piece, "taut:" in red on a terminal unless NO_COLOR is set.
/// Control characters (of file names) become `?`. Allocates nothing.
void complain(std::string_view message) noexcept;

/// The text with `?` in the place of control characters, as file names may hold them: a terminal obeys those. Line ends
/// and tabs stay.
std::string printable(std::string_view text);

/// Writes a line of information to stderr, printable.
void note(std::string_view line) noexcept;

/// Is stderr a terminal that can show progress?
bool is_progress_shown() noexcept;

/// Shows a line on such a terminal in place of the one before, without a line end; complain() and note() wipe it off
/// first.
void progress(std::string_view line) noexcept;
void end_progress() noexcept;

}  // namespace taut::cli
