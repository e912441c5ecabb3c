// What the program says of itself.
#pragma once

#include <string>

#include <taut/io/results/words.h>
#include <taut/search/stopwatch.h>

namespace taut::cli {

/// The most memory this process ever had, `12.3 MB`.
std::string peak_memory_text();

/// How long something took, for lines: `0.004 s CPU`; where the clock on the wall says less, because threads shared it,
/// `1.20 s CPU, 0.61 s wall`.
std::string cpu_text(const Seconds& seconds);

}  // namespace taut::cli
