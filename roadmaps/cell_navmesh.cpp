#include <taut/roadmaps/cell_navmesh.h>

#include <algorithm>
#include <bit>
#include <utility>

#include <taut/roadmaps/detail/cell_bends.h>
#include <taut/roadmaps/detail/cell_rooms.h>
#include <taut/roadmaps/detail/navmesh_bends.h>
#include <taut/roadmaps/detail/navmesh_blocks.h>

namespace taut {

namespace {

using detail::CellPortal;
using detail::CellRoom;
using detail::CellRooms;

/// Reflex sectors by the corner that they are at: there is at most one.
class Bends {
 public:
  explicit Bends(const CellPlan& plan, std::size_t most) : plan_(plan), slots_(std::bit_ceil(2 * most + 16)) {}

  /// The bend that quadrant `i` of a corner is a part of, or kNone.
  std::uint32_t at(Navmesh& mesh, std::uint32_t x, std::uint32_t y, int i) {
    const auto bend = detail::cell_bend(plan_, x, y, i);
    if (!bend) return kNone;
    const std::uint64_t key = (std::uint64_t{y} << 32 | x) + 1;
    std::size_t k = (key * 0x9e3779b97f4a7c15U) >> 20 & (slots_.size() - 1);
    while (slots_[k].key != 0 && slots_[k].key != key) k = (k + 1) & (slots_.size() - 1);
    if (slots_[k].key == 0) {
      slots_[k] = {key, static_cast<std::uint32_t>(mesh.bends.size())};
      mesh.bends.push_back(*bend);
    }
    return slots_[k].bend;
  }

 private:
  struct Slot {
    std::uint64_t key = 0;
    std::uint32_t bend = kNone;
  };

  const CellPlan& plan_;
  std::vector<Slot> slots_;
};

class Meshing {
 public:
  Meshing(const CellPlan& plan, const CellRooms& rooms)
      : plan_(plan),
        rooms_(rooms),
        bends_(plan, 2 * std::size_t{rooms.kept}),
        corner_below_(rooms.portals.size(), kNone),
        corner_above_(rooms.portals.size(), kNone) {}

  Navmesh mesh() {
    mesh_.first.reserve(std::size_t{rooms_.kept} + 1);
    mesh_.corners.reserve(8 * std::size_t{rooms_.kept});
    for (const CellRoom& room : rooms_.rooms)
      if (room.polygon != kNone) add(room);
    mesh_.first.push_back(static_cast<std::uint32_t>(mesh_.corners.size()));
    for (std::size_t i = 0; i < rooms_.portals.size(); ++i) {
      if (corner_below_[i] == kNone) continue;
      mesh_.corners[corner_below_[i]].across = corner_above_[i];
      mesh_.corners[corner_above_[i]].across = corner_below_[i];
    }
    detail::bound_bends(mesh_);
    detail::find_blocks(mesh_);
    return std::move(mesh_);
  }

 private:
  bool is_kept(const CellPortal& portal) const {
    return rooms_.rooms[portal.below].polygon != kNone && rooms_.rooms[portal.above].polygon != kNone;
  }

  /// Along the lower side to the right, along the upper one back.
  void add(const CellRoom& room) {
    mesh_.first.push_back(static_cast<std::uint32_t>(mesh_.corners.size()));
    last_ = {kNone, kNone};
    add_corner(room.polygon, room.x0, room.y0, 0);
    for (std::uint32_t i = room.first_down; i < room.end_down; ++i)
      if (const CellPortal& portal = rooms_.portals[i]; is_kept(portal)) {
        corner_above_[i] = add_corner(room.polygon, portal.from, room.y0, 0);
        add_corner(room.polygon, portal.to, room.y0, 1);
      }
    add_corner(room.polygon, room.x1, room.y0, 1);
    add_corner(room.polygon, room.x1, room.y1, 2);
    for (std::uint32_t i = room.end_up; i-- > room.first_up;)
      if (const CellPortal& portal = rooms_.portals[i]; is_kept(portal)) {
        corner_below_[i] = add_corner(room.polygon, portal.to, room.y1, 2);
        add_corner(room.polygon, portal.from, room.y1, 3);
      }
    add_corner(room.polygon, room.x0, room.y1, 3);
  }

  /// The one that was added last, when it is the same. The room lies in that quadrant around it.
  std::uint32_t add_corner(std::uint32_t polygon, std::uint32_t x, std::uint32_t y, int quadrant) {
    if (last_ != std::pair(x, y)) {
      last_ = {x, y};
      mesh_.corners.push_back({{plan_.x(x), plan_.y(y)}, kNone, polygon, bends_.at(mesh_, x, y, quadrant), kNone});
    }
    return static_cast<std::uint32_t>(mesh_.corners.size() - 1);
  }

  const CellPlan& plan_;
  const CellRooms& rooms_;
  Bends bends_;
  Navmesh mesh_;
  std::vector<std::uint32_t> corner_below_, corner_above_;  // portal -> the corner where it begins, in either room
  std::pair<std::uint32_t, std::uint32_t> last_;
};

}  // namespace

std::uint32_t CellPolygons::at(CellPlan::Cell cell) const {
  if (cell.column < 0 || cell.row < 0 || static_cast<std::size_t>(cell.row) + 1 >= first_.size()) return kNone;
  const auto row = static_cast<std::size_t>(cell.row);
  const auto column = static_cast<std::uint32_t>(cell.column);
  const auto begin = runs_.begin() + first_[row], end = runs_.begin() + first_[row + 1];
  const auto after = std::upper_bound(begin, end, column, [](std::uint32_t c, const Run& run) { return c < run.from; });
  return after != begin && column < (after - 1)->to ? (after - 1)->polygon : kNone;
}

void CellPolygons::around(const CellPlan& plan, Point p, std::optional<Point> towards,
                          std::vector<std::uint32_t>& out) const {
  out.clear();
  const CellPlan::Around around = plan.around(p);
  const unsigned quadrants = towards ? around.towards(p, *towards) : around.free;
  for (int i = 0; i < 4; ++i) {
    if (!((quadrants >> i) & 1)) continue;
    const std::uint32_t polygon = at(around.cells[static_cast<std::size_t>(i)]);
    if (polygon != kNone) out.push_back(polygon);
  }
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
}

CellNavmesh cell_navmesh_between(const CellPlan& plan, Point from, const Goal& to) {
  std::vector<Box> ends{{from, from}};
  if (to.point) ends.push_back({*to.point, *to.point});
  ends.insert(ends.end(), to.room.begin(), to.room.end());
  CellRooms rooms = detail::cell_rooms(plan);
  detail::keep_between(rooms, plan, ends);
  Navmesh mesh = Meshing(plan, rooms).mesh();
  for (CellPolygons::Run& run : rooms.runs) run.polygon = rooms.rooms[run.polygon].polygon;
  return {std::move(mesh), {std::move(rooms.runs), std::move(rooms.first_of_row)}};
}

}  // namespace taut
