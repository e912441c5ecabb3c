// A navigation mesh of cells whose sides open and close.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include <taut/geometry/cell_plan.h>
#include <taut/roadmaps/navmesh.h>

namespace taut {

/// All free cells of a plan as a mesh of rectangles, as cell_navmesh_between makes them, while walls along lines come
/// and go: what lies around a wall is made anew, the rest stays. One thread at a time.
///
///  1. Polygons, corners and bends that are gone stay in the mesh, numbers and all, without portals; once they are more
///     than those that are there all are numbered anew.
///  2. Which polygons hang together in blocks is found out when it is asked for: O(polygons), after any number of
///     changes.
class ChangingCellMesh {
 public:
  explicit ChangingCellMesh(CellPlan plan);
  ChangingCellMesh(ChangingCellMesh&&) noexcept;
  ChangingCellMesh& operator=(ChangingCellMesh&&) noexcept;
  ~ChangingCellMesh();

  const CellPlan& plan() const;

  /// Along the whole of an axis-parallel stretch between the plan's outermost lines: each side of a cell there is
  /// closed where is_wall(side) says so, or where one of its cells is not free. Lines that its ends need are made.
  /// O(rooms and cells that it meets); for a new line O(cells / 64 + rooms).
  void change(const Segment& stretch, const std::function<bool(const Segment& side)>& is_wall);

  /// With blocks. Always the same object; its numbers hold until the next change.
  const Navmesh& mesh();

  /// The polygons around a point, ascending. Empty: it is not free.
  void around(Point p, std::vector<std::uint32_t>& polygons) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace taut
