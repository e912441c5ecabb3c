// taut bug compare.
#pragma once

#include <taut/cli/command.h>

namespace taut::cli {

Command bug_compare_command(CommandLine& bug);

}  // namespace taut::cli
