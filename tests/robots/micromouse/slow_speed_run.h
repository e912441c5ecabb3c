// A second search for speed runs, which knows turns only as curves, and a second integrator for their times.
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <tuple>
#include <vector>

#include <taut/geometry/grid_maze.h>
#include <taut/robots/micromouse/rules.h>
#include <taut/robots/micromouse/speed_run.h>

namespace taut::micromouse {

inline constexpr double kPi = std::numbers::pi, kRoot = std::numbers::sqrt2;

/// The speed over the way as the lower of what can be reached from the begin and what still stops for the end, on a
/// fine grid.
inline std::optional<double> integrated_seconds(const Ramp& ramp, double from, double to, double metres) {
  constexpr int kSlices = 4000;
  std::vector<double> v(kSlices + 1, ramp.top_speed);
  const double dx = metres / kSlices;
  v.front() = from;
  for (std::size_t i = 1; i < v.size(); ++i)
    v[i] = std::min(v[i], std::sqrt(v[i - 1] * v[i - 1] + 2 * ramp.acceleration * dx));
  if (v.back() < to - 1e-9) return std::nullopt;
  v.back() = to;
  for (std::size_t i = v.size() - 1; i-- > 0;)
    v[i] = std::min(v[i], std::sqrt(v[i + 1] * v[i + 1] + 2 * ramp.deceleration * dx));
  if (v.front() < from - 1e-9) return std::nullopt;
  double seconds = 0;
  for (std::size_t i = 1; i < v.size() && metres > 0; ++i) seconds += 2 * dx / (v[i - 1] + v[i]);
  return seconds;
}

/// A turn as a curve: a lead, an arc, a tail, in half cells.
struct Curve {
  Turn turn;
  double lead, radius, angle, tail;
  bool orthogonal;  // at its begin
};

inline const std::vector<Curve>& curves() {
  static const std::vector<Curve> all{
      {Turn::small_90, 0, 1, kPi / 2, 0, true},
      {Turn::large_90, 0, 2, kPi / 2, 0, true},
      {Turn::turn_45, 0, 1 + kRoot, kPi / 4, kRoot - 1, true},
      {Turn::turn_45, kRoot - 1, 1 + kRoot, kPi / 4, 0, false},
      {Turn::turn_135, 3 - kRoot, 2 - kRoot, 3 * kPi / 4, 0, true},
      {Turn::turn_135, 0, 2 - kRoot, 3 * kPi / 4, 3 - kRoot, false},
      {Turn::turn_180, 1, 1, kPi, 1, true},
      {Turn::diagonal_90, 0, kRoot, kPi / 2, 0, false},
  };
  return all;
}

struct Pen {
  double x, y, direction;  // radians clockwise from north
  void draw(double way, double bend, std::vector<Point>& line) {
    constexpr int kPieces = 60;
    for (int i = 0; i < kPieces && way > 0; ++i) {
      direction += bend / kPieces / 2;
      const double chord =
          bend == 0 ? way / kPieces : 2 * (way / std::abs(bend)) * std::sin(std::abs(bend) / kPieces / 2);
      x += chord * std::sin(direction), y += chord * std::cos(direction);
      direction += bend / kPieces / 2;
      line.push_back({x, y});
    }
  }
};

/// In half cells.
inline std::vector<Point> drawn(const Curve& c, Spot from, int heading, int side) {
  Pen pen{static_cast<double>(from.x), static_cast<double>(from.y), heading * kPi / 4};
  std::vector<Point> line{{pen.x, pen.y}};
  pen.draw(c.lead, 0, line);
  pen.draw(c.radius * c.angle, side * c.angle, line);
  pen.draw(c.tail, 0, line);
  return line;
}

inline Cell cell_of(Point p) { return {static_cast<int>(std::floor(p.x / 2)), static_cast<int>(std::floor(p.y / 2))}; }

inline bool on_wall_line(Point p) {
  return std::abs(p.x - 2 * std::round(p.x / 2)) < 1e-6 || std::abs(p.y - 2 * std::round(p.y / 2)) < 1e-6;
}

/// The cells a curve passes through; nothing when it meets a wall or leaves the maze.
inline std::optional<std::vector<Cell>> passed(const GridMaze& maze, const std::vector<Point>& line) {
  std::vector<Cell> cells;
  for (const Point p : line) {
    if (on_wall_line(p)) continue;
    const Cell c = cell_of(p);
    if (!maze.contains(c)) return std::nullopt;
    if (!cells.empty() && cells.back() == c) continue;
    if (!cells.empty()) {
      const int dx = c.x - cells.back().x, dy = c.y - cells.back().y;
      if (std::abs(dx) + std::abs(dy) != 1) return std::nullopt;
      const Side side = dx > 0 ? Side::east : dx < 0 ? Side::west : dy > 0 ? Side::north : Side::south;
      if (maze.wall(cells.back(), side)) return std::nullopt;
    }
    cells.push_back(c);
  }
  return cells;
}

inline bool is_open(const GridMaze& maze, Spot s) {
  if (s.x <= 0 || s.y <= 0 || s.x >= 2 * maze.width() || s.y >= 2 * maze.height()) return false;
  if (s.x % 2 == 0) return !maze.wall({s.x / 2 - 1, s.y / 2}, Side::east);
  if (s.y % 2 == 0) return !maze.wall({s.x / 2, s.y / 2 - 1}, Side::north);
  return true;
}

/// Relaxes every state until nothing changes.
class SlowSearch {
 public:
  SlowSearch(const GridMaze& maze, const SpeedModel& model) : maze_(maze), model_(model) {}

