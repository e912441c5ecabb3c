#include <taut/geometry/grid_maze.h>

#include <taut/geometry/expects.h>

namespace taut {

GridMaze::GridMaze(int width, int height, bool walled)
    : width_(width),
      height_(height),
      horizontal_(static_cast<std::size_t>(width) * (height + 1), walled),
      vertical_(static_cast<std::size_t>(width + 1) * height, walled) {
  TAUT_EXPECTS(1 <= width && width <= 20000 && 1 <= height && height <= 20000);
  for (int x = 0; x < width; ++x) {
    set_wall({x, 0}, Side::south, true);
    set_wall({x, height - 1}, Side::north, true);
  }
  for (int y = 0; y < height; ++y) {
    set_wall({0, y}, Side::west, true);
    set_wall({width - 1, y}, Side::east, true);
  }
}

Cell GridMaze::neighbour(Cell c, Side side) {
  switch (side) {
    case Side::north: return {c.x, c.y + 1};
    case Side::east: return {c.x + 1, c.y};
    case Side::south: return {c.x, c.y - 1};
    case Side::west: return {c.x - 1, c.y};
  }
  return c;
}

const std::uint8_t& GridMaze::slot(Cell c, Side side) const {
  TAUT_EXPECTS(contains(c));
  const auto x = static_cast<std::size_t>(c.x), y = static_cast<std::size_t>(c.y);
  const auto w = static_cast<std::size_t>(width_);
  switch (side) {
    case Side::north: return horizontal_[(y + 1) * w + x];
    case Side::south: return horizontal_[y * w + x];
    case Side::east: return vertical_[y * (w + 1) + x + 1];
    case Side::west: return vertical_[y * (w + 1) + x];
  }
  return horizontal_[0];
}

std::vector<Cell> centre_room(int width, int height) {
  std::vector<Cell> room;
  for (int x = (width - 1) / 2; x <= width / 2; ++x)
    for (int y = (height - 1) / 2; y <= height / 2; ++y) room.push_back({x, y});
  return room;
}

}  // namespace taut
