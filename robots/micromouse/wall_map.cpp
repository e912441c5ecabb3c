#include <taut/robots/micromouse/wall_map.h>

#include <algorithm>

#include <taut/geometry/expects.h>

namespace taut::micromouse {

namespace {

std::size_t bit_of(const Passages& p, Cell c) {
  return static_cast<std::size_t>(c.y) * static_cast<std::size_t>(p.width) + static_cast<std::size_t>(c.x);
}

bool bit(const CellBits& bits, std::size_t i) { return (bits[i / 64] >> (i % 64) & 1U) != 0; }

void assign(CellBits& bits, std::size_t i, bool value) {
  const std::uint64_t mask = std::uint64_t{1} << (i % 64);
  bits[i / 64] = value ? bits[i / 64] | mask : bits[i / 64] & ~mask;
}

bool inside(const Passages& p, Cell c) { return c.x >= 0 && c.y >= 0 && c.x < p.width && c.y < p.height; }

}  // namespace

bool Passages::open(Cell cell, Side side) const {
  if (side == Side::south || side == Side::west) {
    cell = ahead(cell, side);
    if (!inside(*this, cell)) return false;
    side = opposite(side);
  }
  return bit(side == Side::north ? north : east, bit_of(*this, cell));
}

void Passages::set(Cell cell, Side side, bool open) {
  TAUT_EXPECTS(inside(*this, cell) && inside(*this, ahead(cell, side)));
  const CellSide wall = canonical({cell, side});
  assign(wall.side == Side::north ? north : east, bit_of(*this, wall.cell), open);
}

Passages passages(int width, int height, bool open) {
  const std::size_t cells = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  Passages p{width, height, CellBits((cells + 63) / 64), CellBits((cells + 63) / 64)};
  for (int y = 0; open && y < height; ++y)
    for (int x = 0; x < width; ++x) {
      if (y + 1 < height) p.set({x, y}, Side::north, true);
      if (x + 1 < width) p.set({x, y}, Side::east, true);
    }
  return p;
}

Passages passages_of(const GridMaze& maze) {
  Passages p = passages(maze.width(), maze.height(), false);
  for (int y = 0; y < maze.height(); ++y)
    for (int x = 0; x < maze.width(); ++x)
      for (const Side side : {Side::north, Side::east})
        if (maze.contains(ahead({x, y}, side)) && !maze.wall({x, y}, side)) p.set({x, y}, side, true);
  return p;
}

WallMap::WallMap(const Task& task)
    : certain_(passages(task.width, task.height, false)), possible_(passages(task.width, task.height, true)) {
  const auto w = static_cast<std::size_t>(task.width), h = static_cast<std::size_t>(task.height);
  interior_ = unknown_ = (w - 1) * h + w * (h - 1);
}

WallState WallMap::state(Cell cell, Side side) const {
  if (certain_.open(cell, side)) return WallState::open;
  return possible_.open(cell, side) ? WallState::unknown : WallState::closed;
}

bool WallMap::learn(Cell cell, Side side, bool closed) {
  const WallState known = state(cell, side);
  TAUT_EXPECTS(known == WallState::unknown || (known == WallState::closed) == closed);
  if (known != WallState::unknown) return false;
  if (closed)
    possible_.set(cell, side, false);
  else
    certain_.set(cell, side, true);
  --unknown_;
  return true;
}

std::vector<WallSeen> WallMap::see(const MousePose& pose, const SensorReading& sight) {
  std::vector<WallSeen> news;
  for (const int quarters : {-1, 0, 1}) {
    const Side side = turned(pose.heading, quarters);
    const int reading = sight.at(quarters);
    for (int i = 0; i <= reading; ++i) {
      const Cell cell = ahead(pose.cell, side, i);
      if (learn(cell, side, i == reading)) news.push_back({canonical({cell, side}), i == reading});
    }
  }
  return news;
}

std::vector<WallSeen> WallMap::move(const MousePose& before, const Action& action, const MousePose& after) {
  std::vector<WallSeen> news;
  const Side side = action.movement < 0 ? opposite(after.heading) : after.heading;
  const int wanted = std::min(std::abs(action.movement), kLongestMove);
  Cell cell = before.cell;
  for (int i = 0; i < wanted; ++i) {
    const bool blocked = cell == after.cell;
    if (learn(cell, side, blocked)) news.push_back({canonical({cell, side}), blocked});
    if (blocked) break;
    cell = ahead(cell, side);
  }
  return news;
}

void Odometer::act(const Action& action) { pending_ = action; }

void Odometer::restart() {
  pending_.reset();
  previous_ = pose_ = start_;
}

void Odometer::sense(const SensorReading& sight) {
  previous_ = pose_;
  if (pending_ && !pending_->reset) {
    const int rotation = pending_->rotation;
    const bool turns = rotation == 90 || rotation == -90;
    const int reading = sight_.at(turns ? rotation : 0);
    if (turns) pose_.heading = turned(pose_.heading, rotation / 90);
    const int movement = std::clamp(pending_->movement, -kLongestMove, kLongestMove);
    const int moved = movement < 0 ? reading - sight.front : std::min(movement, reading);
    pose_.cell = ahead(pose_.cell, pose_.heading, moved);
  }
  pending_.reset();
  sight_ = sight;
}

}  // namespace taut::micromouse
