// Noding of axis-parallel edges by sorting. Private.
#pragma once

#include <vector>

#include <taut/geometry/detail/noding.h>

namespace taut::detail {

inline bool is_axis_parallel(const Edge& e) { return e.a.x == e.b.x || e.a.y == e.b.y; }

/// What node() gives for axis-parallel edges. Coordinates become ranks, by sorting; a line that sweeps the horizontal
/// runs from below to above knows the vertical ones that it crosses, as bits, and so finds all contacts; on each line
/// what lies between two of them is added up. Nothing is rounded: a crossing has coordinates of the edges. O(n + k) for
/// k contacts and pieces, and a 64th of the vertical lines that a horizontal run passes over.
Noded node_axis_parallel(const std::vector<Edge>& edges);

}  // namespace taut::detail
