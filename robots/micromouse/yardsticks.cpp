#include <taut/robots/micromouse/yardsticks.h>

#include <taut/robots/micromouse/steps.h>

namespace taut::micromouse {

std::optional<Yardsticks> yardsticks(const GridMaze& maze) {
  const auto steps = optimum(passages_of(maze), task_of(maze));
  if (!steps) return std::nullopt;
  Yardsticks y;
  y.optimum = *steps;
  y.floor = *absolute_floor(maze);
  y.every_cell = *benchmark_every_cell(maze);
  return y;
}

bool fit_for_proof_bound(const GridMaze& maze) {
  constexpr int kMostCells = 64 * 64;  // beyond it the search for a proof takes minutes
  return maze.width() * maze.height() <= kMostCells;
}

}  // namespace taut::micromouse
