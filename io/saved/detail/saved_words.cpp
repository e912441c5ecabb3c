#include <taut/io/saved/detail/saved_words.h>

#include <fmt/format.h>

#include <algorithm>

#include <taut/geometry/errors.h>
#include <taut/io/saved/roadmap_file.h>

namespace taut::detail {

std::string robot_text(const Footprint& robot) {
  if (robot.kind() == Footprint::Kind::point) return "point";
  if (robot.radius() > 0)
    return fmt::format("{} {}", robot.kind() == Footprint::Kind::disc ? "disc" : "square", robot.radius());
  std::string text = "polygon";
  for (const Point p : robot.ring()) text += fmt::format(" {} {}", p.x, p.y);
  return text;
}

std::string one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < ' ' || c == 0x7f; }, '?');
  return text;
}

void require_same_world(const std::string& name, const FreeSpace& space, const std::string& source,
                        const std::string& theirs, const std::string& built_for) {
  if (const std::string ours = fingerprint(space.world()); theirs != ours)
    throw InputError(name, 0,
                     fmt::format("was built of {} (fingerprint {}), not of {} (fingerprint {})", source, theirs,
                                 one_line(space.world().source()), ours));
  if (const std::string robot = robot_text(space.footprint()); built_for != robot)
    throw InputError(name, 0, fmt::format("was built for the robot `{}`, not for `{}`", built_for, robot));
}

}  // namespace taut::detail
