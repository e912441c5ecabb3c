#include <yaml-cpp/yaml.h>

#include <taut/geometry/errors.h>
#include <taut/io/worlds/detail/path_poses.h>
#include <taut/io/worlds/detail/text_input.h>
#include <taut/io/worlds/detail/yaml_text.h>

namespace taut::detail {

namespace {

[[noreturn]] void fail(const std::string& source, const YAML::Node& at, const std::string& message) {
  throw InputError(source, at && at.Mark().line >= 0 ? at.Mark().line + 1 : 0, message);
}

double number(const YAML::Node& position, const char* name, const std::string& source) {
  const YAML::Node node = position[name];
  if (!node || !node.IsScalar()) fail(source, position, std::string("a position without ") + name);
  return coordinate(node.Scalar(), {source, node.Mark().line + 1});
}

/// Of a PoseStamped, or of a bare Pose.
Point point(const YAML::Node& stamped, const std::string& source) {
  const YAML::Node pose = stamped.IsMap() && stamped["pose"] ? stamped["pose"] : stamped;
  const YAML::Node position = pose.IsMap() ? pose["position"] : YAML::Node();
  if (!position || !position.IsMap()) fail(source, stamped, "a pose without a position");
  return {number(position, "x", source), number(position, "y", source)};
}

}  // namespace

bool holds_poses(std::string_view bytes) {
  constexpr std::string_view kKey = "poses:";
  for (std::size_t at = bytes.find(kKey); at != std::string_view::npos; at = bytes.find(kKey, at + 1))
    if (at == 0 || bytes[at - 1] == '\n') return true;
  return false;
}

std::vector<ClaimedPath> read_paths_poses(std::string_view bytes, const std::string& source) try {
  std::vector<ClaimedPath> paths;
  for (const YAML::Node& message : YAML::LoadAll(yaml_text(bytes))) {
    if (message.IsNull()) continue;
    const YAML::Node poses = message.IsMap() ? message["poses"] : YAML::Node();
    if (!poses || !poses.IsSequence()) fail(source, message, "a path without a list of poses");
    ClaimedPath& path = paths.emplace_back();
    for (const YAML::Node& pose : poses) path.points.push_back(point(pose, source));
  }
  if (paths.empty()) throw InputError(source, 0, "holds no path: there are no poses");
  return paths;
} catch (const YAML::Exception& error) {
  throw InputError(source, error.mark.line >= 0 ? error.mark.line + 1 : 0,
                   "is no YAML: " + detail::printable_name(error.msg));
}

}  // namespace taut::detail
