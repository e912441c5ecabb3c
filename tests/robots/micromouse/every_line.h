// All lines of speed runs, one after the other, as fast as a fine grid of slices allows: for small mazes.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "robots/micromouse/slow_speed_run.h"

namespace taut::micromouse {

class EveryLine {
 public:
  EveryLine(const GridMaze& maze, const SpeedModel& model) : maze_(maze), model_(model), task_(task_of(maze)) {}

  /// The least time of all lines, or `limit` when none takes less.
  double least_seconds(double limit) {
    best_ = limit;
    stand(middle_of_cell(task_.start), 0, 0, 0);
    return best_;
  }

 private:
  struct Slice {
    double metres, cap, up, down;
  };
  struct Leg {
    std::vector<Slice> slices;
    double speed = 0, seconds = 0;  // when no braking is needed
  };

  static Spot middle_of_cell(Cell c) { return {2 * c.x + 1, 2 * c.y + 1}; }

  void add(Leg& leg, const Ramp& ramp, double metres) const {
    const int count = static_cast<int>(std::ceil(metres / 0.003));
    for (int i = 0; i < count; ++i) {
      const double dx = metres / count;
      leg.slices.push_back({dx, ramp.top_speed, ramp.acceleration, ramp.deceleration});
      const double before = std::min(leg.speed, ramp.top_speed);
      leg.speed = std::min(ramp.top_speed, std::sqrt(before * before + 2 * ramp.acceleration * dx));
      leg.seconds += 2 * dx / (before + leg.speed);
    }
  }

  static double seconds_to_stand(const Leg& leg) {
    const std::size_t n = leg.slices.size();
    std::vector<double> v(n + 1, 0);
    for (std::size_t i = 1; i < n; ++i) v[i] = std::min(leg.slices[i - 1].cap, leg.slices[i].cap);
    for (std::size_t i = n; i-- > 0;)
      v[i] = std::min(v[i], std::sqrt(v[i + 1] * v[i + 1] + 2 * leg.slices[i].down * leg.slices[i].metres));
    double seconds = 0;
    for (std::size_t i = 0; i < n; ++i) {
      v[i + 1] = std::min(v[i + 1], std::sqrt(v[i] * v[i] + 2 * leg.slices[i].up * leg.slices[i].metres));
      seconds += 2 * leg.slices[i].metres / (v[i] + v[i + 1]);
    }
    return seconds;
  }

  void stand(Spot at, int heading, double seconds, int pivots) {
    if (seconds >= best_) return;
    if (task_.in_goal({at.x / 2, at.y / 2})) {
      best_ = seconds;
      return;
    }
    drive(at, heading, seconds, {});
    for (const int by : {2, 4, 6})
      if (pivots == 0) stand(at, (heading + by) % 8, seconds + (by == 4 ? model_.pivot_180 : model_.pivot_90), 1);
  }

  void drive(Spot from, int heading, double before, const Leg& leg) {
    constexpr int kX[] = {0, 1, 1, 1, 0, -1, -1, -1}, kY[] = {1, 1, 0, -1, -1, -1, 0, 1};
    const bool diagonal = heading % 2 == 1;
    Leg now = leg;
    Spot at = from;
    for (int count = 0; before + now.seconds < best_; ++count) {
      const bool in_middle = at.x % 2 == 1 && at.y % 2 == 1;
      if (in_middle && !now.slices.empty()) stand(at, heading, before + seconds_to_stand(now), 0);
      for (const Curve& c : curves())
        if (c.orthogonal != diagonal && in_middle == (c.orthogonal && c.turn != Turn::small_90))
          for (const int side : {-1, 1}) turn(c, at, heading, side, before, now);
      at = {at.x + kX[heading], at.y + kY[heading]};
      if (!is_open(maze_, at)) return;
      add(now, diagonal ? model_.diagonal : model_.straight, model_.cell / 2 * (diagonal ? kRoot : 1));
    }
  }

  void turn(const Curve& c, Spot at, int heading, int side, double before, const Leg& leg) {
    const auto line = drawn(c, at, heading, side);
    const Spot end{static_cast<int>(std::lround(line.back().x)), static_cast<int>(std::lround(line.back().y))};
    if (!is_open(maze_, end)) return;
    const bool ends_in_middle = end.x % 2 != 0 && end.y % 2 != 0;
    const bool should = c.turn == Turn::large_90 || c.turn == Turn::turn_180 || !c.orthogonal;
    if (ends_in_middle != should && c.turn != Turn::diagonal_90) return;
    const auto cells = passed(maze_, line);
    if (!cells || (c.turn == Turn::diagonal_90 && cells->size() != 2)) return;
    const Ramp &s = model_.straight, &d = model_.diagonal;
    const int after = (heading + side * static_cast<int>(std::lround(c.angle / (kPi / 4))) + 8) % 8;
    Leg now = leg;
    add(now, c.orthogonal ? s : d, c.lead * model_.cell / 2);
    add(now,
        {std::max(s.acceleration, d.acceleration), std::max(s.deceleration, d.deceleration), model_.pace(c.turn).speed},
        c.radius * c.angle * model_.cell / 2);
    add(now, after % 2 == 0 ? s : d, c.tail * model_.cell / 2);
    drive(end, after, before, now);
  }

  const GridMaze& maze_;
  const SpeedModel& model_;
  Task task_;
  double best_ = std::numeric_limits<double>::infinity();
};

}  // namespace taut::micromouse
