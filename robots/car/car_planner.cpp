#include <taut/robots/car/car_planner.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include <taut/geometry/errors.h>
#include <taut/geometry/text.h>
#include <taut/robots/car/detail/car_space_impl.h>
#include <taut/robots/car/detail/drive_search.h>
#include <taut/robots/car/detail/geodesic.h>
#include <taut/robots/car/detail/leg_shortening.h>
#include <taut/search/no_path.h>

namespace taut::car {

namespace {

/// The coarsest lattice: a power of two below a quarter of what the car needs to turn or to pass.
double first_step(const CarShape& shape) {
  return std::exp2(std::floor(std::log2(std::min(shape.radius, 4 * shape.half_width) / 4)));
}

std::vector<int> headings_of(std::optional<int> heading) {
  if (heading) return {*heading};
  std::vector<int> all(kHeadings);
  for (int h = 0; h < kHeadings; ++h) all[static_cast<std::size_t>(h)] = h;
  return all;
}

std::vector<LatticePose> free_starts(const CarSpace& space, const DriveQuery& query) {
  std::vector<LatticePose> free;
  for (const int heading : headings_of(query.heading))
    if (space.is_free({query.start, heading})) free.push_back({query.start, heading});
  if (!free.empty()) return free;
  throw InputError({}, 0,
                   "the car cannot stand at the start " + taut::text(query.start) +
                       (query.heading ? " with that heading: a wall is in its way" : ", whatever its heading"));
}

void require_small(const World& world, double step) {
  const Box box = world.box();
  for (const double v : {box.min.x, box.min.y, box.max.x, box.max.y})
    if (!(std::abs(v) < step * (1 << 25)))
      throw InputError(world.source(), 0,
                       "is too large for the car's lattice: coordinates must be below " + taut::text(step * (1 << 25)));
}

/// Why not even the disc gets to any goal; nothing when it might.
std::optional<DiscPassage> barrier_of(const CarSpace& space, const DriveQuery& query) {
  const double r = space.shape().inner_radius();
  std::optional<DiscPassage> barrier;
  std::optional<Gates> gates;
  for (const Point goal : query.goals) {
    DiscPassage passage;
    if (r > 0) {
      if (!gates) gates.emplace(space.space());
      passage = disc_passage(*gates, query.start, goal, r);
    } else if (NoPath(space.space()).holds(query.start, {goal, {}})) {
      passage.status = DiscStatus::none;
    }
    if (passage.status == DiscStatus::found) return std::nullopt;
    if (!barrier || barrier->status != DiscStatus::none) barrier = std::move(passage);
  }
  return barrier;
}

void require_goal_free(const CarSpace& space, const DriveQuery& query) {
  if (query.goal_heading) {
    for (const Point goal : query.goals)
      if (space.is_free({goal, *query.goal_heading})) return;
    throw InputError({}, 0,
                     "the car cannot stand at the goal " + taut::text(query.goals.front()) +
                         " with that heading: a wall is in its way");
  }
  for (const Point goal : query.goals)
    if (space.space().locate(goal).kind != Location::Kind::outside) return;
  throw InputError({}, 0, "the goal " + taut::text(query.goals.front()) + " lies in a wall or outside the world");
}

}  // namespace

PlannedDrive planned_drive(const CarSpace& space, const DriveQuery& query) {
  PlannedDrive result;
  const double coarse = first_step(space.shape());
  require_small(space.space().world(), coarse / 4);
  const std::vector<LatticePose> starts = free_starts(space, query);
  require_goal_free(space, query);
  if ((result.barrier = barrier_of(space, query))) {
    if (result.barrier->status == DiscStatus::goal_blocked)
      throw InputError(
          {}, 0, "the car cannot stand at the goal " + taut::text(query.goals.front()) + ", whatever its heading");
    result.status = SearchStatus::none;
    return result;
  }
  const detail::Geodesic geodesic(space.space().world(), space.shape().inner_radius(), query.goals);
  result.lower_bound = geodesic.from(query.start);
  const auto begin = std::chrono::steady_clock::now();
  for (; result.lattices < kLattices && result.status != SearchStatus::found; ++result.lattices) {
    const std::chrono::duration<double> gone = std::chrono::steady_clock::now() - begin;
    if (gone.count() > query.limits.seconds || result.expanded >= query.limits.expansions) break;
    const auto level = static_cast<int>(result.lattices);
    const detail::LegLattice lattice{std::ldexp(coarse, -level), 4 >> level};
    result.step = lattice.step;
    result.headings = kHeadings / lattice.stride;
    const SearchLimits rest{query.limits.expansions - result.expanded, query.limits.seconds - gone.count()};
    detail::search_drive(space, query, starts, lattice, geodesic, rest, result);
  }
  if (result.status == SearchStatus::found && query.shorten)
    result.legs = detail::shortened(space, std::move(result.legs));
  for (const Leg& leg : result.legs) result.length += curve_of(leg).length();
  return result;
}

}  // namespace taut::car
