// The funnel of graphviz's libpathplan, which shares no code with the planners, as their judge in simple polygons: around random trees of
// rooms and doors, in whole numbers, sheared. TAUT_RANDOM_WORLDS says how many.
#include <graphviz/pathplan.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <taut/roadmaps/visibility_graph.h>
#include <taut/search/polyanya.h>
#include <taut/search/shortest_path.h>

namespace taut {
namespace {

int worlds(int usual) {
  const char* asked = std::getenv("TAUT_RANDOM_WORLDS");
  return asked ? std::atoi(asked) : usual;
}

/// Rooms of 2 x 2 at every third whole number, in a tree; between two joined ones a door of width 1.
class TreeOfRooms {
 public:
  explicit TreeOfRooms(unsigned seed) : engine_(seed) {
    side_ = between(2, 7);
    stretch_ = between(1, 3);
    shear_x_ = between(-2, 2);
    grow();
    outline(0, 0, -1);
    if (ring_.back() == ring_.front()) ring_.pop_back();
  }

  const Ring& ring() const { return ring_; }

  /// In the inside of a room.
  Point place() {
    const int x = 3 * between(0, side_ - 1), y = 3 * between(0, side_ - 1);
    return sheared(x + 0.25 * between(1, 7), y + 0.25 * between(1, 7));
  }

 private:
  enum Direction { kSouth, kEast, kNorth, kWest };
  struct Room {
    std::array<int, 4> door{-1, -1, -1, -1};  ///< where on its side a door begins: 0 or 1; -1: none
    bool seen = false;
  };

  int between(int least, int most) {
    return least + static_cast<int>(engine_() % static_cast<unsigned>(most - least + 1));
  }
  Room& room(int i, int j) { return rooms_[static_cast<std::size_t>(j * side_ + i)]; }
  Point sheared(double x, double y) const { return {stretch_ * x + shear_x_ * y, y}; }
  static int step_x(int direction) { return direction == kEast ? 1 : direction == kWest ? -1 : 0; }
  static int step_y(int direction) { return direction == kNorth ? 1 : direction == kSouth ? -1 : 0; }

  void grow() {
    rooms_.resize(static_cast<std::size_t>(side_ * side_));
    std::vector<std::array<int, 2>> trail{{0, 0}};
    room(0, 0).seen = true;
    while (!trail.empty()) {
      const auto [i, j] = trail.back();
      std::vector<int> ways;
      for (int d = 0; d < 4; ++d) {
        const int x = i + step_x(d), y = j + step_y(d);
        if (x >= 0 && y >= 0 && x < side_ && y < side_ && !room(x, y).seen) ways.push_back(d);
      }
      if (ways.empty()) {
        trail.pop_back();
        continue;
      }
      const int d = ways[engine_() % ways.size()], x = i + step_x(d), y = j + step_y(d);
      room(i, j).door[d] = room(x, y).door[(d + 2) % 4] = between(0, 1);
      room(x, y).seen = true;
      trail.push_back({x, y});
    }
  }

  /// Counter-clockwise around a room and all that is behind its doors, but for the side that it was entered through: from the end of that
  /// to its beginning.
  void outline(int i, int j, int entry) {
    const double x = 3 * i, y = 3 * j;
    const std::array<Point, 4> corners{{{x, y}, {x + 2, y}, {x + 2, y + 2}, {x, y + 2}}};
    const int first = entry < 0 ? 0 : entry + 1, count = entry < 0 ? 4 : 3;
    for (int k = first; k < first + count; ++k) {
      const int side = k % 4;
      append(corners[side]);
      if (room(i, j).door[side] >= 0) through(i, j, side, corners[side]);
    }
    if (entry >= 0) append(corners[entry]);
  }

  /// Out of a door in the side that begins at `from`, around what is behind it, and in again.
  void through(int i, int j, int side, Point from) {
    const int door = room(i, j).door[side];
    const Point along{double(step_x((side + 1) % 4)), double(step_y((side + 1) % 4))};
    const Point out{double(step_x(side)), double(step_y(side))};
    const double begin = side == kSouth || side == kEast ? door : 1 - door;
    const Point near{from.x + begin * along.x, from.y + begin * along.y}, far{near.x + along.x, near.y + along.y};
    append(near);
    append({near.x + out.x, near.y + out.y});
    outline(i + step_x(side), j + step_y(side), (side + 2) % 4);
    append({far.x + out.x, far.y + out.y});
    append(far);
  }

  void append(Point p) {
    const Point place = sheared(p.x, p.y);
    if (ring_.empty() || ring_.back() != place) ring_.push_back(place);
  }

  std::mt19937 engine_;
  int side_ = 2, stretch_ = 1, shear_x_ = 0;
  std::vector<Room> rooms_;
  Ring ring_;
};

double by_pathplan(const Ring& ring, Point from, Point to) {
  std::vector<Ppoint_t> corners;
  for (auto p = ring.rbegin(); p != ring.rend(); ++p) corners.push_back({p->x, p->y});  // it goes around clockwise
  Ppoly_t polygon{corners.data(), static_cast<int>(corners.size())};
  Ppoint_t ends[2] = {{from.x, from.y}, {to.x, to.y}};
  Ppolyline_t route{};
  if (Pshortestpath(&polygon, ends, &route) != 0) return NAN;
  double length = 0;
  for (int i = 1; i < route.pn; ++i)
    length += std::hypot(route.ps[i].x - route.ps[i - 1].x, route.ps[i].y - route.ps[i - 1].y);
  return length;
}

std::string text(const Ring& ring, Point from, Point to) {
  std::string all = fmt::format("start {} {}\ngoal {} {}\nboundary", from.x, from.y, to.x, to.y);
  for (const Point& p : ring) all += fmt::format(" {} {}", p.x, p.y);
  return all;
}

TEST(Pathplan, FindsTheSameLengthsInSimplePolygons) {
  for (int seed = 0; seed < worlds(300); ++seed) {
    TreeOfRooms rooms(static_cast<unsigned>(seed));
    const Point from = rooms.place(), to = rooms.place();
    WorldParts parts;
    parts.areas.push_back({Polygon{rooms.ring(), {}}, 0});
    const FreeSpace space{World(parts)};
    const double expected = by_pathplan(rooms.ring(), from, to);
    const auto path = shortest_path(space, from, to);
    ASSERT_TRUE(path) << text(rooms.ring(), from, to);
    EXPECT_NEAR(path->length.value(), expected, 1e-9 * (1 + expected)) << text(rooms.ring(), from, to);
    const GraphSearchResult found = shortest_path(VisibilityGraph(space), from, Goal{to, {}});
    ASSERT_EQ(found.status, SearchStatus::found);
    EXPECT_EQ(found.path.length, path->length) << text(rooms.ring(), from, to);
  }
}

}  // namespace
}  // namespace taut
