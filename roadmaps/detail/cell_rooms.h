// Rectangles of cells, and which of them lie between two ends. Private.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <taut/geometry/cell_plan.h>
#include <taut/roadmaps/cell_navmesh.h>

namespace taut::detail {

/// Cells between lines x0 and x1, y0 and y1, with nothing between them, closed at the left and right.
struct CellRoom {
  std::uint32_t x0, x1, y0, y1;
  std::uint32_t first_down = 0, end_down = 0;  ///< the portals on the lower side, from left to right
  std::uint32_t first_up = 0, end_up = 0;      ///< on the upper side
  std::uint32_t polygon = kNone;               ///< in their order; kNone: a dead end
};

/// Where a room is open to the one above it: a whole stretch, from column line to column line.
struct CellPortal {
  std::uint32_t below, above;
  std::uint32_t from, to;
};

struct CellRooms {
  std::vector<CellRoom> rooms;
  std::vector<CellPortal> portals;      ///< by line, then from left to right
  std::vector<CellPolygons::Run> runs;  ///< `polygon` is the room
  std::vector<std::uint32_t> first_of_row;
  std::uint32_t kept = 0;  ///< rooms that have a polygon
};

/// All rooms of a plan, from below to above, then from left to right. O(cells / 64 + runs).
CellRooms cell_rooms(const CellPlan& plan);

/// Numbers those that are no dead ends: as long as one has a single portal and meets no end, it is left out. O(rooms).
void keep_between(CellRooms& rooms, const CellPlan& plan, std::span<const Box> ends);

}  // namespace taut::detail
