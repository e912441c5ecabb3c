#include <taut/io/pictures/detail/svg_motion.h>

#include <fmt/format.h>

namespace taut::detail {

std::string shown_between(double from, double until, double seconds) {
  return fmt::format(
      "<animate attributeName=\"opacity\" dur=\"{}s\" repeatCount=\"indefinite\" calcMode=\"discrete\" "
      "values=\"0;1;0\" keyTimes=\"0;{:.5f};{:.5f}\"/>",
      svg_number(seconds), from, until);
}

std::string runner_along(const SvgPath& line, double radius, double seconds) {
  return fmt::format(
      "<g class=\"runner\"><circle r=\"{}\"><animateMotion dur=\"{}s\" repeatCount=\"indefinite\" path=\"{}\"/>"
      "</circle></g>\n",
      svg_number(radius), svg_number(seconds), line.text());
}

}  // namespace taut::detail
