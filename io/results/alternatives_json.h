// The ways that there are, as JSON and as a table.
#pragma once

#include <string>

#include <taut/io/results/json.h>
#include <taut/search/alternatives.h>

namespace taut {

/// What there is to say of them.
struct AlternativesAnswer {
  Point start, goal;
  std::size_t asked = 0;
  bool wider = false;  ///< of all ways those that no shorter one is as wide as
  Alternatives found{};
  bool verified = false;
  std::optional<double> within{};  ///< rounding_bound, where crossings were rounded
};

/// One JSON object. Keys, in this order: query "alternatives", asked (how many, or "wider"), all (true: there are no
/// more), alternatives [{length, length_interval [lo, hi], points, corners, width, width_text, posts (the narrowest
/// gate that every path of its class passes; null each where it passes none)}, ...], the shortest first; verified,
/// within (where crossings of walls were rounded: no other way that stays so far from obstacles is missing), start,
/// goal, robot.
Json alternatives_json(const AlternativesAnswer& answer);

/// A line for each: its number, length, what it is longer than the first, width and narrowest gate.
std::string alternatives_table(const Alternatives& found);

}  // namespace taut
