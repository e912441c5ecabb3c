#include <taut/robots/car/lattice_planner.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <tuple>

#include <taut/robots/car/detail/disc_distance.h>
#include <taut/robots/car/detail/lattice_search.h>

namespace taut::car {

struct LatticePlanner::Impl {
  Impl(const Course& c, WallReading r) : course(c), reading(r) {}

  struct Known {
    detail::Obstacles obstacles;
    detail::DiscDistance distance;
  };

  const Known& known(RoadblockSet closed) {
    auto at = by_closed.find(closed);
    if (at == by_closed.end()) {
      detail::Obstacles obstacles(course, closed, reading);
      detail::DiscDistance distance(obstacles, course.goal);
      at = by_closed.emplace(closed, Known{std::move(obstacles), std::move(distance)}).first;
    }
    return at->second;
  }

  std::optional<Plan> search(const Pose& from, RoadblockSet closed) {
    const Known& what = known(closed);
    if (!what.distance.reaches({from.x, from.y})) return std::nullopt;
    ++plans;
    for (const detail::Lattice& lattice : {detail::Lattice{4, 4}, detail::Lattice{10, 2}})
      if (std::optional<Plan> plan = detail::lattice_search(what.obstacles, what.distance, lattice, from, expanded))
        return plan;
    return std::nullopt;
  }

  const Course& course;
  WallReading reading;
  std::map<RoadblockSet, Known> by_closed;
  std::map<std::tuple<double, double, double, RoadblockSet>, std::optional<Plan>> kept;
  std::size_t expanded = 0;
  std::size_t plans = 0;
};

LatticePlanner::LatticePlanner(const Course& course, WallReading reading)
    : impl_(std::make_unique<Impl>(course, reading)) {}

LatticePlanner::~LatticePlanner() = default;

const Plan* LatticePlanner::plan(const Pose& from, RoadblockSet closed) {
  const std::tuple key{from.x, from.y, from.heading, closed};
  auto at = impl_->kept.find(key);
  if (at == impl_->kept.end()) at = impl_->kept.emplace(key, impl_->search(from, closed)).first;
  return at->second ? &*at->second : nullptr;
}

std::size_t LatticePlanner::expanded() const { return impl_->expanded; }
std::size_t LatticePlanner::plans() const { return impl_->plans; }

}  // namespace taut::car
