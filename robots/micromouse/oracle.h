// What can be achieved in a maze at all, by a robot that knows it: yardsticks for scores.
#pragma once

#include <optional>

#include <taut/robots/micromouse/rules.h>

namespace taut::micromouse {

/// The cheapest run 1 that ends with a proof, by a robot that knows the maze and only has to be shown it.
struct ProofBound {
  int optimum = 0;     ///< S*
  int run1 = 0;        ///< no run 1 that proves S* has fewer steps, its reset included
  bool exact = false;  ///< one with so many steps exists
  /// S* + run1 / 30: no robot that resets only with a proof scores below.
  double score() const { return optimum + static_cast<double>(run1) / kExplorationShare; }
};

/// When proof_bound gives up improving its bound.
struct OracleLimits {
  int groups = 12;  ///< sets of poses one of which the walk must visit; time and memory grow as 2^groups; at most 16
};

/// The lower bound, from cut plans (implicit hitting set): a walk must end a step in the goal and, for every plan
/// shorter than S*, be in a pose that shows a wall which that plan crosses. Walks are shortest over (cell, heading,
/// plans cut so far); plans are added while the walk found leaves one uncut, the one hardest to cut first. Sound
/// whenever it stops: fewer demands only shorten the walk. Nothing when the maze has no route.
std::optional<ProofBound> proof_bound(const GridMaze& maze, const OracleLimits& limits = {});

/// S* + (S* + 1) / 30: a robot that knows the maze goes to the goal, resets and goes there again.
std::optional<double> absolute_floor(const GridMaze& maze);

/// Two easier yardsticks.
///  1. S* + n^2 / 30 with n^2 the number of cells: run 1 sees every cell once.
std::optional<double> benchmark_every_cell(const GridMaze& maze);
///  2. The mean score of the first ten random walkers, seeds from 1 on, that finish both runs; nothing when of 1000
///     fewer do.
std::optional<double> benchmark_random_walkers(const GridMaze& maze);

}  // namespace taut::micromouse
