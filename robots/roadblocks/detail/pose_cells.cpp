#include <taut/robots/roadblocks/detail/pose_cells.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <numbers>
#include <utility>

namespace taut::roadblocks::detail {

namespace {

constexpr int kCells = PoseCells::kCells;
constexpr int kHeadings = PoseCells::kHeadings;
constexpr int kReach = 3 * kCells;  // cells from a closed one's centre to where the car might touch it, and more
constexpr double kTurnOfCell = std::numbers::pi / kHeadings;  // from a cell's middle to its edge
constexpr double kHalfCell = 0.5 / kCells;
constexpr double kRounding = 1e-9;

constexpr int kStep = 3;  // cells, more than a step

/// A cell's middle.
double heading(int h) { return 2 * std::numbers::pi / kHeadings * (h + 0.5); }

/// How much smaller a rectangle is that lies in the rectangles of all poses of a cell, or larger that holds all of
/// them.
Point change(double angle) {
  const double shift =
      kHalfCell * (std::abs(std::cos(angle)) + std::abs(std::sin(angle))) * (1 + kTurnOfCell) + kRounding;
  return {shift + kHalfWidth * kTurnOfCell, shift + kHalfLength * kTurnOfCell};
}

/// Does the rectangle of these half sizes around the origin touch the point, or the unit square around it?
bool touches(Point half, double angle, Point p, WallReading reading) {
  const double c = std::abs(std::cos(angle)), s = std::abs(std::sin(angle));
  const double along = std::abs(std::cos(angle) * p.x + std::sin(angle) * p.y);
  const double across = std::abs(std::cos(angle) * p.y - std::sin(angle) * p.x);
  if (reading == WallReading::points) return along <= half.x && across <= half.y;
  return along <= half.x + 0.5 * (c + s) && across <= half.y + 0.5 * (c + s) &&
         std::abs(p.x) <= 0.5 + half.x * c + half.y * s && std::abs(p.y) <= 0.5 + half.x * s + half.y * c;
}

/// For a closed cell so many cells away: the headings in which all poses collide.
class Masks {
 public:
  explicit Masks(WallReading reading) {
    masks_.reserve(4 * kReach * kReach);
    for (int j = -kReach; j < kReach; ++j)
      for (int i = -kReach; i < kReach; ++i) masks_.push_back(headings({offset(i), offset(j)}, reading));
  }
  const PoseCells::Bits& at(int i, int j) const {
    return masks_[static_cast<std::size_t>((j + kReach) * 2 * kReach + i + kReach)];
  }

 private:
  static double offset(int i) { return (i + 0.5) / kCells; }

  static PoseCells::Bits headings(Point middle, WallReading reading) {
    PoseCells::Bits bits;
    if (std::hypot(middle.x, middle.y) > 2.6) return bits;
    for (int h = 0; h < kHeadings; ++h) {
      const Point less = change(heading(h));
      if (touches({kHalfLength - less.x, kHalfWidth - less.y}, heading(h), {-middle.x, -middle.y}, reading))
        bits.set(h);
    }
    return bits;
  }

  std::vector<PoseCells::Bits> masks_;
};

/// To a neighbour: for which headings there is a step.
struct Offset {
  int i, j;
  PoseCells::Bits headings;
};

std::vector<Offset> offsets() {
  std::vector<Offset> all;
  for (int j = -4; j <= 4; ++j)
    for (int i = -4; i <= 4; ++i) {
      Offset offset{i, j, {}};
      for (int h = 0; h < kHeadings; ++h)
        for (const double way : {kForward, -kForward, kBackward, -kBackward}) {
          // The chord's direction is off the cell's middle by half the cell and half the turn; from cell to cell it may
          // begin and end anywhere.
          const double play = 1 + std::abs(way) * kCells * (kTurnOfCell + kTurn) + kRounding;
          if (std::abs(way * kCells * std::cos(heading(h)) - i) <= play &&
              std::abs(way * kCells * std::sin(heading(h)) - j) <= play)
            offset.headings.set(h);
        }
      if (offset.headings.any()) all.push_back(offset);
    }
  return all;
}

/// The headings on both sides of 0 and a half turn, or of the quarter turns between.
struct Sides {
  explicit Sides(int first) {
    for (const int h : {first, first + kHeadings / 2}) {
      above.set(h);
      below.set((h + kHeadings - 1) % kHeadings);
    }
  }
  PoseCells::Bits above, below;
};

/// Each cell's bits with those of all cells at most kStep away.
std::vector<std::uint8_t> widest(const std::vector<std::uint8_t>& bits, int columns, int rows) {
  std::vector<std::uint8_t> along = bits, all;
  const auto spread = [](const std::vector<std::uint8_t>& from, std::vector<std::uint8_t>& to, std::size_t cell,
                         int place, int places, std::ptrdiff_t stride) {
    for (int k = -std::min(kStep, place); k <= std::min(kStep, places - 1 - place); ++k)
      to[cell] |= from[static_cast<std::size_t>(static_cast<std::ptrdiff_t>(cell) + k * stride)];
  };
  for (std::size_t cell = 0; cell < bits.size(); ++cell)
    spread(bits, along, cell, static_cast<int>(cell) % columns, columns, 1);
  all = along;
  for (std::size_t cell = 0; cell < bits.size(); ++cell)
    spread(along, all, cell, static_cast<int>(cell) / columns, rows, columns);
  return all;
}

}  // namespace

PoseCells::PoseCells(const Obstacles& obstacles, Point goal)
    : columns_((obstacles.course().width + 2 * kBeyond) * kCells),
      rows_((obstacles.course().height + 2 * kBeyond) * kCells) {
  open_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), Bits::all());
  reached_.resize(open_.size());
  close(obstacles);
  close_gates(obstacles);
  find_quarters(obstacles);
  spread(goal);
  open_ = {};  // half of the memory
  quarters_ = {};
}

