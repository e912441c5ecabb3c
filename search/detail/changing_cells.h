// Shortest paths among cells whose sides open and close. Private.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include <taut/roadmaps/changing_cell_mesh.h>
#include <taut/search/detail/polyanya_engine.h>
#include <taut/search/detail/wall_shelf.h>

namespace taut::detail {

/// A mesh of cells that follows its walls, and the search in it.
class ChangingCells {
 public:
  explicit ChangingCells(CellPlan plan) : mesh_(std::move(plan)), engine_(mesh_.mesh()) {}

  /// Walls along the stretch have come or gone; those are all that there are now. False when the plan would grow beyond
  /// what is worth while: then nothing was changed.
  bool change(const Segment& stretch, const std::vector<const WallShelf*>& walls);

  bool holds(Point p) const { return mesh_.plan().around(p).free != 0; }

  /// Precondition: it holds both.
  SearchStatus find(Point from, Point to, std::vector<Point>& points);

 private:
  bool has_room_for(const Segment& stretch) const;

  ChangingCellMesh mesh_;
  PolyanyaEngine engine_;
  std::vector<std::uint32_t> starts_;
  MeshGoal goal_;
};

}  // namespace taut::detail
