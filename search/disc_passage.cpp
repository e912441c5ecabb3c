#include <taut/search/disc_passage.h>

#include <algorithm>
#include <cmath>

#include <taut/geometry/segment_distance.h>
#include <taut/roadmaps/exact/exact_gates.h>
#include <taut/search/detail/disc_ends.h>
#include <taut/search/detail/gate_parity.h>

namespace taut {

namespace {

using detail::root_below;
using detail::share_component;
using detail::squared_distance;

/// The nearest wall to a point; the lowest index among equals.
struct NearestWall {
  std::uint32_t constraint = kNone;
  Rational squared;
};

NearestWall nearest_wall(const Gates& gates, Point p) {
  const WallIndex& walls = gates.exact().walls;
  NearestWall result;
  Interval least{HUGE_VAL, HUGE_VAL};
  std::vector<std::pair<Interval, std::uint32_t>> near;
  for (std::uint32_t c = 0; c < walls.ends().size(); ++c) {
    if (walls.is_opening(c)) continue;
    const Interval distance = segment_distance_interval({p, p}, walls.segment(c));
    if (distance.lo > least.hi) continue;
    if (distance.hi < least.hi) least = distance;
    near.emplace_back(distance, c);
  }
  for (const auto& [distance, c] : near) {
    if (distance.lo > least.hi) continue;
    const Rational squared = squared_distance(p, walls.segment(c));
    if (result.constraint == kNone || squared < result.squared) result = {c, squared};
  }
  return result;
}

bool is_outside(const Gates& gates, Point p) { return gates.space().locate(p).kind == Location::Kind::outside; }

bool is_too_near(const NearestWall& wall, double r) {
  return wall.constraint != kNone && wall.squared < meaning(r) * meaning(r);
}

/// Nothing when the disc can be at p; else the wall that is too near, or no wall when p is outside.
std::optional<std::vector<BarrierPiece>> blocked_at(const Gates& gates, Point p, double r) {
  if (is_outside(gates, p)) return std::vector<BarrierPiece>{};
  const NearestWall wall = nearest_wall(gates, p);
  if (!is_too_near(wall, r)) return std::nullopt;
  return std::vector<BarrierPiece>{{wall.constraint, kNone}};
}

/// How many gates are narrower than the square root of `squared`.
std::uint32_t count_narrower(const Gates& gates, const Rational& squared) {
  const auto& widths = gates.exact().squared;
  return static_cast<std::uint32_t>(std::lower_bound(widths.begin(), widths.end(), squared) - widths.begin());
}

/// What the ends allow, and the gates that matter below that.
struct Ends {
  WidestPassage widest;
  std::uint32_t gates = 0;
};

Ends limit_of_ends(const Gates& gates, Point s, Point g) {
  const NearestWall at_s = nearest_wall(gates, s), at_g = nearest_wall(gates, g);
  Ends result;
  result.widest.radius = HUGE_VAL;
  if (at_s.constraint == kNone) return result;
  const bool goal = at_g.squared < at_s.squared;
  const NearestWall& least = goal ? at_g : at_s;
  result.widest.limit = goal ? WidestPassage::Limit::goal : WidestPassage::Limit::start;
  result.widest.radius = root_below(least.squared);
  result.widest.constraint = least.constraint;
  result.gates = count_narrower(gates, 4 * least.squared);
  return result;
}

}  // namespace

DiscPassage disc_passage(const Gates& gates, Point s, Point g, double r) {
  if (auto wall = blocked_at(gates, s, r)) return {DiscStatus::start_blocked, std::move(*wall)};
  if (auto wall = blocked_at(gates, g, r)) return {DiscStatus::goal_blocked, std::move(*wall)};
  const Rational diameter = 2 * meaning(r);
  auto chain = detail::separating_chain(gates, s, g, count_narrower(gates, diameter * diameter));
  if (!chain) return {};
  return {DiscStatus::none, std::move(chain->pieces)};
}

DiscPassage disc_passage(const FreeSpace& space, Point s, Point g, double r) {
  return disc_passage(Gates(space), s, g, r);
}

std::optional<WidestPassage> widest_passage(const Gates& gates, Point s, Point g) {
  if (is_outside(gates, s) || is_outside(gates, g)) return std::nullopt;
  const FreeSpace& space = gates.space();
  const bool joined = space.component(space.locate(s).triangle) == space.component(space.locate(g).triangle);
  auto [widest, count] = limit_of_ends(gates, s, g);
  if (widest.radius == 0 && share_component(space, s, g)) return widest;
  if (!joined) return std::nullopt;
  auto chain = detail::separating_chain(gates, s, g, count);
  if (!chain || chain->last_gate == kNone) return widest;
  const std::uint32_t gate = chain->last_gate;
  return WidestPassage{WidestPassage::Limit::gate, root_below(gates.exact().squared[gate] / 4), gate, kNone,
                       std::move(chain->pieces)};
}

std::optional<WidestPassage> widest_passage(const FreeSpace& space, Point s, Point g) {
  return widest_passage(Gates(space), s, g);
}

}  // namespace taut
