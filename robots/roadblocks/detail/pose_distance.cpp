#include <taut/robots/roadblocks/detail/pose_distance.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

namespace taut::roadblocks::detail {

namespace {

constexpr int kParts = StepTable::kParts;
constexpr int kHeadings = PoseDistance::kTableHeadings;
constexpr double kUnit = 2 * std::numbers::pi / kHeadings;
constexpr double kArc = kUnit / kTurn;              // steps of an arc to the next heading
constexpr std::int32_t kNever = StepTable::kNever;  // and what costs more, 16 thousand steps

constexpr double kMostLost = 0.1;    // of all states: beyond that a repair takes longer than a new search
constexpr int kTouch = 3 * kRaster;  // raster cells from a closed cell to where the car may touch it, and more
constexpr int kFarthest = 5;         // raster cells that a move spans

int wrapped(int heading) { return (heading + kHeadings) % kHeadings; }

/// Around a closed cell, kTouch raster cells to all sides: the headings in which a car there, smaller by kTableSlack,
/// touches it.
using Touches = std::array<std::uint32_t, static_cast<std::size_t>((2 * kTouch + 1) * (2 * kTouch + 1))>;

Touches touches_around(WallReading reading) {
  Touches all{};
  std::size_t k = 0;
  for (int j = -kTouch; j <= kTouch; ++j)
    for (int i = -kTouch; i <= kTouch; ++i, ++k)
      for (int h = 0; h < kHeadings; ++h)
        if (touches({(i + 0.5) / kRaster, (j + 0.5) / kRaster, h * kUnit}, Cell{0, 0}, reading,
                    -PoseDistance::kTableSlack))
          all[k] |= 1U << h;
  return all;
}

const Touches& touches_of(WallReading reading) {
  static const Touches kPoints = touches_around(WallReading::points), kSquares = touches_around(WallReading::squares);
  return reading == WallReading::points ? kPoints : kSquares;
}

/// Short raster vectors close to the headings of the first eighth.
constexpr std::array<std::array<int, 2>, 5> kAhead{{{1, 0}, {5, 1}, {5, 2}, {3, 2}, {1, 1}}};

std::array<int, 2> ahead(int heading) {
  const int quarter = heading / (kHeadings / 4), rest = heading % (kHeadings / 4);
  auto [x, y] = kAhead[static_cast<std::size_t>(std::min(rest, kHeadings / 4 - rest))];
  if (rest > kHeadings / 8) std::swap(x, y);
  for (int i = 0; i < quarter; ++i) {
    std::swap(x, y);
    x = -x;
  }
  return {x, y};
}

}  // namespace

PoseDistance::PoseDistance(const Obstacles& obstacles, const DiscDistance& disc, Point goal)
    : columns_(obstacles.course().width * kRaster), rows_(obstacles.course().height * kRaster) {
  lay_moves();
  for (int j = 0; j < rows_; ++j)
    for (int i = 0; i < columns_; ++i) free_.push_back(disc.reaches({middle(i), middle(j)}) ? ~0U : 0);
  const Course& course = obstacles.course();
  for (int y = 1; y <= course.height; ++y)
    for (int x = 1; x <= course.width; ++x)
      if (obstacles.is_closed({x, y})) close({x, y}, obstacles.reading());
  entries_.resize(free_.size() * kHeadings);
  for (std::size_t s = 0; s < entries_.size(); ++s) entries_[s] = entries(static_cast<State>(s));
  search(goal);
}

void PoseDistance::search(Point goal) {
  cost_.assign(entries_.size(), kNever);
  CostQueue queue;
  for (int j = std::max(0, raster(goal.y - 2)); j <= std::min(rows_ - 1, raster(goal.y + 2)); ++j)
    for (int i = std::max(0, raster(goal.x - 2)); i <= std::min(columns_ - 1, raster(goal.x + 2)); ++i)
      for (int h = 0; h < kHeadings; ++h) {
        const State s = static_cast<State>((j * columns_ + i) * kHeadings + h);
        if (!is_free(s) || !covers({middle(i), middle(j), h * kUnit}, goal, 0.5 / kRaster)) continue;
        cost_[s] = 0;
        queue.seed(0, s);
      }
  spread(queue);
  settled_ = static_cast<std::size_t>(std::ranges::count_if(cost_, [](std::int32_t cost) { return cost != kNever; }));
}

void PoseDistance::lay_moves() {
  const auto add = [&](int h, double dx, double dy, int turn, double cost) {
    const int x = static_cast<int>(std::lround(dx)), y = static_cast<int>(std::lround(dy));
    const double way = std::hypot(dx, dy), rounded = std::hypot(x, y);
    const double scale = way == 0 ? 1 : rounded / way;  // no speed is gained by rounding
    Move move{x, y, turn, std::max(1, static_cast<int>(std::lround(cost * scale * kParts))), 0, 0, {}};
    for (int k = 1, n = std::max(std::abs(x), std::abs(y)); k < n; ++k)
      move.between.push_back({static_cast<int>(std::lround(1.0 * k * x / n)),
                              static_cast<int>(std::lround(1.0 * k * y / n)), 2 * k > n ? turn : 0});
    move.by = (y * columns_ + x) * kHeadings + wrapped(h + turn) - h;
    std::vector<Move>& into = moves_into_[static_cast<std::size_t>(wrapped(h + turn))];
    move.entry = into.size();
    moves_[static_cast<std::size_t>(h)].push_back(move);
    into.push_back(move);
  };
  const double chord = 2 * (kForward / kTurn) * std::sin(kUnit / 2) * kRaster;
  for (int h = 0; h < kHeadings; ++h) {
    const auto [x, y] = ahead(h);
    const double steps = std::hypot(x, y) / kRaster / kForward;
    add(h, x, y, 0, steps);
    add(h, -x, -y, 0, steps * kForward / kBackward);
    for (const int turn : {1, -1}) {
      const double middle_of_arc = (h + 0.5 * turn) * kUnit, dx = chord * std::cos(middle_of_arc),
                   dy = chord * std::sin(middle_of_arc);
      add(h, dx, dy, turn, kArc);
      add(h, 0, 0, turn, 4 * kArc);
      add(h, -dx, -dy, turn, 7 * kArc);
    }
  }
}

template <typename Visit>
void PoseDistance::each_cell_around(int i, int j, int reach, Visit visit) const {
  for (int y = std::max(0, j - reach); y <= std::min(rows_ - 1, j + reach); ++y)
    for (int x = std::max(0, i - reach); x <= std::min(columns_ - 1, i + reach); ++x) visit(x, y);
}

/// Takes the headings in which the car touches the cell.
void PoseDistance::close(Cell cell, WallReading reading) {
  const Touches& touches = touches_of(reading);
  each_cell_around(raster(cell.x), raster(cell.y), kTouch, [&](int i, int j) {
    free_[at(i, j)] &= ~touches[static_cast<std::size_t>((j - raster(cell.y) + kTouch) * (2 * kTouch + 1) + i -
                                                         raster(cell.x) + kTouch)];
  });
}

/// From and to are in the raster, hence what lies between.
bool PoseDistance::is_passable(int i, int j, int h, const Move& move) const {
  return std::ranges::all_of(move.between, [&](const std::array<int, 3>& by) {
    return (free_[static_cast<std::size_t>((j + by[1]) * columns_ + i + by[0])] >> wrapped(h + by[2])) & 1;
  });
}

std::uint8_t PoseDistance::entries(State s) const {
  std::uint8_t bits = 0;
  if (!is_free(s)) return bits;
  const int cell = static_cast<int>(s / kHeadings), i = cell % columns_, j = cell / columns_;
  const int h = static_cast<int>(s % kHeadings);
  for (const Move& m : moves_into_[static_cast<std::size_t>(h)]) {
    const int x = i - m.dx, y = j - m.dy;
    if (x < 0 || y < 0 || x >= columns_ || y >= rows_) continue;
    if (is_free(s - static_cast<State>(m.by)) && is_passable(x, y, wrapped(h - m.turn), m))
      bits |= static_cast<std::uint8_t>(1U << m.entry);
  }
  return bits;
}

template <typename Visit>
void PoseDistance::each_before(State s, Visit visit) const {
  const Move* into = moves_into_[s % kHeadings].data();
  for (unsigned bits = entries_[s]; bits != 0; bits &= bits - 1) {
    const Move& m = into[std::countr_zero(bits)];
    visit(s - static_cast<State>(m.by), m.cost);
  }
}

template <typename Visit>
void PoseDistance::each_after(State s, Visit visit) const {
  for (const Move& m : moves_[s % kHeadings]) {
    const State after = s + static_cast<State>(m.by);  // beyond a border it has no such entry
    if (after < entries_.size() && (entries_[after] >> m.entry) & 1) visit(after, m.cost);
  }
}

void PoseDistance::spread(CostQueue& queue) {
  queue.run([&](std::int32_t cost, State s) {
    if (cost_[s] != cost) return;
    each_before(s, [&](State before, int by) {
      if (cost + by >= cost_[before]) return;
      cost_[before] = static_cast<std::uint16_t>(cost + by);
      queue.push(cost + by, before);
    });
  });
}

PoseDistance::PoseDistance(const PoseDistance& before, const Obstacles& before_obstacles, const Obstacles& obstacles,
                           const DiscDistance& disc)
    : PoseDistance(before) {
  CostQueue queue;
  shut(before_obstacles, obstacles, disc, queue);
  const std::vector<State> lost = unsettle(queue, before.cost_);
  if (static_cast<double>(lost.size()) > kMostLost * static_cast<double>(settled_)) {
    search(obstacles.course().goal);
    return;
  }
  CostQueue again;
  for (const State s : lost) {
    std::int32_t best = kNever;
    each_after(s, [&](State after, int by) {
      if (cost_[after] != kNever) best = std::min<std::int32_t>(best, cost_[after] + by);
    });
    if (best != kNever) again.seed(best, s);
  }
  again.each_seed([&](std::int32_t cost, State s) { cost_[s] = static_cast<std::uint16_t>(cost); });
  spread(again);
}

/// By old costs: when a state is looked at, all that it could lean on is decided.
std::vector<PoseDistance::State> PoseDistance::unsettle(CostQueue& queue, const std::vector<std::uint16_t>& old) {
  std::vector<State> lost;
  const auto most = static_cast<std::size_t>(kMostLost * static_cast<double>(settled_));
  queue.run([&](std::int32_t cost, State s) {
    if (cost_[s] == kNever) return;
    if (lost.size() > most) return queue.stop();
    if (is_free(s)) {
      bool leans = cost == 0;
      each_after(s, [&](State after, int by) { leans = leans || (cost_[after] != kNever && old[after] + by == cost); });
      if (leans) return;
      lost.push_back(s);
    }
    cost_[s] = kNever;
    each_before(s, [&](State b, int by) {
      if (cost_[b] != kNever && old[b] == cost + by) queue.push(cost + by, b);
    });
  });
  return lost;
}

/// Takes the new closed cells' poses from what is free, and the moves that are lost; seeds the states that leant on
/// one.
void PoseDistance::shut(const Obstacles& before, const Obstacles& obstacles, const DiscDistance& disc,
                        CostQueue& queue) {
  const std::vector<std::uint32_t> were = free_;
  const Course& course = obstacles.course();
  for (int y = 1; y <= course.height; ++y)
    for (int x = 1; x <= course.width; ++x)
      if (obstacles.is_closed({x, y}) && !before.is_closed({x, y})) close({x, y}, obstacles.reading());
  std::vector<std::uint8_t> near(free_.size());
  for (int j = 0; j < rows_; ++j)
    for (int i = 0; i < columns_; ++i) {
      if (were[at(i, j)] == 0) continue;
      if (!disc.reaches({middle(i), middle(j)})) free_[at(i, j)] = 0;
      if (free_[at(i, j)] != were[at(i, j)])
        each_cell_around(i, j, kFarthest, [&](int x, int y) { near[at(x, y)] = 1; });
    }
  const auto lose = [&](State s) {
    if (entries_[s] == 0) return;
    const std::uint8_t left = entries(s), lost = entries_[s] & static_cast<std::uint8_t>(~left);
    entries_[s] = left;
    if (cost_[s] == kNever) return;
    if (cost_[s] == 0 && !is_free(s)) queue.seed(0, s);
    for (const Move& m : moves_into_[s % kHeadings])
      if (const State from = s - static_cast<State>(m.by); (lost >> m.entry) & 1 && cost_[from] == cost_[s] + m.cost)
        queue.seed(cost_[from], from);
  };
  for (std::size_t cell = 0; cell < near.size(); ++cell)
    for (std::size_t s = cell * kHeadings; near[cell] && s < (cell + 1) * kHeadings; ++s) lose(static_cast<State>(s));
}

double PoseDistance::steps_from(const Pose& pose) const {
  const int i = raster(pose.x), j = raster(pose.y);
  if (i < 0 || j < 0 || i >= columns_ || j >= rows_) return kFar;
  const std::size_t cell = static_cast<std::size_t>(j * columns_ + i) * kHeadings;
  return steps_between(pose.heading, [&](int h) { return cost_[cell + static_cast<std::size_t>(h)]; });
}

}  // namespace taut::roadblocks::detail
