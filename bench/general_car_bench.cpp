// A general car: the exact test of a leg against a wall beside the usual one, poses sampled along the way in doubles;
// and whole drives through mazes.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include <taut/geometry/maze_generator.h>
#include <taut/robots/car/car_planner.h>
#include <taut/robots/car/detail/prepared_leg.h>
#include <taut/robots/car/verify_drive.h>

namespace {

using namespace taut;
using namespace taut::car;

const CarShape kCar = car_shape(0.4, 0.2, 0.3, 0.1);

struct Case {
  Leg leg;
  Segment wall;
  bool met;  // by the second exact method
};

/// Turns by 22.5 and 45 degrees, and walls near them: half of them of length 1, half splinters of 0.02.
const std::vector<Case>& cases() {
  static const std::vector<Case> all = [] {
    std::mt19937 engine(5);
    const auto draw = [&](double low, double high) {
      return low + (high - low) * static_cast<double>(engine() >> 8) / (1 << 24);
    };
    std::vector<Case> drawn;
    while (drawn.size() < 4096) {
      const int from = static_cast<int>(engine() % kHeadings), turn = 4 + 4 * static_cast<int>(engine() % 2);
      const double x = draw(-0.5, 0.5), y = draw(-0.5, 0.5);
      const Leg leg{{{0, 0}, from}, {{x, y}, (from + turn) % kHeadings}, false};
      const Point a{draw(-0.5, 0.6), draw(-0.5, 0.6)};
      const double angle = draw(0, 6.28);
      const double size = drawn.size() % 2 == 0 ? 1 : 0.02;
      const Segment wall{a, {a.x + size * std::cos(angle), a.y + size * std::sin(angle)}};
      if (validate(leg, kCar) || stand_meets(leg.from, kCar, wall)) continue;
      drawn.push_back({leg, wall, drive_meets(leg, kCar, wall)});
    }
    return drawn;
  }();
  return all;
}

bool pose_meets(const Pose& pose, const Segment& wall) {
  const double c = std::cos(pose.heading), s = std::sin(pose.heading);
  const auto inward = [&](Point p) {
    return Point{c * (p.x - pose.x) + s * (p.y - pose.y), c * (p.y - pose.y) - s * (p.x - pose.x)};
  };
  const Point a = inward(wall.a), b = inward(wall.b);
  double low = 0, high = 1;
  const auto clip = [&](double at, double step, double least, double most) {
    const double t = (least - at) / step, u = (most - at) / step;
    low = std::max(low, std::min(t, u));
    high = std::min(high, std::max(t, u));
  };
  clip(a.x, b.x - a.x, -kCar.back, kCar.front);
  clip(a.y, b.y - a.y, -kCar.half_width, kCar.half_width);
  return low < high;
}

void BM_ExactSweep(benchmark::State& state) {
  std::vector<taut::car::detail::PreparedLeg> legs;
  std::vector<taut::car::detail::NearWall> walls;
  for (const Case& c : cases()) {
    legs.emplace_back(c.leg, kCar);
    walls.emplace_back(c.wall, c.leg.from.at);
  }
  std::size_t wrong = 0;
  for (auto _ : state) {
    wrong = 0;
    for (std::size_t i = 0; i < cases().size(); ++i)
      wrong += legs[i].meets(walls[i], cases()[i].leg, kCar) != cases()[i].met;
  }
  if (wrong > 0) state.SkipWithError("wrong answer");
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(cases().size()));
}
BENCHMARK(BM_ExactSweep);

/// Poses so many to a leg, laid beforehand.
void BM_SampledSweep(benchmark::State& state) {
  const auto poses = static_cast<int>(state.range(0));
  std::vector<std::vector<Pose>> laid;
  for (const Case& c : cases()) {
    laid.emplace_back();
    for (int i = 0; i <= poses; ++i) laid.back().push_back(pose_on(c.leg, static_cast<double>(i) / poses));
  }
  std::size_t missed = 0, met = 0;
  for (auto _ : state) {
    missed = met = 0;
    for (std::size_t i = 0; i < cases().size(); ++i) {
      const bool found =
          std::ranges::any_of(laid[i], [&](const Pose& pose) { return pose_meets(pose, cases()[i].wall); });
      met += cases()[i].met;
      missed += cases()[i].met && !found;
    }
  }
  state.counters["met"] = static_cast<double>(met);
  state.counters["missed"] = static_cast<double>(missed);
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(cases().size()));
}
BENCHMARK(BM_SampledSweep)->Arg(4)->Arg(16)->Arg(64)->Arg(1024);

void BM_DriveThroughMaze(benchmark::State& state) {
  const int cells = static_cast<int>(state.range(0));
  auto maze = std::make_shared<GridMaze>(generate_backtracker(cells, cells, 1));
  open_walls(*maze, 0.1, 1);
  const World world = world_of(maze);
  PlannedDrive drive;
  for (auto _ : state) {
    const CarSpace space(FreeSpace(world), kCar);
    drive = planned_drive(space, {.start = {0.5, 0.5}, .goals = {{cells - 0.5, cells - 0.5}}, .weight = 1.05});
  }
  if (drive.status != SearchStatus::found || verify_drive(drive.legs, FreeSpace(world), kCar))
    state.SkipWithError("wrong answer");
  state.counters["length"] = drive.length;
  state.counters["over_bound"] = drive.length / drive.lower_bound;
  state.counters["expanded"] = static_cast<double>(drive.expanded);
}
BENCHMARK(BM_DriveThroughMaze)->Arg(25)->Arg(41)->Arg(61)->Unit(benchmark::kMillisecond);

}  // namespace
