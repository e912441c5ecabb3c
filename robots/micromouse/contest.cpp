#include <taut/robots/micromouse/contest.h>

#include <cmath>

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

namespace {

double mean_of(const std::vector<double>& values) {
  double sum = 0;
  for (const double v : values) sum += v;
  return sum / static_cast<double>(values.size());
}

/// Of a sample: over n - 1.
double variance_of(const std::vector<double>& values) {
  const double mean = mean_of(values);
  double sum = 0;
  for (const double v : values) sum += (v - mean) * (v - mean);
  return sum / static_cast<double>(values.size() - 1);
}

}  // namespace

std::optional<Contest::Spread> Contest::spread(std::size_t explorer) const {
  if (explorer >= more.size() || more[explorer].empty()) return std::nullopt;
  std::vector<const std::vector<Score>*> rows{&scores[explorer]};
  for (const std::vector<Score>& row : more[explorer]) rows.push_back(&row);
  std::vector<std::vector<double>> by_seed(rows.size());
  double variances = 0;
  for (std::size_t k = 0; k < mazes.size(); ++k) {
    std::vector<double> values;
    for (const auto* row : rows)
      if (k < row->size() && (*row)[k].thirtieths) values.push_back(Score::value_of(*(*row)[k].thirtieths));
    if (values.size() < rows.size()) continue;
    variances += variance_of(values);
    for (std::size_t s = 0; s < rows.size(); ++s) by_seed[s].push_back(values[s]);
  }
  if (by_seed.front().empty()) return std::nullopt;
  Spread spread;
  for (const std::vector<double>& values : by_seed) spread.means.push_back(mean_of(values));
  spread.of_means = std::sqrt(variance_of(spread.means));
  spread.of_a_maze = std::sqrt(variances / static_cast<double>(by_seed.front().size()));
  return spread;
}

}  // namespace taut::micromouse