int PoseCells::index(double v) const { return static_cast<int>(std::floor((v - 0.5 + kBeyond) * kCells)); }

void PoseCells::close(const Obstacles& obstacles) {
  const Masks masks(obstacles.reading());
  const Course& course = obstacles.course();
  for (int y = 1; y <= course.height; ++y)
    for (int x = 1; x <= course.width; ++x) {
      if (!obstacles.is_closed({x, y})) continue;
      const int left = index(x), top = index(y);  // the cell that begins at the centre
      for (int j = -kReach; j < kReach; ++j)
        for (int i = -kReach; i < kReach; ++i) {
          Bits& bits = open_[at(left + i, top + j)];
          bits = bits.without(masks.at(i, j));
        }
    }
}

void PoseCells::close_gates(const Obstacles& obstacles) {
  obstacles.each_gate([&](const Box& band) {
    for (int j = index(band.min.y); j < index(band.max.y); ++j)
      for (int i = index(band.min.x); i < index(band.max.x); ++i) open_[at(i, j)] = {};
  });
}

void PoseCells::find_quarters(const Obstacles& obstacles) {
  quarters_.assign(open_.size(), 3);
  if (obstacles.reading() == WallReading::points) return;
  std::vector<std::uint8_t> free(open_.size(), 3);
  const Course& course = obstacles.course();
  const auto shut = [&](Cell c, double half_x, double half_y, int bit) {
    for (int j = index(c.y - 0.5 - half_y); j < index(c.y + 0.5 + half_y); ++j)
      for (int i = index(c.x - 0.5 - half_x); i < index(c.x + 0.5 + half_x); ++i)
        free[at(i, j)] &= static_cast<std::uint8_t>(~bit);
  };
  for (int y = 1; y <= course.height; ++y)
    for (int x = 1; x <= course.width; ++x)
      if (obstacles.is_closed({x, y})) {
        shut({x, y}, kHalfLength, kHalfWidth, 1);
        shut({x, y}, kHalfWidth, kHalfLength, 2);
      }
  quarters_ = widest(free, columns_, rows_);
}

PoseCells::Bits PoseCells::wider(std::size_t cell, const Bits& bits) const {
  static const Sides kHalves(0), kQuarters(kHeadings / 4);
  Bits rising = bits, falling = bits;
  if (!(quarters_[cell] & 1)) rising = rising.without(kHalves.below), falling = falling.without(kHalves.above);
  if (!(quarters_[cell] & 2)) rising = rising.without(kQuarters.below), falling = falling.without(kQuarters.above);
  return bits | rising.up() | falling.down();
}

void PoseCells::spread(Point goal) {
  std::deque<std::pair<int, int>> changed;
  std::vector<Bits> fresh(open_.size());
  const auto reach = [&](int i, int j, const Bits& bits) {
    const std::size_t cell = at(i, j);
    const Bits more = bits & open_[cell];
    if (!more.any()) return;
    open_[cell] = open_[cell].without(more);
    reached_[cell] = reached_[cell] | more;
    if (!fresh[cell].any()) changed.emplace_back(i, j);
    fresh[cell] = fresh[cell] | more;
  };
  for (int j = index(goal.y) - kReach; j <= index(goal.y) + kReach; ++j)
    for (int i = index(goal.x) - kReach; i <= index(goal.x) + kReach; ++i) {
      if (i < 0 || j < 0 || i >= columns_ || j >= rows_) continue;
      const Point to_goal{goal.x - ((i + 0.5) / kCells + 0.5 - kBeyond), goal.y - ((j + 0.5) / kCells + 0.5 - kBeyond)};
      Bits bits;
      for (int h = 0; h < kHeadings; ++h) {
        const Point more = change(heading(h));
        if (touches({kHalfLength + more.x, kHalfWidth + more.y}, heading(h), to_goal, WallReading::points)) bits.set(h);
      }
      reach(i, j, bits);
    }
  const std::vector<Offset> neighbours = offsets();
  for (; !changed.empty(); changed.pop_front()) {
    const auto [i, j] = changed.front();
    const Bits bits = std::exchange(fresh[at(i, j)], {});
    for (const Offset& to : neighbours) {
      const int x = i + to.i, y = j + to.j;
      if (x < 0 || y < 0 || x >= columns_ || y >= rows_) continue;
      const Bits steps = bits & to.headings;
      if (steps.any()) reach(x, y, wider(at(i, j), steps));
    }
  }
}

bool PoseCells::reaches(const Pose& pose) const {
  const int i = index(pose.x), j = index(pose.y);
  if (i < 0 || j < 0 || i >= columns_ || j >= rows_) return true;
  const auto reached = [&](double heading) {
    const auto h = static_cast<long>(std::floor(heading / (2 * kTurnOfCell)));
    return reached_[at(i, j)].has(static_cast<int>((h % kHeadings + kHeadings) % kHeadings));
  };
  return reached(pose.heading - kRounding) || reached(pose.heading + kRounding);
}

}  // namespace taut::roadblocks::detail
