#include <taut/robots/pursuit/detail/building.h>

#include <algorithm>

namespace taut::pursuit::detail {

namespace {

/// Cells lo..hi - 1 along x and along y.
struct Box {
  int lo[2];
  int hi[2];

  int length(int axis) const { return hi[axis] - lo[axis]; }
};

class Architect {
 public:
  Architect(int x_size, int y_size, taut::Draws& draws)
      : columns_(y_size), draws_(draws), walls_(static_cast<std::size_t>(x_size) * static_cast<std::size_t>(y_size)) {
    const int side = std::min(x_size, y_size);
    thick_ = std::clamp(side / 60, 1, 4);
    corridor_ = std::clamp(side / 12, 2, 30);
    door_ = std::clamp(side / 16, 1, 20);
  }

  std::vector<std::uint8_t> build(const Box& outside) {
    fill(outside, 1);
    Box inside = outside;
    for (const int axis : {0, 1}) {
      const int edge = std::min(thick_, (outside.length(axis) - 1) / 2);
      inside.lo[axis] += edge;
      inside.hi[axis] -= edge;
    }
    fill(inside, 0);
    divide(inside);
    for (const Box& box : open_) fill(box, 0);
    return std::move(walls_);
  }

 private:
  int between(int lo, int hi) { return lo + static_cast<int>(draws_.below(static_cast<std::uint32_t>(hi - lo + 1))); }

  void fill(const Box& box, std::uint8_t value) {
    for (int x = box.lo[0]; x < box.hi[0]; ++x)
      std::fill_n(walls_.begin() + static_cast<std::ptrdiff_t>(x) * columns_ + box.lo[1], box.length(1), value);
  }

  // Wings by corridors, wings into rooms by walls.
  void divide(const Box& box) {
    const int axis = box.length(0) >= box.length(1) ? 0 : 1, length = box.length(axis);
    const bool is_wing = length > 12 * corridor_;
    if (length < 4 * corridor_ + 2 * thick_ || (!is_wing && length < 9 * corridor_ && draws_.below(5) == 0)) return;
    const int wide = is_wing ? between((2 * corridor_ + 4) / 5, corridor_) : 0;
    const int gap = wide + (is_wing ? 2 : 1) * thick_;
    const int at = box.lo[axis] + between(length / 3, 2 * length / 3) - gap / 2;
    Box left = box, right = box;
    left.hi[axis] = at;
    right.lo[axis] = at + gap;
    wall(box, axis, at);
    if (is_wing) {
      wall(box, axis, at + gap - thick_);
      Box way = box;  // opens into what it ends at, a corridor or the outer wall
      way.lo[axis] = at + thick_;
      way.hi[axis] = at + thick_ + wide;
      open_.push_back(way);
    }
    divide(left);
    divide(right);
  }

  void wall(const Box& box, int axis, int at) {
    Box wall = box;
    wall.lo[axis] = at;
    wall.hi[axis] = at + thick_;
    fill(wall, 1);
    const int other = 1 - axis, length = box.length(other);
    for (int doors = 1 + length / (6 * corridor_); doors > 0; --doors) {
      Box door = wall;
      const int wide = std::min(between((2 * door_ + 4) / 5, door_), length);
      door.lo[other] = box.lo[other] + between(0, length - wide);
      door.hi[other] = door.lo[other] + wide;
      open_.push_back(door);
    }
  }

  int columns_;
  taut::Draws& draws_;
  std::vector<std::uint8_t> walls_;
  std::vector<Box> open_;
  int thick_, corridor_, door_;
};

}  // namespace

std::vector<std::uint8_t> building(int x_size, int y_size, taut::Draws& draws) {
  return Architect(x_size, y_size, draws).build({{0, 0}, {x_size, y_size}});
}

std::vector<std::uint32_t> inflated(const std::vector<std::uint8_t>& walls, int x_size, int y_size, int radius) {
  const auto rows = static_cast<std::size_t>(x_size), columns = static_cast<std::size_t>(y_size);
  std::vector<std::uint32_t> sums((rows + 1) * (columns + 1), 0),
      costs(walls.size());  // of all cells below and to the left
  const auto sum = [&](int x, int y) -> std::uint32_t& {
    return sums[static_cast<std::size_t>(x) * (columns + 1) + static_cast<std::size_t>(y)];
  };
  auto wall = walls.begin();
  for (int x = 0; x < x_size; ++x)
    for (int y = 0; y < y_size; ++y) sum(x + 1, y + 1) = sum(x, y + 1) + sum(x + 1, y) - sum(x, y) + *wall++;
  auto cost = costs.begin();
  for (int x = 0; x < x_size; ++x)
    for (int y = 0; y < y_size; ++y) {
      const int x0 = std::max(0, x - radius), x1 = std::min(x_size, x + radius + 1), y0 = std::max(0, y - radius),
                y1 = std::min(y_size, y + radius + 1);
      *cost++ = 1 + 10 * (sum(x1, y1) - sum(x0, y1) - sum(x1, y0) + sum(x0, y0));
    }
  return costs;
}

}  // namespace taut::pursuit::detail
