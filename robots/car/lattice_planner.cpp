#include <taut/robots/car/lattice_planner.h>

#include <array>
#include <map>
#include <tuple>

#include <taut/robots/car/detail/disc_distance.h>
#include <taut/robots/car/detail/lattice_search.h>
#include <taut/robots/car/detail/shortcuts.h>

namespace taut::car {

namespace {

/// From coarse to fine: the next one is asked only when there is no way in the former.
constexpr std::array<detail::Lattice, 2> kLattices{{{4, 4, 0.02}, {10, 2, kMargin}}};

}  // namespace

struct LatticePlanner::Impl {
  Impl(const Course& c, WallReading r) : course(c), reading(r) {}

  struct Known {
    detail::Obstacles obstacles;
    detail::DiscDistance disc;
    detail::PoseDistance distance;
  };

  const Known& known(RoadblockSet closed) {
    auto at = by_closed.find(closed);
    if (at == by_closed.end()) {
      detail::Obstacles obstacles(course, closed, reading);
      detail::DiscDistance disc(obstacles, course.goal);
      detail::PoseDistance distance(obstacles, disc, course.goal);
      at = by_closed.emplace(closed, Known{std::move(obstacles), std::move(disc), std::move(distance)}).first;
    }
    return at->second;
  }

  std::optional<Plan> search(const Pose& from, RoadblockSet closed) {
    const Known& what = known(closed);
    if (!what.disc.reaches({from.x, from.y})) return std::nullopt;
    ++plans;
    for (const detail::Lattice& lattice : kLattices)
      if (const auto plan =
              detail::lattice_search(what.obstacles, what.disc, what.distance, lattice, from, expanded))
        return detail::with_shortcuts(from, *plan, what.obstacles, lattice.slack);
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
