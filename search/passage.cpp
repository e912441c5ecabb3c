#include <taut/search/passage.h>

#include <utility>

#include <taut/search/no_path.h>

namespace taut {

namespace {

using Widest = std::pair<Point, std::optional<WidestPassage>>;

template <class Ask>
Widest widest(const std::vector<Point>& goals, Ask ask) {
  Widest best{goals.front(), std::nullopt};
  for (const Point goal : goals)
    if (auto way = ask(goal); way && (!best.second || way->radius > best.second->radius)) best = {goal, std::move(way)};
  return best;
}

Widest widest(const Gates& gates, Point start, const std::vector<Point>& goals) {
  return widest(goals, [&](Point goal) { return widest_passage(gates, start, goal); });
}

Passage passage_of(const Gates& gates, Point start, Widest best, std::optional<double> radius) {
  auto [goal, way] = std::move(best);
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

}  // namespace

Passage passage(const Gates& gates, Point start, const std::vector<Point>& goals, std::optional<double> radius) {
  return passage_of(gates, start, widest(gates, start, goals), radius);
}

Passage passage(const PassageIndex& index, Point start, const std::vector<Point>& goals, std::optional<double> radius) {
  const PassagePlace from = index.place(start);
  Widest best = widest(goals, [&](Point goal) { return index.widest(from, index.place(goal)); });
  // What keeps a larger disc out is a chain of gates.
  if (best.second && best.second->limit == WidestPassage::Limit::gate && !radius)
    best.second = widest_passage(index.gates(), start, best.first);
  return passage_of(index.gates(), start, std::move(best), radius);
}

Point widest_goal(const Gates& gates, Point start, const std::vector<Point>& goals) {
  return widest(gates, start, goals).first;
}

}  // namespace taut
