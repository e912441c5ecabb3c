#include <taut/io/results/pose_file.h>

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include <taut/io/results/words.h>

namespace taut {

namespace {

const std::vector<double>* column(const PathToWrite& path, const char* name) {
  for (const auto& [title, values] : path.columns)
    if (title == name) return &values;
  return nullptr;
}

/// The direction in which the path leaves point i; where it ends, that in which it came there.
double way_on(const std::vector<Point>& points, std::size_t i) {
  std::size_t from = i, to = i + 1;
  while (to < points.size() && points[to] == points[i]) ++to;
  if (to >= points.size()) {
    to = i;
    while (from > 0 && points[from] == points[to]) --from;
  }
  return std::atan2(points[to].y - points[from].y, points[to].x - points[from].x);
}

std::string header(double second, const char* indent) {
  const double whole = std::floor(second);
  return fmt::format("header:\n{0}  stamp:\n{0}    sec: {1}\n{0}    nanosec: {2}\n{0}  frame_id: map\n", indent, whole,
                     std::floor((second - whole) * 1e9));
}

/// A number that YAML and ROS take for a float.
std::string decimal(double v) {
  const std::string text = number_text(v);
  return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

std::string pose(Point p, double yaw, double second) {
  return fmt::format(
      "- {}  pose:\n"
      "    position:\n      x: {}\n      y: {}\n      z: 0.0\n"
      "    orientation:\n      x: 0.0\n      y: 0.0\n      z: {}\n      w: {}\n",
      header(second, "  "), decimal(p.x), decimal(p.y), decimal(std::sin(yaw / 2)), decimal(std::cos(yaw / 2)));
}

std::string message(const PathToWrite& path) {
  const std::vector<double>*const headings = column(path, "heading"), *const seconds = column(path, "second");
  std::string out = header(0, "") + (path.points.empty() ? "poses: []\n" : "poses:\n");
  for (std::size_t i = 0; i < path.points.size(); ++i)
    out += pose(path.points[i], headings ? (*headings)[i] * std::numbers::pi / 180 : way_on(path.points, i),
                seconds ? (*seconds)[i] : 0);
  return out;
}

}  // namespace

std::string path_poses(std::span<const PathToWrite> paths) {
  std::string out;
  for (const PathToWrite& path : paths) {
    if (!out.empty()) out += "---\n";
    if (path.tolerance > 0) out += approximation_line(path.tolerance);
    out += message(path);
  }
  return out;
}

}  // namespace taut
