// Where a path can enter a room.
#pragma once

#include <optional>
#include <vector>

#include <taut/geometry/free_space.h>
#include <taut/search/graph_search.h>

namespace taut::detail {

Point middle(const Box& box);

/// Throws InputError when an end is no place for the robot (require_free). The answer, a path of one point, when `from`
/// is in the goal room already: inside one of its boxes, or on the rim of one with a way into it open.
std::optional<GraphSearchResult> answer_at_start(const FreeSpace& space, Point from, const Goal& to);

/// The query whose answer is that path: one leg of length 0.
inline GraphQuery query_at_start(Point from) { return {{from, {}}, {{from, {}}}, {0}}; }

/// A side of one box of a room that no other box of it shares, and the middle of the box.
struct RoomSide {
  Segment side;  ///< axis-parallel, a < b
  Point inside;
  Box box;

  /// The point of the side that is nearest to p, if it is none of its ends nor p itself: a corner on the side is a
  /// RoomEntry, of which it is known from where the room can be entered. Exact.
  std::optional<Point> foot(Point p) const;
};

std::vector<RoomSide> room_sides(const std::vector<Box>& room);

/// A point of a side where a shortest path may enter, whatever comes before: an end of the side or a place where it
/// meets a constraint. Where constraints lead from there into the room, there is one for each way in beside them.
struct RoomEntry {
  Point point;
  Point inside;  ///< straight towards it leads the way in
};

/// A shortest path into a room enters at one of these, or at the foot of the perpendicular from its last bend: the
/// nearest point of what it sees of a side is a foot, an end of a free stretch of the side, or lies in line with a
/// corner, where it would rather bend. A constraint that meets a side in no pair of doubles gives a point rounded along
/// the side into the free space. O(sides * constraints).
std::vector<RoomEntry> room_entries(const FreeSpace& space, const std::vector<Box>& room);

}  // namespace taut::detail
