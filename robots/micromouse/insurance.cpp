#include <taut/robots/micromouse/insurance.h>

#include <algorithm>

#include <taut/robots/micromouse/detail/belief.h>
#include <taut/robots/micromouse/steps.h>

namespace taut::micromouse {

namespace {

// True gains over those promised, of generated mazes and competition mazes (docs/micromouse.md): where many of the
// walls seen stand, detours are rarer cut short than the law of the samples knows.
constexpr double kDense = 0.415, kOfSparse = 0.95, kOfDense = 0.44;
constexpr int kCellsInAll = 36'864, kFewest = 8, kMost = 96;  // samples: fewer where each costs more
constexpr int kUpdates = 8;                                   // the first ones are still near to where drawing began

/// Which share of the interior walls that are known stand.
double density_of(const Task& task, const WallMap& map) {
  int known = 0, closed = 0;
  const auto count = [&](Cell c, Side side) {
    const WallState state = map.state(c, side);
    known += state != WallState::unknown;
    closed += state == WallState::closed;
  };
  for (int y = 0; y < task.height; ++y)
    for (int x = 0; x < task.width; ++x) {
      if (y + 1 < task.height) count({x, y}, Side::north);
      if (x + 1 < task.width) count({x, y}, Side::east);
    }
  return known > 0 ? static_cast<double>(closed) / known : 0;
}

WallMap known_at_goal(const Record& record) {
  WallMap map(record.task);
  for (std::size_t i = 0; i < static_cast<std::size_t>(*record.goal_at); ++i)
    for (const auto* news : {&record.steps[i].seen, &record.steps[i].felt})
      for (const WallSeen& w : *news) map.learn(w.wall.cell, w.wall.side, w.closed);
  return map;
}

}  // namespace

double Insurance::price() const { return static_cast<double>(paid) / kExplorationShare; }
double Insurance::balance() const { return back - price(); }

std::optional<double> expected_gain(const Task& task, const WallMap& map, std::uint64_t seed) {
  const std::optional<int> known = optimum(map.certain(), task);
  if (!known) return std::nullopt;
  detail::Belief belief(task, std::clamp(kCellsInAll / (task.width * task.height), kFewest, kMost), seed);
  for (int i = 0; i < kUpdates; ++i) belief.update(map);
  double gain = 0;
  for (int k = 0; k < belief.samples(); ++k)
    gain += *known - std::min(*known, optimum(belief.world(k), task).value_or(*known));
  return (density_of(task, map) < kDense ? kOfSparse : kOfDense) * gain / belief.samples();
}

std::optional<Insurance> insurance_of(const Record& record, std::uint64_t seed) {
  if (record.status != TrialStatus::finished) return std::nullopt;
  const WallMap map = known_at_goal(record);
  const std::optional<int> known = optimum(map.certain(), record.task);
  if (!known) return std::nullopt;
  return Insurance{record.run1 - 1 - *record.goal_at, *known, expected_gain(record.task, map, seed).value_or(0),
                   *known - record.run2};
}

}  // namespace taut::micromouse
