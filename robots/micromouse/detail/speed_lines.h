// The lines of speed runs as a graph of straights with turns behind them, at any speeds. Private.
#pragma once

#include <span>
#include <vector>

#include <taut/robots/micromouse/detail/speed_profile.h>
#include <taut/robots/micromouse/rules.h>

namespace taut::micromouse::detail {

/// Where a straight begins: out of a turn, at a speed of a class, or standing (class 0).
struct SpeedNode {
  Spot at;
  Eighth heading = 0;
  std::size_t speed = 0;
};

/// From a node to the next one: a straight, and a turn unless it stops in the middle of a cell.
struct SpeedEdge {
  Spot other;          // the node at the other end
  Eighth heading = 0;  // there
  int count = 0;       // of the straight, in half cells
  const TurnShape* turn = nullptr;
  std::span<const Piece> pieces;  // valid until the next edge
};

class SpeedLines {
 public:
  /// All three are kept by reference. `classes`: as speed_classes() has it.
  SpeedLines(const GridMaze& maze, const Task& task, const SpeedModel& model, std::size_t classes);

  const Task& task() const { return task_; }
  const SpeedModel& model() const { return model_; }
  std::size_t classes() const { return classes_.size(); }
  bool is_end(const SpeedNode& n) const;
  bool may_pivot(const SpeedNode& n) const { return n.speed == 0 && is_middle_of_cell(n.at); }
  double pivot_seconds(int eighths) const { return eighths == 4 ? model_.pivot_180 : model_.pivot_90; }

  /// Nodes as numbers below nodes().
  std::size_t nodes() const;
  std::size_t index(const SpeedNode& n) const;
  SpeedNode node(std::size_t index) const;

  /// No drive along the edge takes less whose speeds at its ends are of these classes.
  double seconds(const SpeedEdge& edge, std::size_t in, std::size_t out) const {
    return edge.turn == nullptr && out > 0 ? kNever : least_seconds(edge.pieces, classes_[in], classes_[out]);
  }

  /// Calls each(edge) for those that lead on from a node.
  template <class Each>
  void ahead(const SpeedNode& from, const Each& each) const {
    walk(from.at, from.heading, [&](Spot at, int count) {
      const Piece straight = straight_piece(model_, from.heading, count);
      if (count > 0 && is_middle_of_cell(at)) each(SpeedEdge{at, from.heading, count, nullptr, {&straight, 1}});
      for (std::size_t i = 0; i < shapes_[from.heading].size(); ++i) {
        const TurnShape& shape = shapes_[from.heading][i];
        if (passes(shape, at))
          each(SpeedEdge{end_of(shape, at), shape.after, count, &shape, joined(straight, pieces_[from.heading][i])});
      }
    });
  }

  /// Calls each(edge) for those that lead to a node, which knows all that ahead() knows: they are driven from the other
  /// end to this one, and the maze is the same backwards.
  template <class Each>
  void behind(const SpeedNode& to, const Each& each) const {
    const Eighth back = turned_by(to.heading, 4);
    if (may_pivot(to))
      walk(to.at, back, [&](Spot at, int count) {
        const Piece straight = straight_piece(model_, to.heading, count);
        if (count > 0) each(SpeedEdge{at, to.heading, count, nullptr, {&straight, 1}});
      });
    for (const TurnShape& reversed : shapes_[back]) {
      if (!passes(reversed, to.at)) continue;
      const Eighth heading = turned_by(reversed.after, 4);
      const std::size_t i = place_of(reversed.turn, heading, to.heading);
      walk(end_of(reversed, to.at), reversed.after, [&](Spot at, int count) {
        each(SpeedEdge{at, heading, count, &shapes_[heading][i],
                       joined(straight_piece(model_, heading, count), pieces_[heading][i])});
      });
    }
  }

 private:
  std::size_t columns() const { return 2 * static_cast<std::size_t>(maze_.width()) + 1; }
  static Spot end_of(const TurnShape& shape, Spot at) { return {at.x + shape.way.back().x, at.y + shape.way.back().y}; }
  bool passes(const TurnShape& shape, Spot at) const;
  std::span<const Piece> joined(const Piece& straight, const std::vector<Piece>& turn) const;
  std::size_t place_of(Turn turn, Eighth heading, Eighth after) const;

  /// Calls each(spot, count) along a straight, as far as it is open.
  template <class Each>
  void walk(Spot at, Eighth heading, const Each& each) const {
    for (int count = 0; count == 0 || is_open(maze_, at); ++count, at = ahead_of(at, heading)) each(at, count);
  }

  const GridMaze& maze_;
  const Task& task_;
  const SpeedModel& model_;
  std::vector<SpeedClass> classes_;
  std::vector<std::vector<TurnShape>> shapes_;
  std::vector<std::vector<std::vector<Piece>>> pieces_;  // as shapes_
  mutable std::vector<Piece> joined_;
};

}  // namespace taut::micromouse::detail
