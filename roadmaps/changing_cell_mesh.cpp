#include <taut/roadmaps/changing_cell_mesh.h>

#include <algorithm>
#include <bit>
#include <unordered_map>
#include <utility>

#include <taut/roadmaps/detail/cell_bends.h>
#include <taut/roadmaps/detail/cell_room_map.h>
#include <taut/roadmaps/detail/navmesh_blocks.h>

namespace taut {

namespace {

using detail::CellRoomMap;
using Rooms = std::vector<std::uint32_t>;

struct PointHash {
  std::size_t operator()(Point p) const {
    const auto x = std::bit_cast<std::uint64_t>(p.x), y = std::bit_cast<std::uint64_t>(p.y);
    return (x * 0x9e3779b97f4a7c15U ^ (y + (x >> 32))) * 0xff51afd7ed558ccdU >> 16;
  }
};

/// A stretch as lines: along one of them, from another to another.
struct Along {
  bool is_upright;
  std::uint32_t line, from, to;
};

/// The mesh that rooms are put into and taken out of.
class RoomMesh {
 public:
  RoomMesh(const CellPlan& plan, CellRoomMap& rooms) : plan_(plan), rooms_(rooms) {}

  Navmesh& mesh() { return mesh_; }

  void put_all() {
    mesh_ = Navmesh{};
    mesh_.first.assign(1, 0);
    bend_at_.clear();
    gone_ = 0;
    Rooms all;
    for (std::uint32_t r = 0; r < rooms_.rooms().size(); ++r)
      if (rooms_.room(r).x0 != rooms_.room(r).x1) all.push_back(r);
    put(all);
  }

  /// Precondition: all that they have portals to are among them or in the mesh.
  void put(const Rooms& rooms) {
    portals_.clear();
    const std::uint32_t first = mesh_.polygon_count();
    for (const std::uint32_t r : rooms) add(r);
    for (const Portal& portal : portals_) {
      const std::uint32_t across = find_across(portal);
      mesh_.corners[portal.corner].across = across;
      mesh_.corners[across].across = portal.corner;
    }
    for (std::uint32_t p = first; p < mesh_.polygon_count(); ++p) bound_bends(p);
  }

  void take_out(std::uint32_t polygon) {
    for (std::uint32_t c = mesh_.first[polygon]; c < mesh_.first[polygon + 1]; ++c) mesh_.corners[c].across = kNone;
    gone_ += mesh_.first[polygon + 1] - mesh_.first[polygon];
  }

  bool is_mostly_gone() const { return 2 * gone_ > mesh_.corners.size() + kFew; }

 private:
  struct Portal {
    std::uint32_t corner;  // where it begins
    std::uint32_t other;   // the room beyond
    Point other_begin;     // where it begins seen from there
    bool above;
  };

  static constexpr std::size_t kFew = 4096;

  /// Along the lower side to the right, along the upper one back.
  void add(std::uint32_t r) {
    CellRoomMap::Room& room = rooms_.room(r);
    room.polygon = mesh_.polygon_count();
    const std::uint32_t first = mesh_.first.back();
    first_ = first;
    add_corner(room, room.x0, room.y0, 0);
    rooms_.each_portal(r, false, [&](std::uint32_t other, std::uint32_t from, std::uint32_t to) {
      const std::uint32_t c = add_corner(room, from, room.y0, 0);
      portals_.push_back({c, other, {plan_.x(to), plan_.y(room.y0)}, false});
      add_corner(room, to, room.y0, 1);
    });
    add_corner(room, room.x1, room.y0, 1);
    add_corner(room, room.x1, room.y1, 2);
    upper_.clear();
    rooms_.each_portal(r, true, [&](std::uint32_t other, std::uint32_t from, std::uint32_t to) {
      upper_.push_back({other, from, to});
    });
    for (auto portal = upper_.rbegin(); portal != upper_.rend(); ++portal) {
      const std::uint32_t c = add_corner(room, portal->to, room.y1, 2);
      portals_.push_back({c, portal->other, {plan_.x(portal->from), plan_.y(room.y1)}, true});
      add_corner(room, portal->from, room.y1, 3);
    }
    add_corner(room, room.x0, room.y1, 3);
    mesh_.first.push_back(static_cast<std::uint32_t>(mesh_.corners.size()));
  }

