// Searches in the plane, without a clock: least numbers of moves, least costs.
#pragma once

#include <functional>
#include <limits>
#include <vector>

#include <taut/robots/pursuit/pursuit.h>

namespace taut::pursuit::detail {

inline constexpr int kUnreachable = std::numeric_limits<int>::max();
inline constexpr int kNoLimit = std::numeric_limits<int>::max();

/// The eight neighbours' offsets, straight ones first.
std::vector<std::ptrdiff_t> neighbour_steps(const ChaseMap& map);

/// Called now and then, and may throw.
using Watch = std::function<void()>;

/// For each cell the least number of moves from `from`; kUnreachable where there is no way or it takes more than
/// `limit` moves. O(cells).
std::vector<int> hops_from(const ChaseMap& map, CellIndex from, int limit, const Watch& watch = {});

/// For each cell the latest second (minus `now`) at which one can leave it and still be in time for one of the
/// meetings, moving over cells of cost >= lo; -1 where one cannot. O(cells + last second).
std::vector<int> latest_departures(const ChaseMap& map, const std::vector<Meeting>& meetings, int now, std::uint32_t lo,
                                   const Watch& watch = {});

/// A way of fewest moves from `from` to `to`, both ends included; empty when there is none.
std::vector<CellIndex> fewest_moves(const ChaseMap& map, CellIndex from, CellIndex to);

/// A way of least cost; empty when there is none. The cells that are left count. O(cells log cost).
std::vector<CellIndex> cheapest_way(const ChaseMap& map, CellIndex from, CellIndex to);

}  // namespace taut::pursuit::detail
