#include <taut/robots/micromouse/contest.h>

#include <taut/robots/micromouse/certificate.h>

namespace taut::micromouse {

Score score_of(Explorer explorer, const GridMaze& maze, int max_steps, std::uint64_t seed) {
  const auto robot = make_explorer(explorer, task_of(maze, max_steps), seed);
  const Record record = run_trial(maze, *robot, max_steps);
  return {record.run1, record.run2, record.thirtieths(), certificate(record).has_value(),
          record.status == TrialStatus::finished ? "" : std::string(name(record.status))};
}

Contest::Summary Contest::summary(std::size_t explorer) const {
  Summary summary;
  int sum = 0, worst = 0;
  double floors = 0;
  const std::vector<Score>& row = scores[explorer];
  for (std::size_t i = 0; i < row.size(); ++i) {
    summary.proven += row[i].proven ? 1U : 0U;
    if (!row[i].thirtieths) {
      ++summary.failures;
      continue;
    }
    ++summary.finished;
    sum += *row[i].thirtieths;
    floors += yardsticks[i].floor;
    if (summary.worst && *row[i].thirtieths <= worst) continue;
    summary.worst = i;
    worst = *row[i].thirtieths;
  }
  if (summary.finished == 0) return summary;
  summary.worst_score = Score::value_of(worst);
  summary.mean = Score::value_of(sum) / static_cast<double>(summary.finished);
  summary.mean_floor = floors / static_cast<double>(summary.finished);
  return summary;
}

}  // namespace taut::micromouse
