// Walks of a robot that knows the maze, by what each of its poses shows. Private.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <taut/geometry/grid_maze.h>
#include <taut/robots/micromouse/detail/boards.h>
#include <taut/robots/micromouse/rules.h>

namespace taut::micromouse::detail {

/// Where a robot can stand and what that shows. A pose is (cell, heading, felt): felt means that it came here backwards
/// and was stopped by the wall behind, which it then knows.
class Poses {
 public:
  using MousePose = std::uint32_t;

  /// Both must outlive it. O(cells).
  Poses(const GridMaze& maze, const Task& task);

  std::size_t count() const { return moves_.size(); }
  const std::vector<MousePose>& moves(MousePose pose) const { return moves_[pose]; }
  MousePose start() const { return id(task_.start, Side::north, false); }
  Cell cell(MousePose pose) const { return cell_of(task_.width, pose / 8); }

  /// Calls visit(wall, closed) for all that the pose shows.
  template <class Visit>
  void for_each_seen(MousePose pose, Visit visit) const {
    const Cell at = cell(pose);
    const auto heading = static_cast<Side>(pose % 4);
    for (const int quarters : {-1, 0, 1}) {
      const Side side = turned(heading, quarters);
      Cell c = at;
      for (; !maze_.wall(c, side); c = ahead(c, side)) visit(canonical({c, side}), false);
      visit(canonical({c, side}), true);
    }
    if (pose % 8 >= 4) visit(canonical({at, opposite(heading)}), true);
  }

 private:
  MousePose id(Cell c, Side heading, bool felt) const;
  void add_moves(Cell cell, Side heading, std::vector<MousePose>& into) const;

  const GridMaze& maze_;
  const Task& task_;
  std::vector<std::vector<MousePose>> moves_;
};

/// A demand on the walk: it has to be in one of these poses.
using PoseGroup = std::vector<Poses::MousePose>;

/// The shortest walk from the start that meets all groups, as poses. Breadth-first over (groups met, pose): O(2^groups
/// * poses). Precondition: fewer than 32 groups.
std::vector<Poses::MousePose> shortest_walk(const Poses& poses, const std::vector<PoseGroup>& groups);

}  // namespace taut::micromouse::detail
