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

constexpr std::size_t kMostKnown =
    64;                      // sets of closed roadblocks whose estimates are kept: some 3 MB each on a map of 50 x 50
constexpr double kNear = 3;  // more than half the car's diagonal, half a square's and a step

/// From coarse to fine: the next one is asked only when there is no way in the former.
constexpr std::array<detail::Lattice, 2> kLattices{{{4, 4, 0.02, 1'000'000}, {10, 2, kMargin, 600'000}}};

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

  /// A way and what was closed when it was planned.
  struct Way {
    Plan plan;
    RoadblockSet shut;
  };

  struct Place {
    std::vector<Way> ways;
    std::vector<RoadblockSet> hopeless;
  };

  const Known& known(RoadblockSet closed) {
    auto at = by_closed.find(closed);
    if (at != by_closed.end()) return at->second;
    if (by_closed.size() >= kMostKnown) by_closed.clear();
    detail::Obstacles obstacles(course, closed, reading);
    detail::DiscDistance disc(obstacles, course.goal);
    const Known* before = nullptr;  // with the most of these closed
    for (const auto& [shut, known] : by_closed)
      if ((shut & ~closed) == 0) before = &known;
    detail::PoseDistance distance = before ? detail::PoseDistance(before->distance, before->obstacles, obstacles, disc)
                                           : detail::PoseDistance(obstacles, disc, course.goal);
    at = by_closed.emplace(closed, Known{std::move(obstacles), std::move(disc), std::move(distance)}).first;
    return at->second;
  }

  /// Of the ways known from there: the shortest that is clear with `closed`. The best of all when what it was planned around is among that.
  std::optional<Plan> known_way(const Place& place, const Pose& from, RoadblockSet closed, bool& is_best) {
    std::optional<Plan> shortest;
    for (const Way& way : place.ways) {
      if (shortest && shortest->controls.size() <= way.plan.controls.size()) continue;
      if (!is_clear(way.plan, from, closed & ~way.shut)) continue;
      shortest = way.plan;
      is_best = is_best || (way.shut & ~closed) == 0;
    }
    return shortest;
  }

  bool is_clear(const Plan& plan, const Pose& from, RoadblockSet closed) const {
    for (std::size_t b = 0; b < course.roadblocks.size(); ++b)
      if ((closed >> b) & 1 && crosses(from, plan, course.roadblocks[b], reading)) return false;
    return true;
  }

  std::optional<Plan> found(const Pose& from, RoadblockSet closed) {
    Place& place = places[{from.x, from.y, from.heading}];
    if (std::ranges::any_of(place.hopeless, [&](RoadblockSet shut) { return (shut & ~closed) == 0; }))
      return std::nullopt;
    bool is_best = false;
    std::optional<Plan> plan = known_way(place, from, closed, is_best);
    if (is_best) return plan;
    if (std::optional<Plan> other = search(from, closed);
        other && (!plan || other->controls.size() < plan->controls.size()))
      plan = std::move(other);
    if (plan)
      place.ways.push_back({*plan, closed});
    else
      place.hopeless.push_back(closed);
    return plan;
  }

  bool is_hopeless_from_start(const Pose& from, RoadblockSet closed) {
    const Pose start{course.start.x, course.start.y, 0};
    return from != start && !plan(start, closed);
  }

  const Plan* plan(const Pose& from, RoadblockSet closed) {
    const std::tuple key{from.x, from.y, from.heading, closed};
    auto at = kept.find(key);
    if (at == kept.end()) at = kept.emplace(key, found(from, closed)).first;
    return at->second ? &*at->second : nullptr;
  }

  std::optional<Plan> search(const Pose& from, RoadblockSet closed) {
    if (!known(closed).disc.reaches({from.x, from.y})) return std::nullopt;
    ++plans;
    for (const detail::Lattice& lattice : kLattices) {
      // The car came from the start: where that has no way, neither has this, and the fine lattice takes long to say so.
      if (&lattice == &kLattices.back() && is_hopeless_from_start(from, closed)) return std::nullopt;
      if (const auto plan = detail::lattice_search(known(closed).obstacles, known(closed).disc, known(closed).distance,
                                                   lattice, from, expanded))
        return detail::with_shortcuts(from, *plan, known(closed).obstacles, lattice.slack);
    }
    return std::nullopt;
  }

  const Course& course;
  WallReading reading;
  std::map<RoadblockSet, Known> by_closed;
  std::map<std::tuple<double, double, double, RoadblockSet>, std::optional<Plan>> kept;
  std::map<std::tuple<double, double, double>, Place> places;
  std::size_t expanded = 0;
  std::size_t plans = 0;
};

LatticePlanner::LatticePlanner(const Course& course, WallReading reading)
    : impl_(std::make_unique<Impl>(course, reading)) {}

LatticePlanner::~LatticePlanner() = default;

const Plan* LatticePlanner::plan(const Pose& from, RoadblockSet closed) { return impl_->plan(from, closed); }

void LatticePlanner::adopt(const Plan& plan, std::size_t steps, RoadblockSet shut) {
  const Pose& there = plan.poses[steps - 1];
  std::vector<Impl::Way>& ways = impl_->places[{there.x, there.y, there.heading}].ways;
  if (std::ranges::any_of(ways, [&](const Impl::Way& way) { return way.shut == shut; })) return;
  const auto by = static_cast<std::ptrdiff_t>(steps);
  ways.push_back(
      {{{plan.controls.begin() + by, plan.controls.end()}, {plan.poses.begin() + by, plan.poses.end()}}, shut});
}

std::optional<double> LatticePlanner::estimate(const Pose& from, RoadblockSet closed) {
  const double steps = impl_->known(closed).distance.steps_from(from);
  return steps == detail::PoseDistance::kFar ? std::nullopt : std::optional(steps);
}

const Course& LatticePlanner::course() const { return impl_->course; }
WallReading LatticePlanner::reading() const { return impl_->reading; }
std::size_t LatticePlanner::expanded() const { return impl_->expanded; }
std::size_t LatticePlanner::plans() const { return impl_->plans; }

}  // namespace taut::car
