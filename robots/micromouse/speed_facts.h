// Facts of speed runs, and where two of them part.
#pragma once

#include <cstddef>
#include <vector>

#include <taut/robots/micromouse/speed_run.h>

namespace taut::micromouse {

/// How many of its drives are turns, on the spot or smooth.
std::size_t turns_of(const SpeedRun& run);

/// m/s.
double top_speed_of(const SpeedRun& run, const SpeedModel& model);

/// `N`, `NE`, ...
const char* heading_name(Eighth heading);

/// Where two runs leave each other and meet again, or where their lists end if they do not: cells, and how many of each
/// lie between.
struct Parting {
  Cell from, to;
  std::size_t fastest = 0;
  std::size_t shortest = 0;
};
std::vector<Parting> partings(const std::vector<Cell>& fastest, const std::vector<Cell>& shortest);

}  // namespace taut::micromouse
