// What a robot that looks on after it reached the goal pays, and what it gets back.
#pragma once

#include <cstdint>
#include <optional>

#include <taut/robots/micromouse/trial.h>

namespace taut::micromouse {

/// `score` and `prove` could race as soon as they have been at the goal. They look on because the route found so far
/// may be a poor one: each step costs a thirtieth, a shorter run 2 gives whole steps back. As with any insurance it is
/// paid always and needed sometimes.
struct Insurance {
  int paid = 0;         ///< steps of run 1 after the goal was first reached, but for the reset
  int known = 0;        ///< the fewest steps of run 2 on what had been seen then
  double expected = 0;  ///< what knowing all would take off that, on average: expected_gain()
  int back = 0;         ///< what run 2 was shorter than that

  double price() const;    ///< in points: thirtieths
  double balance() const;  ///< back - price(): what looking on was worth
};

/// Of a finished trial; nothing of others.
std::optional<Insurance> insurance_of(const Record& record, std::uint64_t seed = 1);

/// By how many steps run 2 would be shorter if all walls were known: the mean over mazes drawn from what mazes look
/// like given these walls (detail/belief.h), less what such mazes promise too much: 0.95 of it where less than 41.5 %
/// of the walls seen stand, 0.44 where more do (docs/micromouse.md has the figures). Nothing when no way to the goal is
/// known.
std::optional<double> expected_gain(const Task& task, const WallMap& map, std::uint64_t seed = 1);

}  // namespace taut::micromouse
