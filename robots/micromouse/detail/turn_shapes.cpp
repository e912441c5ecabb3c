#include <taut/robots/micromouse/detail/turn_shapes.h>

#include <utility>

namespace taut::micromouse::detail {

namespace {

TurnShape reversed(const TurnShape& shape) {
  const Spot end = shape.way.back();
  TurnShape back{shape.turn, turned_by(shape.after, 4), turned_by(shape.heading, 4), true, {}};
  for (auto it = shape.way.rbegin(); it != shape.way.rend(); ++it) back.way.push_back({it->x - end.x, it->y - end.y});
  return back;
}

void add_orthogonal(std::vector<TurnShape>& shapes, Eighth heading, int side) {
  const Eighth across = turned_by(heading, 2 * side);
  const auto at = [&](int u, int v) {
    return Spot{u * kDx[heading] + v * kDx[across], u * kDy[heading] + v * kDy[across]};
  };
  const auto after = [&](int eighths) { return turned_by(heading, side * eighths); };
  shapes.push_back({Turn::small_90, heading, after(2), true, {at(0, 0), at(1, 1)}});
  shapes.push_back({Turn::large_90, heading, after(2), false, {at(0, 0), at(1, 0), at(2, 1), at(2, 2)}});
  shapes.push_back({Turn::turn_180, heading, after(4), false, {at(0, 0), at(1, 0), at(2, 1), at(1, 2), at(0, 2)}});
  shapes.push_back({Turn::turn_45, heading, after(1), false, {at(0, 0), at(1, 0), at(2, 1)}});
  shapes.push_back(reversed(shapes.back()));
  shapes.push_back({Turn::turn_135, heading, after(3), false, {at(0, 0), at(1, 0), at(2, 1)}});
  shapes.push_back(reversed(shapes.back()));
}

}  // namespace

std::vector<std::vector<TurnShape>> turn_shapes() {
  std::vector<TurnShape> shapes;
  for (int heading = 0; heading < 8; ++heading)
    for (const int side : {-1, 1}) {
      const auto h = static_cast<Eighth>(heading);
      if (!is_diagonal(h)) {
        add_orthogonal(shapes, h, side);
        continue;
      }
      const Spot vertex = ahead_of({0, 0}, h);
      shapes.push_back({Turn::diagonal_90,
                        h,
                        turned_by(h, 2 * side),
                        true,
                        {{0, 0}, vertex, ahead_of(vertex, turned_by(h, 2 * side))}});
    }
  std::vector<std::vector<TurnShape>> by_heading(8);
  for (TurnShape& shape : shapes) by_heading[shape.heading].push_back(std::move(shape));
  return by_heading;
}

bool fits(const TurnShape& shape, Spot at) {
  if (shape.from_wall == is_middle_of_cell(at)) return false;
  const Spot end{at.x + shape.way.back().x, at.y + shape.way.back().y};
  if (shape.turn == Turn::diagonal_90) {
    const Spot vertex = ahead_of(at, shape.heading);
    return (vertex.y & 1) == 0 ? kDy[shape.heading] == kDy[shape.after] : kDx[shape.heading] == kDx[shape.after];
  }
  return is_diagonal(shape.heading) ? is_middle_of_cell(end) : true;
}

bool is_open(const GridMaze& maze, Spot at) {
  if (at.x <= 0 || at.y <= 0 || at.x >= 2 * maze.width() || at.y >= 2 * maze.height()) return false;
  if (is_middle_of_cell(at)) return true;
  if ((at.x & 1) == 0) return !maze.wall({at.x / 2, (at.y - 1) / 2}, Side::west);
  return !maze.wall({(at.x - 1) / 2, at.y / 2}, Side::south);
}

GridMaze with_closed_border(GridMaze maze) {
  for (int x = 0; x < maze.width(); ++x)
    maze.set_wall({x, 0}, Side::south, true), maze.set_wall({x, maze.height() - 1}, Side::north, true);
  for (int y = 0; y < maze.height(); ++y)
    maze.set_wall({0, y}, Side::west, true), maze.set_wall({maze.width() - 1, y}, Side::east, true);
  return maze;
}

}  // namespace taut::micromouse::detail