  /// The one that was added last, when it is the same. The room lies in that quadrant around it.
  std::uint32_t add_corner(const CellRoomMap::Room& room, std::uint32_t x, std::uint32_t y, int quadrant) {
    const Point at{plan_.x(x), plan_.y(y)};
    if (mesh_.corners.size() == first_ || mesh_.corners.back().point != at)
      mesh_.corners.push_back({at, kNone, room.polygon, bend(at, x, y, quadrant), kNone});
    return static_cast<std::uint32_t>(mesh_.corners.size() - 1);
  }

  std::uint32_t bend(Point at, std::uint32_t x, std::uint32_t y, int quadrant) {
    const auto made = detail::cell_bend(plan_, x, y, quadrant);
    if (!made) return kNone;
    const auto [known, is_new] = bend_at_.try_emplace(at, static_cast<std::uint32_t>(mesh_.bends.size()));
    if (is_new) mesh_.bends.emplace_back();
    Navmesh::Bend& bend = mesh_.bends[known->second];
    bend.right = made->right;
    bend.left = made->left;
    return known->second;
  }

  /// The corner of the room beyond at which a portal begins; corners of its lower side come first, then those of the
  /// upper one, from right to left.
  std::uint32_t find_across(const Portal& portal) const {
    const std::uint32_t polygon = rooms_.room(portal.other).polygon;
    const auto begin = mesh_.corners.begin() + mesh_.first[polygon],
               end = mesh_.corners.begin() + mesh_.first[polygon + 1];
    const double low = begin->point.y, x = portal.other_begin.x;
    const auto found = std::partition_point(begin, end, [&](const Navmesh::Corner& c) {
      return portal.above ? c.point.y == low && c.point.x < x : c.point.y == low || c.point.x > x;
    });
    return static_cast<std::uint32_t>(found - mesh_.corners.begin());
  }

  void bound_bends(std::uint32_t p) {
    for (std::uint32_t c = mesh_.first[p], before = mesh_.first[p + 1] - 1; c < mesh_.first[p + 1]; before = c++) {
      if (mesh_.corners[c].bend == kNone) continue;
      Navmesh::Bend& bend = mesh_.bends[mesh_.corners[c].bend];
      if (mesh_.corners[c].across == kNone) bend.right_corner = c;
      if (mesh_.corners[before].across == kNone) bend.left_corner = c;
    }
  }

  struct Upper {
    std::uint32_t other, from, to;
  };

  const CellPlan& plan_;
  CellRoomMap& rooms_;
  Navmesh mesh_;
  std::unordered_map<Point, std::uint32_t, PointHash> bend_at_;  // only looked up in
  std::vector<Portal> portals_;
  std::vector<Upper> upper_;
  std::size_t first_ = 0, gone_ = 0;
};

}  // namespace

struct ChangingCellMesh::Impl {
  explicit Impl(CellPlan of) : plan(std::move(of)), rooms(plan), made(plan, rooms) { made.put_all(); }

  void make_x_line(double x) {
    const std::uint32_t before = plan.columns(), line = plan.make_x_line(x);
    if (plan.columns() > before) rooms.make_x_line(line - 1);
  }
  void make_y_line(double y) {
    const std::uint32_t before = plan.rows(), line = plan.make_y_line(y);
    if (plan.rows() > before) rooms.make_y_line(line - 1);
  }

  Along along(const Segment& s) {
    for (const Point p : {s.a, s.b}) {
      make_x_line(p.x);
      make_y_line(p.y);
    }
    const auto line = [](const std::array<std::int32_t, 2>& at) { return static_cast<std::uint32_t>(at[1]); };
    const bool is_upright = s.a.x == s.b.x;
    const std::uint32_t ax = line(plan.columns_at(s.a.x)), ay = line(plan.rows_at(s.a.y)),
                        bx = line(plan.columns_at(s.b.x)), by = line(plan.rows_at(s.b.y));
    return is_upright ? Along{true, ax, std::min(ay, by), std::max(ay, by)}
                      : Along{false, ay, std::min(ax, bx), std::max(ax, bx)};
  }

