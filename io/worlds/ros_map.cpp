#include <taut/io/worlds/ros_map.h>

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <utility>

#include <taut/geometry/errors.h>
#include <taut/geometry/occupancy_world.h>
#include <taut/geometry/written.h>
#include <taut/io/worlds/detail/text_input.h>

namespace taut {

namespace {

class Reader {
 public:
  Reader(const YAML::Node& root, const std::string& source) : root_(root), source_(source) {}

  RosMapInfo info() const {
    RosMapInfo info;
    info.image = text("image");
    info.resolution = number(required("resolution"), "resolution");
    if (!(info.resolution > 0)) fail(root_["resolution"], "resolution must be above 0");
    info.origin = origin();
    if (root_["negate"]) info.negate = truth("negate");
    if (root_["occupied_thresh"]) info.occupied = share("occupied_thresh");
    if (root_["free_thresh"]) info.free = share("free_thresh");
    if (info.free > info.occupied) fail(root_["free_thresh"], "free_thresh is above occupied_thresh");
    if (root_["mode"]) info.mode = mode();
    return info;
  }

 private:
  [[noreturn]] void fail(const YAML::Node& at, const std::string& message) const {
    throw InputError(source_, at && at.Mark().line >= 0 ? at.Mark().line + 1 : 0, message);
  }

  YAML::Node required(const char* key) const {
    const YAML::Node node = root_[key];
    if (!node) fail(root_, std::string("a map without ") + key);
    return node;
  }

  std::string text(const char* key) const {
    const YAML::Node node = required(key);
    if (!node.IsScalar() || node.Scalar().empty()) fail(node, std::string(key) + " is not a word");
    return node.Scalar();
  }

  double number(const YAML::Node& node, const char* key) const {
    if (!node.IsScalar()) fail(node, std::string(key) + " is not a number");
    return detail::coordinate(node.Scalar(), {source_, node.Mark().line + 1});
  }

  double share(const char* key) const {
    const double value = number(root_[key], key);
    if (value < 0 || value > 1) fail(root_[key], std::string(key) + " is not from 0 to 1");
    return value;
  }

  bool truth(const char* key) const {
    const std::string word = text(key);
    if (word == "1" || word == "true") return true;
    if (word == "0" || word == "false") return false;
    fail(root_[key], std::string(key) + " " + detail::quoted(word) + " is not 0 or 1");
  }

  Point origin() const {
    const YAML::Node node = required("origin");
    if (!node.IsSequence() || node.size() < 2 || node.size() > 3) fail(node, "origin is not [x, y, yaw]");
    if (node.size() == 3 && number(node[2], "yaw") != 0)
      fail(node[2],
           "a map that is turned (yaw " + node[2].Scalar() + ") is not read; set yaw to 0 and plan in its frame");
    return {number(node[0], "origin"), number(node[1], "origin")};
  }

  RosMapInfo::Mode mode() const {
    const std::string word = text("mode");
    if (word == "trinary") return RosMapInfo::Mode::trinary;
    if (word == "scale") return RosMapInfo::Mode::scale;
    if (word == "raw") return RosMapInfo::Mode::raw;
    fail(root_["mode"], "mode " + detail::quoted(word) + " is not trinary, scale or raw");
  }

  const YAML::Node& root_;
  const std::string& source_;
};

enum class Known : std::uint8_t { free, occupied, unknown };

Known known_of(std::uint8_t grey, std::uint8_t alpha, const RosMapInfo& info) {
  using enum RosMapInfo::Mode;
  if (info.mode == scale && alpha < 255) return Known::unknown;
  if (info.mode == raw && grey > 100) return Known::unknown;
  const double part = info.negate || info.mode == raw ? grey : 255 - grey;
  const double occupancy = part / (info.mode == raw ? 100 : 255);
  if (occupancy > info.occupied) return Known::occupied;
  return occupancy < info.free ? Known::free : Known::unknown;
}

}  // namespace

RosMapInfo read_ros_map_info(std::string_view text, const std::string& source) {
  try {
    const YAML::Node root = YAML::Load(std::string(text));
    if (!root.IsMap()) throw InputError(source, 0, "is no yaml map of keys and values");
    return Reader(root, source).info();
  } catch (const YAML::Exception& error) {
    throw InputError(source, error.mark.line + 1, "not valid YAML: " + error.msg);
  }
}

OccupancyGrid occupancy(const Raster& raster, const RosMapInfo& info, bool unknown_is_free) {
  OccupancyGrid grid{raster.width, raster.height, {}};
  grid.blocked.reserve(raster.grey.size());
  for (std::size_t i = 0; i < raster.grey.size(); ++i) {
    const Known cell = known_of(raster.grey[i], raster.alpha.empty() ? 255 : raster.alpha[i], info);
    grid.blocked.push_back(cell == Known::occupied || (cell == Known::unknown && !unknown_is_free) ? 1 : 0);
  }
  return grid;
}

World ros_world(const OccupancyGrid& grid, const RosMapInfo& info, std::string source) {
  const auto corner = [&](std::uint32_t column, std::uint32_t row) {
    return Point{written::sum(info.origin.x, written::times(column, info.resolution)),
                 written::sum(info.origin.y, written::times(grid.height - row, info.resolution))};
  };
  return World(parts_of(grid, corner, std::move(source)));
}

}  // namespace taut
