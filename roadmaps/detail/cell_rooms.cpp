#include <taut/roadmaps/detail/cell_rooms.h>

#include <bit>

namespace taut::detail {

namespace {

/// Calls visit(from, to) for each stretch: starts[w] and ends[w] have the bits of their first and last columns.
template <class Visit>
void each_stretch(std::size_t words, const auto& starts, const auto& ends, Visit&& visit) {
  std::size_t end_word = 0;
  std::uint64_t end_bits = words > 0 ? ends(0) : 0;
  for (std::size_t w = 0; w < words; ++w)
    for (std::uint64_t bits = starts(w); bits != 0; bits &= bits - 1) {
      while (end_bits == 0) end_bits = ends(++end_word);
      const auto from = static_cast<std::uint32_t>(64 * w + static_cast<std::size_t>(std::countr_zero(bits)));
      const auto last =
          static_cast<std::uint32_t>(64 * end_word + static_cast<std::size_t>(std::countr_zero(end_bits)));
      end_bits &= end_bits - 1;
      visit(from, last + 1);
    }
}

using Words = std::span<const std::uint64_t>;

/// The bits of a row moved up or down by a column.
std::uint64_t moved_up(Words bits, std::size_t w) { return bits[w] << 1 | (w > 0 ? bits[w - 1] >> 63 : 0); }
std::uint64_t moved_down(Words bits, std::size_t w) {
  return bits[w] >> 1 | (w + 1 < bits.size() ? bits[w + 1] << 63 : 0);
}

bool are_set(Words bits, std::uint32_t from, std::uint32_t to) {
  for (std::size_t w = from / 64; w <= (to - 1) / 64; ++w) {
    std::uint64_t wanted = ~std::uint64_t{0};
    if (w == from / 64) wanted &= ~std::uint64_t{0} << (from % 64);
    if (w == (to - 1) / 64) wanted &= ~std::uint64_t{0} >> (63 - (to - 1) % 64);
    if ((bits[w] & wanted) != wanted) return false;
  }
  return true;
}

class Rooms {
 public:
  explicit Rooms(const CellPlan& plan) : plan_(plan) {}

  CellRooms all() {
    make_room();
    for (std::uint32_t row = 0; row < plan_.rows(); ++row) {
      made_.first_of_row.push_back(static_cast<std::uint32_t>(made_.runs.size()));
      add_row(row);
      if (row > 0) join(row);
    }
    made_.first_of_row.push_back(static_cast<std::uint32_t>(made_.runs.size()));
    return std::move(made_);
  }

 private:
  /// As many runs as begin anywhere; rooms and portals are no more, and mostly fewer.
  void make_room() {
    std::size_t runs = 0;
    for (std::uint32_t row = 0; row < plan_.rows(); ++row)
      for (std::size_t w = 0; w < plan_.words_a_row(); ++w)
        runs += static_cast<std::size_t>(std::popcount(plan_.free(row)[w] & ~moved_up(plan_.open_right(row), w)));
    made_.runs.reserve(runs);
    made_.rooms.reserve(runs);
    made_.portals.reserve(runs);
    made_.first_of_row.reserve(std::size_t{plan_.rows()} + 1);
  }

  void add_row(std::uint32_t row) {
    const Words free = plan_.free(row), open = plan_.open_right(row);
    std::size_t below = row > 0 ? made_.first_of_row[row - 1] : 0;
    const std::size_t end = row > 0 ? made_.first_of_row[row] : 0;
    each_stretch(
        free.size(), [&](std::size_t w) { return free[w] & ~moved_up(open, w); },
        [&](std::size_t w) { return free[w] & ~open[w]; },
        [&](std::uint32_t from, std::uint32_t to) {
          while (below < end && made_.runs[below].to <= from) ++below;
          if (below < end && made_.runs[below].from == from && made_.runs[below].to == to &&
              are_set(plan_.open_above(row - 1), from, to)) {
            const std::uint32_t room = made_.runs[below].polygon;
            made_.rooms[room].y1 = row + 1;
            made_.runs.push_back({from, to, room});
          } else {
            made_.runs.push_back({from, to, static_cast<std::uint32_t>(made_.rooms.size())});
            made_.rooms.push_back({from, to, row, row + 1});
          }
        });
  }

