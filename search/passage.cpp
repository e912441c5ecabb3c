#include <taut/search/passage.h>

#include <utility>

#include <taut/search/no_path.h>

namespace taut {

namespace {

std::pair<Point, std::optional<WidestPassage>> widest(const Gates& gates, Point start,
                                                      const std::vector<Point>& goals) {
  std::pair<Point, std::optional<WidestPassage>> best{goals.front(), std::nullopt};
  for (const Point goal : goals)
    if (auto way = widest_passage(gates, start, goal); way && (!best.second || way->radius > best.second->radius))
      best = {goal, std::move(way)};
  return best;
}

}  // namespace

Passage passage(const Gates& gates, Point start, const std::vector<Point>& goals, std::optional<double> radius) {
  auto [goal, way] = widest(gates, start, goals);
  Passage passage{start, goal, radius, std::move(way), {}, {}};
  if (radius) {
    passage.asked = disc_passage(gates, start, goal, *radius);
    passage.barrier = barrier_of(gates, passage.asked->barrier);
  } else if (passage.widest) {
    passage.barrier = barrier_of(gates, passage.widest->barrier);
  } else if (const auto walls = NoPath(gates.space()).walls(start, {goal, {}})) {
    passage.barrier.walls = joined_walls(*walls, gates.space().world().box());
  }
  return passage;
}

Point widest_goal(const Gates& gates, Point start, const std::vector<Point>& goals) {
  return widest(gates, start, goals).first;
}

}  // namespace taut
