// What comes of a micromouse, as JSON.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <taut/io/results/json.h>
#include <taut/robots/micromouse/certificate.h>
#include <taut/robots/micromouse/contest.h>
#include <taut/robots/micromouse/insurance.h>
#include <taut/robots/micromouse/speed_runs.h>
#include <taut/robots/micromouse/yardsticks.h>

namespace taut {

/// A trial and all that is told about it.
struct MouseTrial {
  micromouse::Record record;
  micromouse::Yardsticks yardsticks;
  std::optional<micromouse::Certificate> certificate{};
  std::string explorer{};  ///< its name; empty when it is a stranger
  std::uint64_t seed = 1;
  std::optional<micromouse::Insurance> insurance{};

  int cells_of(int run) const;  ///< cells moved
  int visited() const;          ///< different cells in which a step of run 1 began or ended
};

/// `explorer`, `seed` (null of a stranger), `score` (null when a run did not end in the goal), `run1`, `run2`,
/// `optimum`, `proven`, `floor`, `width`, `height`, `start`, `goal`, `goal_at` (the step of run 1 that reached it),
/// `walls_seen` of `walls` (interior ones, by the end of run 1), `floor_with_proof` where measured, `benchmarks`
/// {`every_cell`, `random_walkers`}, `insurance` {`steps`, `known`, `expected`, `back`, `balance`} of a trial that
/// finished, `route` (the cells of run 2), `steps`.
Json mouse_trial_json(const MouseTrial& trial);

/// `seed`, `mazes`, `without_route`, `explorers`: of each `explorer`, `mean`, `mean_floor`, `worst`, `worst_maze`,
/// `failures`, `proven`, `seconds` (CPU), `runs`; with several seeds `seeds`, `seed_means`, `spread`, `maze_spread`.
Json mouse_contest_json(const micromouse::Contest& contest, std::uint64_t seed);

/// `fastest`, `steady` and `shortest`: `seconds`, `metres`, `cells`, `turns`, `route`, `drives`; `differences`; `bound`
/// {`seconds`}, `any_curve` {`seconds`, `metres`}.
Json mouse_speed_json(const micromouse::SpeedRuns& runs);

}  // namespace taut
