#include <taut/geometry/maze_generator.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include <taut/geometry/draws.h>
#include <taut/geometry/errors.h>
#include <taut/geometry/text.h>

namespace taut {

namespace {

constexpr int kLargestSide = 20000;

void admit_size(int width, int height) {
  if (std::min(width, height) >= 1 && std::max(width, height) <= kLargestSide) return;
  throw InputError("", 0,
                   "maze of " + std::to_string(height) + " rows and " + std::to_string(width) +
                       " columns: both must be between 1 and " + std::to_string(kLargestSide));
}

// Disjoint regions of cells, named by their smallest id, where membership of region 0 is one look.
class Regions {
 public:
  explicit Regions(std::uint32_t n) : parent_(n), next_(n), first_(n), outside_(n - 1) {
    std::iota(parent_.begin(), parent_.end(), 0U);
    std::iota(next_.begin(), next_.end(), 0U);
    first_[0] = 1;
  }

  bool in_first(std::uint32_t id) const { return first_[id] != 0; }
  bool all_in_first() const { return outside_ == 0; }

  std::uint32_t find(std::uint32_t id) {
    while (parent_[id] != id) id = parent_[id] = parent_[parent_[id]];
    return id;
  }

  void join(std::uint32_t a, std::uint32_t b) {
    a = find(a), b = find(b);
    if (a > b) std::swap(a, b);
    parent_[b] = a;
    if (a == 0) absorb(b);
    std::swap(next_[a], next_[b]);
  }

 private:
  void absorb(std::uint32_t region) {
    std::uint32_t id = region;
    do {
      first_[id] = 1;
      parent_[id] = 0;
      --outside_;
      id = next_[id];
    } while (id != region);
  }

  std::vector<std::uint32_t> parent_;
  std::vector<std::uint32_t> next_;  // circular list of a region's cells
  std::vector<std::uint8_t> first_;
  std::uint32_t outside_;  // cells not in region 0
};

class BiasedMaze {
 public:
  BiasedMaze(int rows, int cols, std::uint64_t seed)
      : rows_(rows),
        cols_(cols),
        cells_(static_cast<std::uint32_t>(rows) * static_cast<std::uint32_t>(cols)),
        draws_(seed),
        regions_(cells_),
        maze_(cols, rows, true) {
    const int shorter = std::min(rows, cols);
    int blocks = 3;
    while (shorter > kLargestBlock * blocks) blocks += 2;
    block_row_ = blocks_of(rows, blocks, shorter);
    block_col_ = blocks_of(cols, blocks, shorter);
  }

  GridMaze grow() {
    while (!regions_.all_in_first()) step();
    maze_.set_wall({0, 0}, Side::west, false);
    maze_.set_wall({cols_ - 1, rows_ - 1}, Side::east, false);
    return std::move(maze_);
  }

 private:
  static constexpr int kDraws = 15;
  static constexpr int kLargestBlock = 12;

  // ceil(line / side) for the lines 1 .. n, with side = shorter / blocks.
  static std::vector<int> blocks_of(int n, int blocks, int shorter) {
    std::vector<int> result;
    for (int line = 1; line <= n; ++line) result.push_back((line * blocks + shorter - 1) / shorter);
    return result;
  }

  void step() {
    const std::uint32_t id = choose();
    const auto rows = static_cast<std::uint32_t>(rows_);
    const Cell cell{static_cast<int>(id / rows), static_cast<int>(id % rows)};
    const Side side = direction(cell);
    const Cell other = GridMaze::neighbour(cell, side);
    if (!maze_.contains(other) || !maze_.wall(cell, side)) return;
    const auto other_id = static_cast<std::uint32_t>(other.x) * rows + static_cast<std::uint32_t>(other.y);
    if (regions_.find(id) == regions_.find(other_id)) return;
    regions_.join(id, other_id);
    maze_.set_wall(cell, side, false);
  }

  // Ids run down the columns: id = row + col * rows, both from 0.
  std::uint32_t choose() {
    std::array<std::uint32_t, kDraws> drawn;
    for (std::uint32_t& id : drawn) id = draws_.below(cells_);
    std::uint32_t best = drawn[0];
    std::uint32_t least = ~0U;
    for (std::uint32_t id : drawn) {
      if (regions_.in_first(id)) continue;
      const auto rows = static_cast<std::uint32_t>(rows_);
      const std::uint32_t sum = id / rows + id % rows;
      if (sum < least) best = id, least = sum;
    }
    return best;
  }

