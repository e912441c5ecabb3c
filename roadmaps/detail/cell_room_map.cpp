#include <taut/roadmaps/detail/cell_room_map.h>

#include <bit>

#include <taut/roadmaps/detail/cell_rooms.h>

namespace taut::detail {

CellRoomMap::CellRoomMap(const CellPlan& plan) : plan_(plan), rows_(plan.rows()) {
  const CellRooms made = cell_rooms(plan);
  for (const CellRoom& room : made.rooms) rooms_.push_back({room.x0, room.x1, room.y0, room.y1});
  for (std::size_t row = 0; row < rows_.size(); ++row)
    for (std::uint32_t i = made.first_of_row[row]; i < made.first_of_row[row + 1]; ++i)
      rows_[row].push_back({made.runs[i].from, made.runs[i].to, made.runs[i].polygon});
}

std::uint32_t CellRoomMap::at(CellPlan::Cell cell) const {
  if (cell.column < 0 || cell.row < 0 || static_cast<std::size_t>(cell.row) >= rows_.size()) return kNone;
  const std::vector<Run>& row = rows_[static_cast<std::size_t>(cell.row)];
  const auto run = first_beyond(row, static_cast<std::uint32_t>(cell.column));
  return run != row.end() && run->from <= static_cast<std::uint32_t>(cell.column) ? run->room : kNone;
}

std::uint32_t CellRoomMap::next_bit(std::span<const std::uint64_t> bits, std::uint32_t from, std::uint32_t end,
                                    bool is_set) {
  for (std::size_t w = from / 64; from < end; from = static_cast<std::uint32_t>(64 * ++w))
    if (const std::uint64_t left = (is_set ? bits[w] : ~bits[w]) >> (from % 64); left != 0)
      return std::min(end, from + static_cast<std::uint32_t>(std::countr_zero(left)));
  return end;
}

void CellRoomMap::make_x_line(std::uint32_t i) {
  const auto move = [i](std::uint32_t& x) { x += x > i ? 1 : 0; };
  for (Room& room : rooms_) {
    move(room.x0);
    move(room.x1);
  }
  for (std::vector<Run>& row : rows_)
    for (Run& run : row) {
      move(run.from);
      move(run.to);
    }
}

void CellRoomMap::make_y_line(std::uint32_t i) {
  for (Room& room : rooms_)
    for (std::uint32_t* y : {&room.y0, &room.y1}) *y += *y > i ? 1 : 0;
  rows_.insert(rows_.begin() + i, std::vector<Run>(rows_[i]));
}

std::uint32_t CellRoomMap::new_room(const Room& room) {
  if (unused_.empty()) {
    rooms_.push_back(room);
    return static_cast<std::uint32_t>(rooms_.size() - 1);
  }
  const std::uint32_t r = unused_.back();
  unused_.pop_back();
  rooms_[r] = room;
  return r;
}

void CellRoomMap::make_anew(std::span<const std::uint32_t> old, std::vector<std::uint32_t>& fresh) {
  fresh.clear();
  is_old_.resize(rooms_.size());
  std::vector<std::uint32_t> rows;
  for (const std::uint32_t r : old) {
    is_old_[r] = true;
    for (std::uint32_t row = rooms_[r].y0; row < rooms_[r].y1; ++row) rows.push_back(row);
  }
  std::sort(rows.begin(), rows.end());
  rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
  for (const std::uint32_t row : rows) make_row_anew(row, fresh);
  for (const std::uint32_t r : old) {
    is_old_[r] = false;
    rooms_[r] = {};
    unused_.push_back(r);
  }
  for (const std::uint32_t r : fresh) is_fresh_[r] = false;
}

void CellRoomMap::make_row_anew(std::uint32_t row, std::vector<std::uint32_t>& fresh) {
  row_.clear();
  std::uint32_t done = 0;  // up to this column runs are new
  for (const Run& run : rows_[row]) {
    if (!is_old_[run.room]) {
      row_.push_back(run);
      continue;
    }
    for (std::uint32_t from = std::max(run.from, done); from < run.to; from = done) {
      done = next_bit(plan_.open_right(row), from, plan_.columns() - 1, false) + 1;
      row_.push_back({from, done, kNone});
    }
  }
  for (Run& run : row_) {
    if (run.room != kNone) continue;
    if (row > 0) {
      const auto below = first_beyond(rows_[row - 1], run.from);
      if (below != rows_[row - 1].end() && below->from == run.from && below->to == run.to &&
          below->room < is_fresh_.size() && is_fresh_[below->room] &&
          next_bit(plan_.open_above(row - 1), run.from, run.to, false) == run.to) {
        run.room = below->room;
        rooms_[run.room].y1 = row + 1;
        continue;
      }
    }
    run.room = new_room({run.from, run.to, row, row + 1});
    fresh.push_back(run.room);
    is_fresh_.resize(rooms_.size());
    is_fresh_[run.room] = true;
  }
  rows_[row].assign(row_.begin(), row_.end());
}

}  // namespace taut::detail