  /// The portals on the lower line of a row.
  void join(std::uint32_t row) {
    const Words open = plan_.open_above(row - 1), below = plan_.open_right(row - 1), above = plan_.open_right(row);
    std::size_t i = made_.first_of_row[row - 1], j = made_.first_of_row[row];
    each_stretch(
        open.size(),
        [&](std::size_t w) { return open[w] & ~(moved_up(open, w) & moved_up(below, w) & moved_up(above, w)); },
        [&](std::size_t w) { return open[w] & ~(moved_down(open, w) & below[w] & above[w]); },
        [&](std::uint32_t from, std::uint32_t to) {
          while (made_.runs[i].to <= from) ++i;
          while (made_.runs[j].to <= from) ++j;
          if (made_.runs[i].polygon != made_.runs[j].polygon)
            add_portal({made_.runs[i].polygon, made_.runs[j].polygon, from, to});
        });
  }

  void add_portal(const CellPortal& portal) {
    const auto n = static_cast<std::uint32_t>(made_.portals.size());
    CellRoom& below = made_.rooms[portal.below];
    CellRoom& above = made_.rooms[portal.above];
    if (below.end_up == 0) below.first_up = n;
    if (above.end_down == 0) above.first_down = n;
    below.end_up = above.end_down = n + 1;
    made_.portals.push_back(portal);
  }

  const CellPlan& plan_;
  CellRooms made_;
};

/// What an end meets, as cells.
struct Range {
  std::int32_t left, right, low, high;

  bool meets(const CellRoom& room) const {
    return static_cast<std::int32_t>(room.x0) <= right && static_cast<std::int32_t>(room.x1) > left &&
           static_cast<std::int32_t>(room.y0) <= high && static_cast<std::int32_t>(room.y1) > low;
  }
};

}  // namespace

CellRooms cell_rooms(const CellPlan& plan) { return Rooms(plan).all(); }

void keep_between(CellRooms& rooms, const CellPlan& plan, std::span<const Box> ends) {
  // Of the portals of a room that are left: how many, and the sum of their numbers by bits, which names the last one.
  struct Ways {
    std::uint32_t count = 0;
    std::uint32_t sum = 0;
  };
  constexpr std::uint32_t kEnd = 1U << 30;
  std::vector<Ways> ways(rooms.rooms.size());
  for (std::uint32_t i = 0; i < rooms.portals.size(); ++i)
    for (const std::uint32_t room : {rooms.portals[i].below, rooms.portals[i].above}) {
      ++ways[room].count;
      ways[room].sum ^= i;
    }
  for (const Box& end : ends) {
    const Range range{plan.columns_at(end.min.x)[0], plan.columns_at(end.max.x)[1], plan.rows_at(end.min.y)[0],
                      plan.rows_at(end.max.y)[1]};
    for (std::size_t i = 0; i < ways.size(); ++i)
      if (range.meets(rooms.rooms[i])) ways[i].count |= kEnd;
  }
  constexpr std::uint32_t kOut = 1U << 31;
  for (std::uint32_t first = 0; first < ways.size(); ++first)
    for (std::uint32_t room = first; ways[room].count <= 1;) {
      const bool is_last = ways[room].count == 0;
      ways[room].count = kOut;
      if (is_last) break;
      const std::uint32_t i = ways[room].sum;
      room = rooms.portals[i].below == room ? rooms.portals[i].above : rooms.portals[i].below;
      --ways[room].count;
      ways[room].sum ^= i;
    }
  for (std::size_t i = 0; i < ways.size(); ++i)
    if (ways[i].count != kOut) rooms.rooms[i].polygon = rooms.kept++;
}

}  // namespace taut::detail
