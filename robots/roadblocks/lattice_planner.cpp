#include <taut/robots/roadblocks/lattice_planner.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <map>
#include <tuple>

#include <taut/robots/roadblocks/detail/disc_distance.h>
#include <taut/robots/roadblocks/detail/lattice_search.h>
#include <taut/robots/roadblocks/detail/pose_cells.h>
#include <taut/robots/roadblocks/detail/shortcuts.h>

namespace taut::roadblocks {

namespace {

constexpr std::size_t kMemory =
    160'000'000;  // bytes for estimates that are kept: some 4 MB for a set of closed roadblocks on a map of 50 x 50
constexpr std::size_t kLeastKnown = 8;
constexpr std::size_t kMostCells = 2;  // likewise, 13 MB each
constexpr double kNear = 3;            // more than half the car's diagonal, half a square's and a step

/// From coarse to fine: the next one is asked only when there is no way in the former. The first is a short look at the
/// second: where it does not suffice, a proof that there is no way comes sooner.
constexpr std::array<detail::Lattice, 3> kLattices{
    {{4, 4, 0.02, 60'000}, {4, 4, 0.02, 1'000'000}, {10, 2, kMargin, 600'000}}};

}  // namespace

bool crosses(const Pose& from, const DrivePlan& plan, const Roadblock& block, WallReading reading) {
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
    std::size_t used = 0;  ///< when last
  };

  enum class None : std::uint8_t { proven, exhausted, no_disc, capped };

  /// A plan, or why there is none.
  struct Answer {
    std::optional<DrivePlan> plan;
    None none = None::proven;
  };

  /// A way and what was closed when it was planned.
  struct Way {
    DrivePlan plan;
    RoadblockSet shut;
  };

  struct Place {
    std::vector<Way> ways;
    std::vector<std::pair<RoadblockSet, None>> hopeless;
  };

  Known& known(RoadblockSet closed) {
    auto at = by_closed.find(closed);
    if (at == by_closed.end()) {
      at = by_closed.emplace(closed, made(closed)).first;
      if (by_closed.size() > std::max(kLeastKnown, memory / at->second.distance.bytes()))
        by_closed.erase(longest_unused());
    }
    at->second.used = ++uses;
    return at->second;
  }

  Known made(RoadblockSet closed) {
    const auto* before = nearest(closed);
    if (!before) {
      detail::Obstacles obstacles(course, closed, reading);
      detail::DiscDistance disc(obstacles, course.goal);
      detail::PoseDistance distance(obstacles, disc, course.goal);
      return {std::move(obstacles), std::move(disc), std::move(distance), ++uses};
    }
    detail::Obstacles obstacles = before->obstacles.with(closed);
    detail::DiscDistance disc(obstacles, course.goal);
    detail::PoseDistance distance(before->distance, before->obstacles, obstacles, disc);
    return {std::move(obstacles), std::move(disc), std::move(distance), ++uses};
  }

  /// With the most of these closed, and nothing else.
  const Known* nearest(RoadblockSet closed) const {
    const Known* best = nullptr;
    int most = -1;
    for (const auto& [shut, known] : by_closed)
      if ((shut & ~closed) == 0 && std::popcount(shut) > most) best = &known, most = std::popcount(shut);
    return best;
  }

  std::map<RoadblockSet, Known>::iterator longest_unused() {
    return std::ranges::min_element(by_closed, {}, [](const auto& entry) { return entry.second.used; });
  }

  /// Of the ways known from there: the shortest that is clear with `closed`. The best of all when what it was planned
  /// around is among that.
  std::optional<DrivePlan> known_way(const Place& place, const Pose& from, RoadblockSet closed, bool& is_best) {
    std::optional<DrivePlan> shortest;
    for (const Way& way : place.ways) {
      if (shortest && shortest->controls.size() <= way.plan.controls.size()) continue;
      if (!is_clear(way.plan, from, closed & ~way.shut)) continue;
      shortest = way.plan;
      is_best = is_best || (way.shut & ~closed) == 0;
    }
    return shortest;
  }

  bool is_clear(const DrivePlan& plan, const Pose& from, RoadblockSet closed) const {
    for (std::size_t b = 0; b < course.roadblocks.size(); ++b)
      if ((closed >> b) & 1 && crosses(from, plan, course.roadblocks[b], reading)) return false;
    return true;
  }

  Answer found(const Pose& from, RoadblockSet closed) {
    Place& place = places[{from.x, from.y, from.heading}];
    for (const auto& [shut, none] : place.hopeless)
      if (none != None::capped && (shut & ~closed) == 0) return {std::nullopt, none};
    bool is_best = false;
    std::optional<DrivePlan> way = known_way(place, from, closed, is_best);
    if (is_best) return {std::move(way)};
    Answer answer = search(from, closed);
    if (way && !(answer.plan && answer.plan->controls.size() < way->controls.size())) answer = {std::move(way)};
    if (answer.plan)
      place.ways.push_back({*answer.plan, closed});
    else
      place.hopeless.emplace_back(closed, answer.none);
    return answer;
  }

  Answer& answer(const Pose& from, RoadblockSet closed) {
    const std::tuple key{from.x, from.y, from.heading, closed};
    auto at = kept.find(key);
    if (at == kept.end()) at = kept.emplace(key, is_cut_off(closed) ? Answer{} : found(from, closed)).first;
    return at->second;
  }

  bool is_cut_off(RoadblockSet closed) const {
    return std::ranges::any_of(cuts, [&](RoadblockSet cut) { return (cut & ~closed) == 0; });
  }