  /// Says whether a side changed.
  bool set_sides(const Along& at, const std::function<bool(const Segment&)>& is_wall) {
    bool changed = false;
    const std::uint32_t last = at.is_upright ? plan.columns() : plan.rows();
    if (at.line == 0 || at.line == last) return false;
    for (std::uint32_t i = at.from; i < at.to; ++i) {
      const auto near = static_cast<std::int32_t>(at.line) - 1, k = static_cast<std::int32_t>(i);
      const CellPlan::Cell cell = at.is_upright ? CellPlan::Cell{near, k} : CellPlan::Cell{k, near},
                           beyond = at.is_upright ? CellPlan::Cell{near + 1, k} : CellPlan::Cell{k, near + 1};
      if (!plan.is_free(cell) || !plan.is_free(beyond)) continue;
      const Segment side = at.is_upright ? Segment{{plan.x(at.line), plan.y(i)}, {plan.x(at.line), plan.y(i + 1)}}
                                         : Segment{{plan.x(i), plan.y(at.line)}, {plan.x(i + 1), plan.y(at.line)}};
      const bool open = !is_wall(side);
      if ((at.is_upright ? plan.is_open_right(cell) : plan.is_open_above(cell)) == open) continue;
      at.is_upright ? plan.set_open_right(cell, open) : plan.set_open_above(cell, open);
      changed = true;
    }
    return changed;
  }

  /// The rooms around all corners along a stretch.
  Rooms rooms_along(const Along& at) const {
    Rooms found;
    const auto line = static_cast<std::int32_t>(at.line), from = static_cast<std::int32_t>(at.from),
               to = static_cast<std::int32_t>(at.to);
    for (const std::int32_t beside : {line - 1, line})
      for (std::int32_t i = from - 1; i <= to; ++i) {
        const std::uint32_t r = rooms.at(at.is_upright ? CellPlan::Cell{beside, i} : CellPlan::Cell{i, beside});
        if (r == kNone) continue;
        found.push_back(r);
        i = static_cast<std::int32_t>(at.is_upright ? rooms.room(r).y1 : rooms.room(r).x1) - 1;
      }
    return once(std::move(found));
  }

  Rooms with_neighbours(const Rooms& of) const {
    Rooms all = of;
    for (const std::uint32_t r : of)
      for (const bool above : {false, true})
        rooms.each_portal(r, above, [&](std::uint32_t other, std::uint32_t, std::uint32_t) { all.push_back(other); });
    return once(std::move(all));
  }

  static Rooms once(Rooms all) {
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
  }

  void make_anew_around(const Along& at) {
    const Rooms old = with_neighbours(rooms_along(at));  // neighbours may come to agree
    Rooms beyond = with_neighbours(old);
    for (const std::uint32_t r : beyond) made.take_out(rooms.room(r).polygon);
    std::erase_if(beyond, [&](std::uint32_t r) { return std::binary_search(old.begin(), old.end(), r); });
    Rooms fresh;
    rooms.make_anew(old, fresh);
    fresh.insert(fresh.end(), beyond.begin(), beyond.end());
    made.put(fresh);
    if (made.is_mostly_gone()) made.put_all();
    has_blocks = false;
  }

  CellPlan plan;
  CellRoomMap rooms;
  RoomMesh made;
  bool has_blocks = false;
};

ChangingCellMesh::ChangingCellMesh(CellPlan plan) : impl_(std::make_unique<Impl>(std::move(plan))) {}
ChangingCellMesh::ChangingCellMesh(ChangingCellMesh&&) noexcept = default;
ChangingCellMesh& ChangingCellMesh::operator=(ChangingCellMesh&&) noexcept = default;
ChangingCellMesh::~ChangingCellMesh() = default;

const CellPlan& ChangingCellMesh::plan() const { return impl_->plan; }

void ChangingCellMesh::change(const Segment& stretch, const std::function<bool(const Segment& side)>& is_wall) {
  const Along at = impl_->along(stretch);
  if (impl_->set_sides(at, is_wall)) impl_->make_anew_around(at);
}

const Navmesh& ChangingCellMesh::mesh() {
  if (!impl_->has_blocks) detail::find_blocks(impl_->made.mesh());
  impl_->has_blocks = true;
  return impl_->made.mesh();
}

void ChangingCellMesh::around(Point p, std::vector<std::uint32_t>& polygons) const {
  polygons.clear();
  const CellPlan::Around around = impl_->plan.around(p);
  for (std::size_t i = 0; i < around.cells.size(); ++i)
    if ((around.free >> i) & 1) polygons.push_back(impl_->rooms.room(impl_->rooms.at(around.cells[i])).polygon);
  std::sort(polygons.begin(), polygons.end());
  polygons.erase(std::unique(polygons.begin(), polygons.end()), polygons.end());
}

}  // namespace taut