  std::optional<double> seconds() {
    const Task task = task_of(maze_);
    best_[{2 * task.start.x + 1, 2 * task.start.y + 1, 0, -1}] = 0;
    do {
      changed_ = false;
      const auto now = best_;
      for (const auto& [state, time] : now) relax(state, time);
    } while (changed_);
    std::optional<double> least;
    for (const auto& [state, time] : best_) {
      const auto [x, y, heading, kind] = state;
      if (kind == -1 && x % 2 == 1 && y % 2 == 1 && task.in_goal({x / 2, y / 2}))
        least = std::min(least.value_or(time), time);
    }
    return least;
  }

 private:
  using State = std::tuple<int, int, int, int>;  // x, y, heading, kind: -1 standing

  void improve(const State& state, double time) {
    const auto [at, fresh] = best_.try_emplace(state, time);
    if (!fresh && at->second <= time) return;
    at->second = time;
    changed_ = true;
  }

  std::optional<double> straight(bool diagonal, int count, double from, double to) {
    const auto [at, fresh] = known_.try_emplace({diagonal, count, from, to});
    if (fresh)
      at->second = integrated_seconds(diagonal ? model_.diagonal : model_.straight, from, to,
                                      count * model_.cell / 2 * (diagonal ? kRoot : 1));
    return at->second;
  }

  void relax(const State& state, double time) {
    const auto [x, y, heading, kind] = state;
    const double speed = kind < 0 ? 0 : model_.turns[static_cast<std::size_t>(kind)].speed;
    if (kind < 0)
      for (const int by : {2, 4, 6})
        improve({x, y, (heading + by) % 8, -1}, time + (by == 4 ? model_.pivot_180 : model_.pivot_90));
    constexpr int kX[] = {0, 1, 1, 1, 0, -1, -1, -1}, kY[] = {1, 1, 0, -1, -1, -1, 0, 1};
    const bool diagonal = heading % 2 == 1;
    for (int count = 0;; ++count) {
      const Spot at{x + count * kX[heading], y + count * kY[heading]};
      if (count > 0 && !is_open(maze_, at)) return;
      const bool in_middle = at.x % 2 == 1 && at.y % 2 == 1;
      if (in_middle && count > 0)
        if (const auto t = straight(diagonal, count, speed, 0)) improve({at.x, at.y, heading, -1}, time + *t);
      for (const Curve& c : curves())
        if (c.orthogonal != diagonal && in_middle == begins_in_middle(c))
          for (const int side : {-1, 1}) turn(c, at, heading, side, diagonal, count, speed, time);
    }
  }

  static bool begins_in_middle(const Curve& c) { return c.orthogonal && c.turn != Turn::small_90; }

  void turn(const Curve& c, Spot at, int heading, int side, bool diagonal, int count, double speed, double time) {
    const auto line = drawn(c, at, heading, side);
    const Spot end{static_cast<int>(std::lround(line.back().x)), static_cast<int>(std::lround(line.back().y))};
    ASSERT_NEAR(line.back().x, end.x, 1e-9);
    ASSERT_NEAR(line.back().y, end.y, 1e-9);
    if (!is_open(maze_, end)) return;
    const bool ends_in_middle = end.x % 2 != 0 && end.y % 2 != 0;
    if (ends_in_middle != (c.turn == Turn::large_90 || c.turn == Turn::turn_180 || !c.orthogonal) &&
        c.turn != Turn::diagonal_90)
      return;
    const auto cells = passed(maze_, line);
    if (!cells || (c.turn == Turn::diagonal_90 && cells->size() != 2)) return;
    const Pace& pace = model_.pace(c.turn);
    const auto t = straight(diagonal, count, speed, pace.speed);
    if (!t) return;
    const double way = c.lead + c.radius * c.angle + c.tail;
    const int eighths = static_cast<int>(std::lround(c.angle / (kPi / 4)));
    improve({end.x, end.y, (heading + side * eighths + 8) % 8, static_cast<int>(c.turn)},
            time + *t + pace.time.value_or(way * model_.cell / 2 / pace.speed));
  }

  const GridMaze& maze_;
  const SpeedModel& model_;
  std::map<State, double> best_;
  std::map<std::tuple<bool, int, double, double>, std::optional<double>> known_;
  bool changed_ = false;
};

}  // namespace taut::micromouse