  Side direction(Cell cell) {
    const int row = block_row_[static_cast<std::size_t>(cell.y)], col = block_col_[static_cast<std::size_t>(cell.x)];
    const bool even = (row * col + col) % 2 == 0;
    std::uint32_t d = 1 + draws_.below(8);
    if (d > 6) d = even ? 4 : 2;
    if (d > 4) d = even ? 3 : 1;
    constexpr std::array sides{Side::west, Side::east, Side::south, Side::north};  // left, right, row - 1, row + 1
    return sides[d - 1];
  }

  int rows_;
  int cols_;
  std::uint32_t cells_;
  Draws draws_;
  Regions regions_;
  GridMaze maze_;
  std::vector<int> block_row_;
  std::vector<int> block_col_;
};

}  // namespace

GridMaze generate_biased_maze(int rows, int cols, std::uint64_t seed) {
  admit_size(cols, rows);
  return BiasedMaze(rows, cols, seed).grow();
}

GridMaze generate_backtracker(int width, int height, std::uint64_t seed) {
  admit_size(width, height);
  GridMaze maze(width, height, true);
  maze.goal = {{width - 1, height - 1}};
  const auto w = static_cast<std::size_t>(width);
  const auto id = [&](Cell c) { return static_cast<std::size_t>(c.y) * w + static_cast<std::size_t>(c.x); };
  std::vector<bool> visited(w * static_cast<std::size_t>(height));
  std::vector<Side> came;  // the way from the start to `here`
  Draws draws(seed);
  Cell here{0, 0};
  visited[0] = true;
  for (;;) {
    std::array<Side, 4> fresh{};
    std::uint32_t count = 0;
    for (Side side : kSides) {
      const Cell next = GridMaze::neighbour(here, side);
      if (maze.contains(next) && !visited[id(next)]) fresh[count++] = side;
    }
    if (count > 0) {
      const Side side = fresh[count == 1 ? 0 : draws.below(count)];
      maze.set_wall(here, side, false);
      here = GridMaze::neighbour(here, side);
      visited[id(here)] = true;
      came.push_back(side);
    } else if (!came.empty()) {
      here = GridMaze::neighbour(here, kSides[(static_cast<std::size_t>(came.back()) + 2) % 4]);
      came.pop_back();
    } else {
      return maze;
    }
  }
}

namespace {

template <class Visit>
void for_each_interior_wall(const GridMaze& maze, Visit visit) {
  for (int y = 0; y < maze.height(); ++y)
    for (int x = 0; x < maze.width(); ++x)
      for (Side side : {Side::north, Side::east})
        if (maze.contains(GridMaze::neighbour({x, y}, side)) && maze.wall({x, y}, side)) visit(Cell{x, y}, side);
}

}  // namespace

void open_walls(GridMaze& maze, double share, std::uint64_t seed) {
  if (!(share >= 0 && share <= 1))
    throw InputError("", 0, "share of walls to open is " + text(share) + ", not between 0 and 1");
  std::uint32_t left = 0;
  for_each_interior_wall(maze, [&](Cell, Side) { ++left; });
  auto wanted = static_cast<std::uint32_t>(std::llround(share * left));
  Draws draws(seed);
  // Selection sampling (Knuth, TAOCP 2, 3.4.2, algorithm S).
  for_each_interior_wall(maze, [&](Cell cell, Side side) {
    if (draws.below(left--) >= wanted) return;
    maze.set_wall(cell, side, false);
    --wanted;
  });
}

void open_centre_room(GridMaze& maze) {
  maze.goal = centre_room(maze.width(), maze.height());
  for (const Cell c : maze.goal)
    for (const Side side : kSides) {
      const Cell n = GridMaze::neighbour(c, side);
      if (std::find(maze.goal.begin(), maze.goal.end(), n) != maze.goal.end()) maze.set_wall(c, side, false);
    }
}

}  // namespace taut
