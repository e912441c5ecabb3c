// Progress of long work, shown on stderr.
#pragma once

#include <taut/cli/options.h>
#include <taut/cli/stop.h>
#include <taut/geometry/progress.h>

namespace taut::cli {

/// For the library, and for loops of the program's own: what is told there the watching thread shows, one line that is
/// written again and again on a terminal, a line every 10 seconds elsewhere (Meter). Empty with --quiet, and where the
/// environment says TAUT_PROGRESS=0. What is told is remembered until something else is, all of it is done, or
/// progress_over().
TellProgress shown_progress(const CommonOptions& options);

/// For start_watch(): shows it.
Beat progress_beat(const CommonOptions& options);

/// Nothing is going on any more: the line is wiped off.
void progress_over() noexcept;

}  // namespace taut::cli
