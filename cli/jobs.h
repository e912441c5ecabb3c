// The option of subcommands that share their work among threads.
#pragma once

#include <taut/cli/command_line.h>
#include <taut/cli/stop.h>

namespace taut::cli {

/// `--jobs N`; 0 is a thread a core. `limits.jobs` keeps its value when the option is not given.
void add_jobs_option(CommandLine& app, Limits& limits);

}  // namespace taut::cli
