// A page (web/wasm/CMakeLists.txt) has no libpng, pugixml, yaml-cpp and zlib. Its worlds come as GeoJSON or as maps of
// MovingAI, whatever the program read; anything else that needs those libraries is refused.
#include <taut/io/worlds/detail/formats.h>

#ifdef TAUT_IN_PAGE

#include <taut/geometry/errors.h>
#include <taut/io/worlds/gzip.h>
#include <taut/io/worlds/raster.h>
#include <taut/io/worlds/ros_map.h>

namespace taut {

namespace {

[[noreturn]] void refuse(const std::string& source, const char* what) {
  throw InputError(source, 0, std::string("the planner in a page reads no ") + what);
}

}  // namespace

bool is_gzip(std::string_view bytes) { return bytes.starts_with("\x1f\x8b"); }
std::string gunzip(std::string_view /*bytes*/, const std::string& source, std::size_t /*limit*/) {
  refuse(source, "files of gzip");
}

bool is_png(std::string_view bytes) { return bytes.starts_with("\x89PNG\r\n"); }
bool is_pgm(std::string_view bytes) { return bytes.starts_with("P2") || bytes.starts_with("P5"); }
Raster read_raster(std::string_view /*bytes*/, const std::string& source) { refuse(source, "pictures"); }

RosMapInfo read_ros_map_info(std::string_view /*text*/, const std::string& source) { refuse(source, "maps of ROS"); }
OccupancyGrid occupancy(const Raster& /*raster*/, const RosMapInfo& /*info*/, bool /*unknown_is_free*/) {
  refuse({}, "maps of ROS");
}
World ros_world(const OccupancyGrid& /*grid*/, const RosMapInfo& /*info*/, std::string source) {
  refuse(source, "maps of ROS");
}
double turning_error(const OccupancyGrid& /*grid*/, const RosMapInfo& /*info*/) { refuse({}, "maps of ROS"); }

namespace detail {

WorldParts read_svg(std::string_view /*bytes*/, const ReadOptions& options, ReadNotes& /*notes*/) {
  refuse(options.source, "SVG");
}

}  // namespace detail
}  // namespace taut

#endif
