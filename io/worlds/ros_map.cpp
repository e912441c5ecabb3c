#include <taut/io/worlds/ros_map.h>

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <taut/geometry/errors.h>
#include <taut/geometry/occupancy_world.h>
#include <taut/geometry/written.h>
#include <taut/io/worlds/detail/text_input.h>
#include <taut/io/worlds/detail/yaml_text.h>

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
    info.origin = origin(info.yaw);
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

  Point origin(double& yaw) const {
    const YAML::Node node = required("origin");
    if (!node.IsSequence() || node.size() < 2 || node.size() > 3) fail(node, "origin is not [x, y, yaw]");
    if (node.size() == 3) yaw = number(node[2], "yaw");
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
    const YAML::Node root = YAML::Load(detail::yaml_text(text));
    if (!root.IsMap()) throw InputError(source, 0, "is no yaml map of keys and values");
    return Reader(root, source).info();
  } catch (const YAML::Exception& error) {
    throw InputError(source, error.mark.line + 1, "not valid YAML: " + detail::printable_name(error.msg));
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

namespace {

// Blocked cells all around: what is solid at the border hangs together with them.
OccupancyGrid padded(const OccupancyGrid& grid) {
  OccupancyGrid result{grid.width + 2, grid.height + 2, {}};
  result.blocked.assign(std::size_t{result.width} * result.height, 1);
  for (std::size_t row = 0; row < grid.height; ++row)
    std::copy_n(grid.blocked.begin() + static_cast<std::ptrdiff_t>(row * grid.width), grid.width,
                result.blocked.begin() + static_cast<std::ptrdiff_t>((row + 1) * result.width + 1));
  return result;
}

// The border runs in the middle of the padding, off all corners of cells.
World turned_world(const OccupancyGrid& grid, const RosMapInfo& info, std::string source) {
  const double c = std::cos(info.yaw), s = std::sin(info.yaw);
  const auto at = [&](double column, double row) {
    const double x = (column - 1) * info.resolution, y = (grid.height + 1 - row) * info.resolution;
    return Point{info.origin.x + (c * x - s * y), info.origin.y + (s * x + c * y)};
  };
  WorldParts parts = parts_of(
      padded(grid), [&](std::uint32_t column, std::uint32_t row) { return at(column, row); }, std::move(source));
  const double right = grid.width + 1.5, bottom = grid.height + 1.5;
  parts.areas = {{{{at(0.5, bottom), at(right, bottom), at(right, 0.5), at(0.5, 0.5)}, {}}}};
  return World(std::move(parts));
}

}  // namespace

double turning_error(const OccupancyGrid& grid, const RosMapInfo& info) {
  if (info.yaw == 0) return 0;
  const double reach = (grid.width + grid.height + 4.0) * info.resolution;
  return 0x1p-50 * (std::abs(info.origin.x) + std::abs(info.origin.y) + reach);
}

World ros_world(const OccupancyGrid& grid, const RosMapInfo& info, std::string source) {
  if (info.yaw != 0) return turned_world(grid, info, std::move(source));
  const auto corner = [&](std::uint32_t column, std::uint32_t row) {
    return Point{written::sum(info.origin.x, written::times(column, info.resolution)),
                 written::sum(info.origin.y, written::times(grid.height - row, info.resolution))};
  };
  return World(parts_of(grid, corner, std::move(source)));
}

}  // namespace taut
