#include <taut/robots/roadblocks/value_grid.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <taut/robots/roadblocks/detail/disc_distance.h>
#include <taut/robots/roadblocks/detail/steering.h>
#include <taut/robots/roadblocks/lattice_planner.h>

namespace taut::roadblocks {

namespace {

constexpr double kEighth = std::numbers::pi / 4;
constexpr double kSpare = 0.3;  // of the goal in the car
constexpr double kRoomy = 2.2;  // the car turns on the spot whatever is farther

/// The poses of an action driven from the origin, the controls between them.
struct Trace {
  std::vector<double> controls;
  std::vector<Pose> poses;
};

Trace trace_of(int heading, Action action, double length) {
  Trace trace;
  switch (action) {
    case Action::straight: trace.controls.assign(static_cast<std::size_t>(std::lround(length / kForward)), 0.0); break;
    case Action::back:
      trace.controls.assign(static_cast<std::size_t>(std::lround(length / kBackward)), kReverse);
      break;
    case Action::turn_plus: detail::Turn{kEighth, true, false}.append_to(trace.controls); break;
    case Action::turn_minus: detail::Turn{-kEighth, true, false}.append_to(trace.controls); break;
  }
  Pose at{0, 0, heading * kEighth};
  for (const double control : trace.controls) trace.poses.push_back(at = stepped(at, control));
  return trace;
}

bool drives(const detail::Obstacles& obstacles, const Pose& from, const Trace& trace) {
  Pose at = from;
  for (std::size_t i = 0; i < trace.poses.size(); ++i) {
    const Pose to{from.x + trace.poses[i].x, from.y + trace.poses[i].y, trace.poses[i].heading};
    if (!obstacles.is_clear(at, trace.controls[i], to, kMargin)) return false;
    at = to;
  }
  return true;
}

bool turns(Action action) { return action == Action::turn_plus || action == Action::turn_minus; }

/// What is around a point makes coming there dearer.
double clutter(Point p, const detail::Obstacles& obstacles) {
  double sum = 0;
  for (int y = static_cast<int>(std::floor(p.y - 1)); y <= static_cast<int>(std::ceil(p.y + 1)); ++y)
    for (int x = static_cast<int>(std::floor(p.x - 1)); x <= static_cast<int>(std::ceil(p.x + 1)); ++x) {
      const double dx = std::abs(x - p.x), dy = std::abs(y - p.y);
      if (std::max(dx, dy) < 1.5 && obstacles.is_closed({x, y}))
        sum += std::min(dx, dy) < 0.5 ? std::numbers::sqrt2 : 1;
    }
  return sum;
}

}  // namespace

ValueGrid::ValueGrid(const Course& course, RoadblockSet closed, WallReading reading, int per_unit, ValueCosts costs)
    : per_unit_(per_unit),
      columns_((course.width - 1) * per_unit + 1),
      rows_((course.height - 1) * per_unit + 1),
      backs_(costs.backs) {
  goal_.assign(plane() * kHeadings, 0);
  for (auto& all : costs_) all.assign(size(), kNever);
  const detail::Obstacles obstacles(course, closed, reading);
  price(obstacles, costs);
  for (std::size_t s = 0; s < size(); ++s)
    goal_[s] = covers(pose(s), course.goal, -kSpare) && obstacles.is_free(pose(s), kMargin);
}

void ValueGrid::price(const detail::Obstacles& obstacles, const ValueCosts& costs) {
  std::vector<std::uint8_t> stands(size());
  for (std::size_t s = 0; s < size(); ++s) stands[s] = obstacles.is_free(pose(s), kMargin);
  std::vector<double> around(plane());
  for (std::size_t s = 0; s < plane(); ++s) around[s] = clutter({pose(s).x, pose(s).y}, obstacles);
  for (int k = 0; k < kHeadings; ++k) {
    const double length = k % 2 != 0 ? std::numbers::sqrt2 : 1;
    for (const Action action : kActions) {
      if (action == Action::back && !costs.backs) continue;
      const Trace trace = trace_of(k, action, length / per_unit_);
      for (std::size_t s = index(0, 0, k); s < index(0, 0, k + 1); ++s) {
        if (!stands[s] || !stays_inside(s, action) || !stands[after(s, action)]) continue;
        const Pose at = pose(s);
        const bool roomy = turns(action) && obstacles.room({at.x, at.y}) > kRoomy;
        if (!roomy && !drives(obstacles, at, trace)) continue;
        const double way = action == Action::back ? 3 * length : length;
        costs_[static_cast<std::size_t>(action)][s] =
            turns(action) ? costs.turn : way + around[after(s, action) % plane()];
      }
    }
  }
}

bool ValueGrid::stays_inside(std::size_t state, Action action) const {
  if (turns(action)) return true;
  const auto columns = static_cast<std::size_t>(columns_);
  const auto [dx, dy] = kSteps[static_cast<std::size_t>(heading(state))];
  const int sign = action == Action::back ? -1 : 1;
  const int i = static_cast<int>(state % plane() % columns) + sign * dx;
  const int j = static_cast<int>(state % plane() / columns) + sign * dy;
  return i >= 0 && j >= 0 && i < columns_ && j < rows_;
}

Pose ValueGrid::pose(std::size_t state) const {
  const std::size_t at = state % plane(), columns = static_cast<std::size_t>(columns_);
  return {1 + static_cast<double>(at % columns) / per_unit_, 1 + static_cast<double>(at / columns) / per_unit_,
          heading(state) * kEighth};
}

std::size_t ValueGrid::after(std::size_t state, Action action) const {
  const int k = heading(state);
  if (!turns(action)) {
    const auto [dx, dy] = kSteps[static_cast<std::size_t>(k)];
    const int step = dy * columns_ + dx;
    return static_cast<std::size_t>(static_cast<std::ptrdiff_t>(state) + (action == Action::back ? -step : step));
  }
  const int turned = (k + (action == Action::turn_plus ? 1 : kHeadings - 1)) % kHeadings;
  return state % plane() + static_cast<std::size_t>(turned) * plane();
}

}  // namespace taut::roadblocks
