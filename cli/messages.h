// What is said on stderr, and in what words.
#pragma once

#include <string>
#include <string_view>

#include <taut/io/results/words.h>
#include <taut/search/stopwatch.h>

namespace taut::cli {

/// Writes `taut: message` and a line end to stderr in one piece, "taut:" in red on a terminal unless NO_COLOR is set.
/// Control characters (of file names) become `?`, the middle of a word of more than 260 bytes `...`. Allocates nothing.
void complain(std::string_view message) noexcept;

/// The text with `?` in the place of control characters, as file names may hold them: a terminal obeys those. Line ends
/// and tabs stay.
std::string printable(std::string_view text);

/// Writes a line of information to stderr, printable.
void note(std::string_view line) noexcept;

/// Is stderr a terminal that can show progress?
bool is_progress_shown() noexcept;

/// Shows a line on such a terminal in place of the one before, without a line end; complain(), note() and print() wipe
/// it off first. Elsewhere it is written as any other. Left out while another thread writes.
void progress(std::string_view line) noexcept;
void end_progress() noexcept;

/// The most memory this process ever had, `12.3 MB`.
std::string peak_memory_text();

/// How long something took, for lines: `0.004 s CPU`; where the clock on the wall says less, because threads shared it,
/// `1.20 s CPU, 0.61 s wall`.
std::string cpu_text(const Seconds& seconds);

}  // namespace taut::cli
