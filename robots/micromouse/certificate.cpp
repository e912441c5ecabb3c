#include <taut/robots/micromouse/certificate.h>
#include <map>

#include <taut/robots/micromouse/steps.h>

namespace taut::micromouse {

namespace {

/// What run 1 told, and when it told it first.
std::map<CellSide, Witness> witnesses(const Record& record) {
  std::map<CellSide, Witness> facts;
  for (std::size_t i = 0; i < record.steps.size() && record.steps[i].run == 1; ++i)
    for (const auto* news : {&record.steps[i].seen, &record.steps[i].felt})
      for (const WallSeen& seen : *news) facts.emplace(seen.wall, Witness{seen.wall, seen.closed, static_cast<int>(i)});
  return facts;
}

std::vector<Witness> needed_walls(const Task& task, int steps, const std::map<CellSide, Witness>& facts) {
  Passages maze = passages(task.width, task.height, true);
  for (const auto& [wall, fact] : facts)
    if (fact.closed) maze.set(wall.cell, wall.side, false);
  std::vector<Witness> needed;
  for (const auto& [wall, fact] : facts) {
    if (!fact.closed) continue;
    maze.set(wall.cell, wall.side, true);
    if (*optimum(maze, task) >= steps) continue;
    maze.set(wall.cell, wall.side, false);
    needed.push_back(fact);
  }
  return needed;
}

std::vector<Witness> crossed(const std::vector<Cell>& route, const std::map<CellSide, Witness>& facts) {
  std::vector<Witness> openings;
  for (std::size_t i = 1; i < route.size(); ++i) {
    const Side side = side_towards(route[i - 1], route[i]);
    for (Cell c = route[i - 1]; c != route[i]; c = ahead(c, side)) openings.push_back(facts.at(canonical({c, side})));
  }
  return openings;
}

}  // namespace

std::optional<Certificate> certificate(const Record& record) {
  if (record.status == TrialStatus::no_route) return std::nullopt;
  const auto facts = witnesses(record);
  WallMap map(record.task);
  for (const auto& [wall, fact] : facts) map.learn(wall.cell, wall.side, fact.closed);
  const auto lo = optimum(map.possible(), record.task), hi = optimum(map.certain(), record.task);
  if (!hi || lo != hi) return std::nullopt;
  const auto route = shortest_route(map.certain(), record.task);
  return Certificate{record.task, *hi, route, crossed(route, facts), needed_walls(record.task, *hi, facts)};
}

}  // namespace taut::micromouse
