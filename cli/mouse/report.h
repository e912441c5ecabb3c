// A micromouse trial in words and as JSON.
#pragma once

#include <taut/robots/micromouse/certificate.h>
#include <taut/robots/micromouse/oracle.h>
#include <taut/robots/micromouse/trial.h>
#include <cstdint>
#include <optional>
#include <string>

namespace taut::cli {

/// What a maze allows, to hold a score against.
struct MouseYardsticks {
  int optimum = 0;                                   ///< S*, the fewest steps of run 2
  double floor = 0;                                  ///< knows the maze
  std::optional<micromouse::ProofBound> with_proof;  ///< knows it, but has to see a proof
  double every_cell = 0;                             ///< benchmark 1
  std::optional<double> random_walkers;              ///< benchmark 2
  bool walked = false;                               ///< random walkers were sent, even if too few of them finished
};

/// Is the maze small enough, 64 x 64 cells, for the floor with proof to be found in seconds?
bool fit_for_proof_bound(const GridMaze& maze);

/// Nothing when the maze has no route. `all`: also those that take many trials or, where the maze is fit for it, a
/// search.
std::optional<MouseYardsticks> yardsticks(const GridMaze& maze, bool all);

/// A trial and all that is told about it.
struct MouseReport {
  std::string source;
  std::string explorer;
  std::uint64_t seed = 1;
  micromouse::Record record;
  MouseYardsticks yardsticks;
  std::optional<micromouse::Certificate> certificate;
  std::size_t walls_seen = 0;  ///< interior ones, at the end of run 1
  std::size_t walls = 0;       ///< interior ones, places
  double seconds = 0;          ///< the robot's and the trial's

  int cells_of(int run) const;  ///< cells moved
  int visited() const;          ///< different cells in which a step of run 1 began or ended
};

std::string mouse_table(const MouseReport& report);
std::string mouse_json(const MouseReport& report);

/// Which walls each run's steps told, what the map was after run 1.
micromouse::WallMap map_after_run1(const micromouse::Record& record);

}  // namespace taut::cli
