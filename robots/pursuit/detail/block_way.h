// A first way on a large map, quickly.
#pragma once

#include <optional>
#include <vector>

#include <taut/robots/pursuit/pursuit.h>

namespace taut::pursuit::detail {

/// A way without waiting and the seconds after which it is at its end, where a meeting is.
struct TimedWay {
  std::vector<CellIndex> cells;
  int seconds = 0;
};

/// The way that rough_plan finds on a map of blocks, `side` cells wide and high: those that are free all over, at their
/// mean cost. It is a legal way on the map itself, from the middle of one block to that of the next. Nothing when there
/// is none, which says nothing about other ways. Of meetings only those in such blocks count. O(cells) and a plan for a
/// map of 1 / side^2 of them. Precondition: side is odd, at least 3.
std::optional<TimedWay> way_over_blocks(const Chase& chase, int side);

}  // namespace taut::pursuit::detail
