// How the program ends.
#pragma once

namespace taut::cli {

enum ExitCode : int {
  kFound = 0,     ///< also: done, valid
  kNone = 1,      ///< there is no path, proven; the path to check is not valid
  kUsage = 2,     ///< the command line makes no sense
  kInput = 3,     ///< the input is wrong, start or goal in a wall included; an output file cannot be made
  kStopped = 4,   ///< a limit or an interrupt; an output file could not be written to its end
  kInternal = 70  ///< a defect of the program, such as an answer that its own check refuses (EX_SOFTWARE)
};

}  // namespace taut::cli
