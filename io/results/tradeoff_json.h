// What room costs, as JSON and as a table.
#pragma once

#include <optional>
#include <string>

#include <taut/io/results/json.h>
#include <taut/search/barrier.h>
#include <taut/search/radius_tradeoff.h>

namespace taut {

/// What there is to say of it.
struct TradeoffAnswer {
  Point start, goal;
  RadiusTradeoff found{};
  bool verified = false;
  std::optional<double> within{};  ///< rounding_bound, where crossings were rounded
  Barrier barrier{};               ///< why there is none
  std::string limit{};             ///< what keeps larger discs out, in words
};

/// One JSON object. Keys, in this order: query "tradeoff", tradeoff, verified, within (as in result_json.h), limit (in
/// words), barrier {walls, gates} (when there is no way), start, goal, robot. `tradeoff` has an object for each stretch
/// of radii:
///  above, radius  the way is the shortest for radii from the first double above `above` to `radius`
///  length         at `radius`; length_above: at the other end
///  then           what happens beyond: "bend" (it touches a further corner), "shorter" (another way becomes shorter),
///                 "closed" (it is too narrow; gate {posts, width, width_text} where one is exactly that wide),
///                 "left" (an end has to be left), "last" (no larger disc gets through)
///  formula        {constant, angle, legs [[d, k], ...]}: the length for radius r is constant + angle r + the sum of
///                 sqrt(d^2 - (k r)^2) + k r asin(k r / d)
///  start, goal, robot, bends, arcs, points  the way at `radius`, as in arc_json.h
/// and where an end had to be left, in the place of these
///  aside          part of `constant`: how far the disc's ends are from start and goal, together
///  way            {start, goal, robot, length, bends, arcs, points}, of the disc
Json tradeoff_json(const TradeoffAnswer& answer, const Gates& gates);
/// An object of `tradeoff`.
Json stretch_json(const TradeoffStretch& stretch, double above, const Gates& gates);

/// A line for each stretch under a line of titles.
std::string tradeoff_table(const std::vector<TradeoffStretch>& stretches, const Gates& gates);

/// What happens beyond a stretch: `closed: 2/5 between (5, 0.8) and (5, 1.2)`.
std::string stretch_end_text(const TradeoffStretch& stretch, const Gates& gates);

}  // namespace taut
