// Occupancy maps of the Robot Operating System.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include <taut/geometry/occupancy_grid.h>
#include <taut/geometry/world.h>
#include <taut/io/worlds/raster.h>

namespace taut {

/// What `map.yaml` says beside the picture's name.
struct RosMapInfo {
  enum class Mode : std::uint8_t {
    trinary,  ///< occupied, free or, between the thresholds, unknown
    scale,    ///< the same, and what is not opaque is unknown
    raw       ///< grey values are occupancies in percent; above 100: unknown
  };
  std::string image;       ///< file name, relative to the yaml file
  double resolution = 0;   ///< metres a pixel, > 0
  Point origin;            ///< of the lower left pixel's lower left corner, metres
  double yaw = 0;          ///< by which the map is turned around it, radians, counter-clockwise
  bool negate = false;     ///< white is occupied
  double occupied = 0.65;  ///< occupancy above this is occupied
  double free = 0.196;     ///< below this is free
  Mode mode = Mode::trinary;
};

/// Reads the yaml text. Keys as map_server has them: image, resolution, origin [x, y, yaw], negate, occupied_thresh,
/// free_thresh, mode. Throws InputError that names `source`, line and key.
RosMapInfo read_ros_map_info(std::string_view text, const std::string& source);

/// Occupancy as map_server has it: (255 - grey) / 255, or grey / 255 where negated, in doubles; above or below the
/// thresholds, not equal. Unknown cells are blocked unless `unknown_is_free`.
OccupancyGrid occupancy(const Raster& raster, const RosMapInfo& info, bool unknown_is_free);

/// In metres, y up: corner (column, row) of the grid lies at origin + resolution * (column, height - row), each the
/// double nearest to that decimal. With a yaw those are turned around the origin and rounded, each corner of a cell to
/// one place, whatever borders on it: nothing opens or closes by that, and no corner is off by more than turning_error.
World ros_world(const OccupancyGrid& grid, const RosMapInfo& info, std::string source);

/// Metres; 0 without a yaw.
double turning_error(const OccupancyGrid& grid, const RosMapInfo& info);

}  // namespace taut
