// A navigation mesh of rectangles, made of cells without triangles.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <taut/geometry/cell_plan.h>
#include <taut/roadmaps/navmesh.h>

namespace taut {

/// Which polygon of a mesh holds which cells: runs of them in a row.
class CellPolygons {
 public:
  struct Run {
    std::uint32_t from;
    std::uint32_t to;
    std::uint32_t polygon;  ///< kNone: left out
  };

  CellPolygons(std::vector<Run> runs, std::vector<std::uint32_t> first_of_row)
      : runs_(std::move(runs)), first_(std::move(first_of_row)) {}

  /// kNone when the cell is not free or was left out. O(log n).
  std::uint32_t at(CellPlan::Cell cell) const;
  /// The polygons around a point, ascending; with `towards`, those of the sectors that hold that direction.
  void around(const CellPlan& plan, Point p, std::optional<Point> towards, std::vector<std::uint32_t>& out) const;

 private:
  std::vector<Run> runs_;             // by row, from left to right
  std::vector<std::uint32_t> first_;  // row -> its first run; one more entry than rows
};

struct CellNavmesh {
  Navmesh mesh;  ///< polygon_of is empty, sectors are kNone: there are no triangles
  CellPolygons polygons;
};

/// What navmesh_between makes of triangles, made of cells: runs of free cells in a row with nothing between them, those
/// one above the other as long as they agree; without dead ends. For these ends only. Of a bend's constraints it knows
/// the direction and one point, not the far end. O(cells / 64 + runs).
CellNavmesh cell_navmesh_between(const CellPlan& plan, Point from, const Goal& to);

}  // namespace taut
