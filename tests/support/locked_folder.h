// Runs the program where it must not write.
#pragma once

#include <string>

#include "support/run_program.h"

namespace taut::test {

/// `taut ARGUMENTS` in the folder, by somebody who may read it but not write to it; root becomes nobody for that.
Outcome run_taut_where_nothing_can_be_written(const Folder& folder, const std::string& arguments);

}  // namespace taut::test
