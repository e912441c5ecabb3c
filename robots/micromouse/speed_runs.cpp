#include <taut/robots/micromouse/speed_runs.h>

#include <utility>

namespace taut::micromouse {

std::optional<SpeedRuns> speed_runs(const GridMaze& maze, const SpeedModel& model) {
  auto steady = speed_run(maze, model);
  if (!steady) return std::nullopt;
  SpeedRun shortest = at_full_speed(*speed_run(maze, model, Aim::fewest_cells), model);
  FreeSpeedRun free = *free_speed_run(maze, model);
  if (free.run.cells.size() == shortest.cells.size()) shortest = free.run;
  return SpeedRuns{std::move(free.run), *std::move(steady), std::move(shortest), free.bound, *speed_bound(maze, model)};
}

}  // namespace taut::micromouse