  /// Is it proven that the start has no way, and so nothing that can be reached from there? What the proof needs is
  /// kept as a cut: it serves all sets of closed roadblocks that hold it.
  bool proves_cut_off(RoadblockSet closed) {
    if (is_cut_off(closed)) return true;
    const RoadblockSet cut = lessened(closed);
    if (may_reach(start(), cut)) return false;
    cuts.push_back(cut);
    return true;
  }

  /// Without roadblocks that can be open while the disc still has no way from the start; all where it has one.
  RoadblockSet lessened(RoadblockSet closed) const {
    const detail::Obstacles open(course, 0, reading);
    const auto passes = [&](RoadblockSet shut) {
      return detail::DiscDistance(open.with(shut), course.goal).reaches({course.start.x, course.start.y});
    };
    if (passes(closed)) return closed;
    RoadblockSet cut = closed;
    for (RoadblockSet rest = closed; rest != 0; rest &= rest - 1)
      if (const RoadblockSet block = rest & (~rest + 1); !passes(cut & ~block)) cut &= ~block;
    return cut;
  }

  Pose start() const { return {course.start.x, course.start.y, 0}; }

  Answer search(const Pose& from, RoadblockSet closed) {
    if (!known(closed).disc.reaches({from.x, from.y})) return {std::nullopt, None::no_disc};
    ++plans;
    if (known(closed).distance.steps_from(from) == detail::PoseDistance::kFar && !may_reach(from, closed))
      return {std::nullopt, None::proven};
    detail::LatticeAnswer last;
    for (const detail::Lattice& lattice : kLattices) {
      if (&lattice == &kLattices[1] && last.exhausted) continue;
      if (&lattice != &kLattices.front() && !may_reach(from, closed)) return {std::nullopt, None::proven};
      if (&lattice == &kLattices.back()) {
        // The car came from the start: where that has no way, neither has this, and the fine lattice takes long to say
        // so.
        if (from != start() && !answer(start(), closed).plan) return {std::nullopt, answer(start(), closed).none};
      }
      const Known& now = known(closed);
      last = detail::lattice_search(now.obstacles, now.disc, now.distance, lattice, from, expanded);
      if (last.plan) return {detail::with_shortcuts(from, *last.plan, now.obstacles, lattice.slack)};
    }
    return {std::nullopt, last.exhausted ? None::exhausted : None::capped};
  }

  /// False is a proof.
  bool may_reach(const Pose& from, RoadblockSet closed) {
    auto at = cells.find(closed);
    if (at == cells.end()) {
      if (cells.size() >= kMostCells) cells.clear();
      at = cells.emplace(closed, detail::PoseCells(known(closed).obstacles, course.goal)).first;
    }
    return at->second.reaches(from);
  }

  const Course& course;
  WallReading reading;
  std::map<RoadblockSet, Known> by_closed;
  std::size_t uses = 0;
  std::size_t memory = kMemory;
  std::map<RoadblockSet, detail::PoseCells> cells;
  std::vector<RoadblockSet> cuts;  ///< closed, they leave no way from the start: proven
  std::map<std::tuple<double, double, double, RoadblockSet>, Answer> kept;
  std::map<std::tuple<double, double, double, RoadblockSet>, double> estimates;
  std::map<std::tuple<double, double, double>, Place> places;
  std::size_t expanded = 0;
  std::size_t plans = 0;
};

LatticePlanner::LatticePlanner(const Course& course, WallReading reading)
    : impl_(std::make_unique<Impl>(course, reading)) {}

LatticePlanner::~LatticePlanner() = default;

const DrivePlan* LatticePlanner::plan(const Pose& from, RoadblockSet closed) {
  const auto& plan = impl_->answer(from, closed).plan;
  return plan ? &*plan : nullptr;
}

bool LatticePlanner::gave_up(const Pose& from, RoadblockSet closed) {
  const Impl::Answer& answer = impl_->answer(from, closed);
  if (answer.plan) return false;
  return answer.none != Impl::None::proven && !impl_->proves_cut_off(closed) && impl_->may_reach(from, closed);
}

void LatticePlanner::adopt(const DrivePlan& plan, std::size_t steps, RoadblockSet shut) {
  const Pose& there = plan.poses[steps - 1];
  std::vector<Impl::Way>& ways = impl_->places[{there.x, there.y, there.heading}].ways;
  if (std::ranges::any_of(ways, [&](const Impl::Way& way) { return way.shut == shut; })) return;
  const auto by = static_cast<std::ptrdiff_t>(steps);
  ways.push_back(
      {{{plan.controls.begin() + by, plan.controls.end()}, {plan.poses.begin() + by, plan.poses.end()}}, shut});
}

std::optional<double> LatticePlanner::estimate(const Pose& from, RoadblockSet closed) {
  const std::tuple key{from.x, from.y, from.heading, closed};
  auto at = impl_->estimates.find(key);
  if (at == impl_->estimates.end())
    at = impl_->estimates.emplace(key, impl_->known(closed).distance.steps_from(from)).first;
  return at->second == detail::PoseDistance::kFar ? std::nullopt : std::optional(at->second);
}

void LatticePlanner::keep_at_most(std::size_t bytes) { impl_->memory = std::min(impl_->memory, bytes); }

const Course& LatticePlanner::course() const { return impl_->course; }
WallReading LatticePlanner::reading() const { return impl_->reading; }
std::size_t LatticePlanner::expanded() const { return impl_->expanded; }
std::size_t LatticePlanner::plans() const { return impl_->plans; }

}  // namespace taut::roadblocks
