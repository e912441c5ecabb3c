// How far a pose is from the goal: a backward search on a coarse lattice of poses, repaired when a roadblock closes.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <taut/robots/roadblocks/detail/cost_queue.h>
#include <taut/robots/roadblocks/detail/disc_distance.h>
#include <taut/robots/roadblocks/detail/step_table.h>

namespace taut::roadblocks::detail {

/// Steps to the goal from poses on a lattice: the raster's middles, kTableHeadings headings, the car's own moves
/// rounded to it. An estimate of what the true car needs, within some percent; unlike a disc's way it knows what
/// turning and reversing cost. Whether poses are free is tested with the car smaller by kTableSlack, for what rounding
/// moves.
class PoseDistance {
 public:
  PoseDistance(const Obstacles& obstacles, const DiscDistance& disc, Point goal);

  /// The same goal with more cells closed: only what went through them is searched again, as long as that is the faster
  /// (up to a tenth of all states). The estimates are those of one made anew. `before` had a subset of the closed
  /// cells.
  PoseDistance(const PoseDistance& before, const Obstacles& before_obstacles, const Obstacles& obstacles,
               const DiscDistance& disc);

  /// Steps, between the nearest headings; kFar where the lattice knows no way (the car may).
  double steps_from(const Pose& pose) const;

  /// The same values, and nothing to repair them with.
  StepTable table() const { return {cost_, columns_}; }

  std::size_t bytes() const { return entries_.size() * (sizeof(entries_[0]) + sizeof(cost_[0])); }  ///< about

  static constexpr double kFar = StepTable::kFar;
  static constexpr int kTableHeadings = StepTable::kHeadings;
  static constexpr double kTableSlack = 0.15;

 private:
  using State = std::uint32_t;
  struct Move {
    int dx, dy, turn, cost;
    std::int32_t by = 0;                      ///< from a state's number to that of the state it leads to
    std::size_t entry = 0;                    ///< its place among the moves into the heading that it leads to
    std::vector<std::array<int, 3>> between;  ///< cells passed over, from its begin, and the turn there
  };

  void lay_moves();
  void search(Point goal);
  std::uint8_t entries(State s) const;
  template <typename Visit>
  void each_cell_around(int i, int j, int reach, Visit visit) const;
  void close(Cell cell, WallReading reading);
  void shut(const Obstacles& before, const Obstacles& obstacles, const DiscDistance& disc, CostQueue& queue);
  std::vector<State> unsettle(CostQueue& queue, const std::vector<std::uint16_t>& old);
  void spread(CostQueue& queue);
  template <typename Visit>
  void each_before(State s, Visit visit) const;
  template <typename Visit>
  void each_after(State s, Visit visit) const;
  std::size_t at(int i, int j) const {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(i);
  }
  bool is_passable(int i, int j, int h, const Move& move) const;
  bool is_free(State s) const { return (free_[s / kTableHeadings] >> (s % kTableHeadings)) & 1; }

  int columns_ = 0, rows_ = 0;
  std::array<std::vector<Move>, kTableHeadings> moves_;  ///< from each heading
  std::array<std::vector<Move>, kTableHeadings> moves_into_;
  std::vector<std::uint32_t> free_;    ///< of raster cells, a bit a heading
  std::vector<std::uint8_t> entries_;  ///< a bit for each of moves_into_ its heading that can be made
  std::vector<std::uint16_t> cost_;    ///< in 1/kParts steps
  std::size_t settled_ = 0;            ///< states with a value, when last made anew
};

}  // namespace taut::roadblocks::detail
