// Rectangles of cells that come and go, and which of them holds which cell. Private.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include <taut/geometry/cell_plan.h>

namespace taut::detail {

/// The rooms of a plan whose sides open and close: stretches of free cells in a row with nothing between them, those
/// one above the other put together as long as they agree. The plan outlives it.
class CellRoomMap {
 public:
  struct Room {
    std::uint32_t x0, x1, y0, y1;   ///< lines
    std::uint32_t polygon = kNone;  ///< whose corners are these
  };

  explicit CellRoomMap(const CellPlan& plan);

  std::span<const Room> rooms() const { return rooms_; }  ///< those that are gone have x0 == x1
  Room& room(std::uint32_t r) { return rooms_[r]; }
  const Room& room(std::uint32_t r) const { return rooms_[r]; }
  /// kNone when the cell is not free. O(log n).
  std::uint32_t at(CellPlan::Cell cell) const;

  /// Calls visit(other, from, to) for each portal on the lower or upper side of a room, from left to right.
  template <class Visit>
  void each_portal(std::uint32_t r, bool above, Visit&& visit) const {
    const Room& room = rooms_[r];
    const std::uint32_t line = above ? room.y1 : room.y0;
    if (line == 0 || line == plan_.rows()) return;
    const std::vector<Run>& row = rows_[above ? line : line - 1];
    for (auto run = first_beyond(row, room.x0); run != row.end() && run->from < room.x1; ++run) {
      std::uint32_t from = std::max(run->from, room.x0);
      const std::uint32_t end = std::min(run->to, room.x1);
      while ((from = next_bit(plan_.open_above(line - 1), from, end, true)) < end) {
        const std::uint32_t to = next_bit(plan_.open_above(line - 1), from, end, false);
        visit(run->room, from, to);
        from = to;
      }
    }
  }

  /// A line was made between lines i and i + 1: all that is beyond is one further.
  void make_x_line(std::uint32_t i);
  void make_y_line(std::uint32_t i);

  /// Makes these rooms anew, and puts them together as sides are now; `fresh` are those instead of them. Precondition:
  /// where a side to the left or right of one has opened, the room beyond it is among them.
  void make_anew(std::span<const std::uint32_t> old, std::vector<std::uint32_t>& fresh);

 private:
  struct Run {
    std::uint32_t from, to, room;
  };

  /// The first one that does not end before a column.
  static std::vector<Run>::const_iterator first_beyond(const std::vector<Run>& row, std::uint32_t column) {
    return std::upper_bound(row.begin(), row.end(), column, [](std::uint32_t c, const Run& run) { return c < run.to; });
  }
  /// The first column from `from` on whose bit is as wanted, or `end`.
  static std::uint32_t next_bit(std::span<const std::uint64_t> bits, std::uint32_t from, std::uint32_t end,
                                bool is_set);
  void make_row_anew(std::uint32_t row, std::vector<std::uint32_t>& fresh);
  std::uint32_t new_room(const Room& room);

  const CellPlan& plan_;
  std::vector<Room> rooms_;
  std::vector<std::uint32_t> unused_;
  std::vector<std::vector<Run>> rows_;  // from left to right
  std::vector<bool> is_old_, is_fresh_;
  std::vector<Run> row_;
};

}  // namespace taut::detail
