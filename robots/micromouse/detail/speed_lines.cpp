#include <taut/robots/micromouse/detail/speed_lines.h>

#include <algorithm>

namespace taut::micromouse::detail {

SpeedLines::SpeedLines(const GridMaze& maze, const Task& task, const SpeedModel& model, std::size_t classes)
    : maze_(maze), task_(task), model_(model), classes_(speed_classes(model, classes)), shapes_(turn_shapes()) {
  for (const auto& of_heading : shapes_) {
    auto& pieces = pieces_.emplace_back();
    for (const TurnShape& shape : of_heading)
      pieces.push_back(turn_pieces(model, shape.turn, shape.heading, shape.after));
  }
}

bool SpeedLines::is_end(const SpeedNode& n) const { return may_pivot(n) && task_.in_goal(cell_at(n.at)); }

std::size_t SpeedLines::nodes() const {
  return columns() * (2 * static_cast<std::size_t>(maze_.height()) + 1) * 8 * classes_.size();
}

std::size_t SpeedLines::index(const SpeedNode& n) const {
  const std::size_t spot = static_cast<std::size_t>(n.at.y) * columns() + static_cast<std::size_t>(n.at.x);
  return (spot * 8 + n.heading) * classes_.size() + n.speed;
}

SpeedNode SpeedLines::node(std::size_t index) const {
  const std::size_t pose = index / classes_.size(), spot = pose / 8;
  return {{static_cast<int>(spot % columns()), static_cast<int>(spot / columns())},
          static_cast<Eighth>(pose % 8),
          index % classes_.size()};
}

bool SpeedLines::passes(const TurnShape& shape, Spot at) const {
  return fits(shape, at) && std::all_of(shape.way.begin() + 1, shape.way.end(), [&](Spot by) {
           return is_open(maze_, {at.x + by.x, at.y + by.y});
         });
}

std::span<const Piece> SpeedLines::joined(const Piece& straight, const std::vector<Piece>& turn) const {
  joined_.assign(1, straight);
  joined_.insert(joined_.end(), turn.begin(), turn.end());
  return joined_;
}

std::size_t SpeedLines::place_of(Turn turn, Eighth heading, Eighth after) const {
  const auto& shapes = shapes_[heading];
  const auto found =
      std::ranges::find_if(shapes, [&](const TurnShape& s) { return s.turn == turn && s.after == after; });
  return static_cast<std::size_t>(found - shapes.begin());
}

}  // namespace taut::micromouse::detail
