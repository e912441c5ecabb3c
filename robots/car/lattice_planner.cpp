#include <taut/robots/car/lattice_planner.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

#include <taut/robots/car/detail/disc_distance.h>
#include <taut/robots/car/detail/lattice_search.h>
#include <taut/robots/car/detail/shortcuts.h>

namespace taut::car {

namespace {

constexpr double kNear = 3;  // more than half the car's diagonal, half a square's and a step

/// From coarse to fine: the next one is asked only when there is no way in the former.
constexpr std::array<detail::Lattice, 2> kLattices{{{4, 4, 0.02}, {10, 2, kMargin}}};

}  // namespace

bool crosses(const Pose& from, const Plan& plan, const Roadblock& block, WallReading reading) {
  const Pose* at = &from;
  for (std::size_t i = 0; i < plan.controls.size(); at = &plan.poses[i++])
    for (const Cell c : block.cells)
      if (std::abs(c.x - at->x) < kNear && std::abs(c.y - at->y) < kNear &&
          meets(*at, plan.controls[i], c, reading, kMargin))
        return true;
  return false;
}

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

  /// Of what was adopted from there: what is clear with `closed`, the best of all when its own obstacles were among them.
  std::optional<Plan> adopted(const Pose& from, RoadblockSet closed, bool& is_best) {
    std::optional<Plan> best;
    is_best = false;
    for (const Tail& tail : tails[{from.x, from.y, from.heading}]) {
      std::optional<Plan> plan = detail::replayed(from, tail.controls, known(closed).obstacles, kMargin);
      if (!plan || is_best || (best && best->controls.size() <= plan->controls.size())) continue;
      best = std::move(plan);
      is_best = (tail.shut & ~closed) == 0;
    }
    return best;
  }

  std::optional<Plan> found(const Pose& from, RoadblockSet closed) {
    bool is_best = false;
    std::optional<Plan> tail = adopted(from, closed, is_best);
    if (is_best) return tail;
    std::optional<Plan> plan = search(from, closed);
    if (tail && (!plan || tail->controls.size() <= plan->controls.size())) return tail;
    return plan;
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
  struct Tail {
    std::vector<double> controls;
    RoadblockSet shut;
  };

  std::map<std::tuple<double, double, double, RoadblockSet>, std::optional<Plan>> kept;
  std::map<std::tuple<double, double, double>, std::vector<Tail>> tails;
  std::size_t expanded = 0;
  std::size_t plans = 0;
};

LatticePlanner::LatticePlanner(const Course& course, WallReading reading)
    : impl_(std::make_unique<Impl>(course, reading)) {}

LatticePlanner::~LatticePlanner() = default;

const Plan* LatticePlanner::plan(const Pose& from, RoadblockSet closed) {
  const std::tuple key{from.x, from.y, from.heading, closed};
  auto at = impl_->kept.find(key);
  if (at == impl_->kept.end()) at = impl_->kept.emplace(key, impl_->found(from, closed)).first;
  return at->second ? &*at->second : nullptr;
}

void LatticePlanner::adopt(const Plan& plan, std::size_t steps, RoadblockSet shut) {
  const Pose& there = plan.poses[steps - 1];
  std::vector<Impl::Tail>& tails = impl_->tails[{there.x, there.y, there.heading}];
  if (std::ranges::any_of(tails, [&](const Impl::Tail& tail) { return tail.shut == shut; })) return;
  tails.push_back({{plan.controls.begin() + static_cast<std::ptrdiff_t>(steps), plan.controls.end()}, shut});
}

const Course& LatticePlanner::course() const { return impl_->course; }
WallReading LatticePlanner::reading() const { return impl_->reading; }
std::size_t LatticePlanner::expanded() const { return impl_->expanded; }
std::size_t LatticePlanner::plans() const { return impl_->plans; }

}  // namespace taut::car
