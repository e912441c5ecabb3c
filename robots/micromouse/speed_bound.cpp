#include <taut/robots/micromouse/speed_bound.h>

#include <algorithm>
#include <memory>
#include <vector>

#include <taut/geometry/free_space.h>
#include <taut/robots/micromouse/detail/turn_shapes.h>
#include <taut/robots/micromouse/rules.h>
#include <taut/search/polyanya.h>

namespace taut::micromouse {

namespace {

constexpr double kRoundedDown = 1 - 1e-12;  // far more than the few roundings of straight_seconds

/// The greatest of everything that a mouse of the model may do.
struct Envelope {
  Ramp ramp;
  bool by_speed_alone = false;
};

Envelope envelope_of(const SpeedModel& model) {
  const Ramp &s = model.straight, &d = model.diagonal;
  Envelope all{{std::max(s.acceleration, d.acceleration), std::max(s.deceleration, d.deceleration),
                std::max(s.top_speed, d.top_speed)}};
  for (const Turn turn : kAllTurns) {
    const double mean = length(turn) * model.cell / 2 / model.seconds(turn);
    all.by_speed_alone = all.by_speed_alone || mean > model.pace(turn).speed * (1 + 1e-12);
    all.ramp.top_speed = std::max({all.ramp.top_speed, model.pace(turn).speed, mean});
  }
  return all;
}

Point middle_of(Cell c) { return {c.x + 0.5, c.y + 0.5}; }

}  // namespace

std::optional<SpeedBound> speed_bound(const GridMaze& maze, const SpeedModel& model) {
  const auto walled = std::make_shared<const GridMaze>(detail::with_closed_border(maze));
  const Task task = task_of(*walled);
  std::vector<Point> goals;
  for (const Cell c : task.goal) goals.push_back(middle_of(c));
  PolyanyaSearch search{Polyanya(FreeSpace(world_of(walled)))};
  if (search.find_nearest(middle_of(task.start), goals) != SearchStatus::found) return std::nullopt;
  const double metres = Length(search.points()).interval().lo * model.cell * kRoundedDown;
  const Envelope all = envelope_of(model);
  const double seconds =
      all.by_speed_alone ? metres / all.ramp.top_speed : straight_seconds(all.ramp, 0, 0, metres).value_or(0);
  return SpeedBound{seconds * kRoundedDown, metres};
}

}  // namespace taut::micromouse
