// What a maze allows, to hold a score against.
#pragma once

#include <optional>

#include <taut/robots/micromouse/oracle.h>

namespace taut::micromouse {

struct Yardsticks {
  int optimum = 0;                         ///< S*, the fewest steps of run 2
  double floor = 0;                        ///< knows the maze
  double every_cell = 0;                   ///< benchmark_every_cell()
  std::optional<ProofBound> with_proof{};  ///< knows it, but has to see a proof; not measured by yardsticks()
  std::optional<double> random_walkers{};  ///< benchmark_random_walkers(); likewise
  bool walked = false;                     ///< random walkers were sent, even if too few of them finished
};

/// Those that take no time. Nothing when the maze has no route.
std::optional<Yardsticks> yardsticks(const GridMaze& maze);

/// Is the maze small enough, 64 x 64 cells, for the floor with proof to be found in seconds?
bool fit_for_proof_bound(const GridMaze& maze);

}  // namespace taut::micromouse
