// The solids of a grid map, traced when somebody wants them. Private.
#pragma once

#include <mutex>
#include <utility>
#include <vector>

#include <taut/geometry/occupancy_grid.h>
#include <taut/geometry/world.h>

namespace taut::detail {

class Raster {
 public:
  explicit Raster(OccupancyGrid grid) : grid_(std::move(grid)) {}

  const OccupancyGrid& grid() const { return grid_; }
  /// As World guarantees solids.
  const std::vector<Area>& solids() const;

 private:
  OccupancyGrid grid_;
  mutable std::once_flag traced_;
  mutable std::vector<Area> solids_;
};

}  // namespace taut::detail
