#include <taut/io/pictures/detail/svg_style.h>

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include <taut/io/pictures/detail/svg_path.h>

namespace taut::detail {

namespace {

std::string_view label(std::string_view key) {
  if (key == "rooms") return "goal room";
  if (key == "solid") return "out of reach";
  if (key == "gates") return "narrow place";
  if (key == "guides") return "straight line";
  if (key == "moves") return "an end, from where it was given";
  if (key == "views") return "in sight";
  if (key == "discs") return "the disc";
  if (key == "contours") return "equally far from the start";
  if (key == "separation") return "walls between start and goal";
  return key;
}

}  // namespace

double SvgStrokes::wall() const { return std::clamp(0.11 * corridor, 0.5, 5.0); }
double SvgStrokes::path() const { return std::clamp(0.17 * corridor, 1.6, 6.0); }
double SvgStrokes::gate() const { return std::clamp(0.12 * corridor, 2.0, 5.0); }
double SvgStrokes::roadmap() const { return std::clamp(0.03 * corridor, 0.2, 1.4); }
double SvgStrokes::milestone() const { return std::clamp(0.1 * corridor, 1.4, 5.0); }
double SvgStrokes::marker_radius() const { return std::clamp(0.27 * corridor, 6.0, 11.0); }

std::string style(const SvgStrokes& strokes) {
  const auto px = [](double v) { return svg_number(v); };
  return fmt::format(
      ".taut .roadmap,.taut .milestones,.taut .openings,.taut .walls,.taut .separation,.taut .gates,.taut "
      ".shades,.taut "
      ".path{{fill:none;stroke-linecap:round;stroke-linejoin:round}}\n"
      ".taut .roadmap{{stroke-width:{}}}\n"
      ".taut .milestones{{stroke-width:{}}}\n"
      ".taut .openings{{stroke-width:{};stroke-dasharray:{}}}\n"
      ".taut .walls{{stroke-width:{}}}\n"
      ".taut .walls .bar{{stroke-linecap:square}}\n"
      ".taut .separation{{stroke-width:{}}}\n"
      ".taut .gates{{stroke-width:{}}}\n"
      ".taut .path .line{{stroke-width:{}}}\n"
      ".taut .path .casing{{stroke-width:{}}}\n"
      ".taut .sample{{stroke-width:3}}\n"
      ".taut .sample.roadmap{{stroke-width:1.5}}\n"
      ".taut .sample.milestones{{stroke-width:5}}\n"
      ".taut .path.sample .line{{stroke-width:4}}\n"
      ".taut .path.sample .casing{{stroke-width:6}}\n",
      px(strokes.roadmap()), px(strokes.milestone()), px(0.6 * strokes.wall()), px(std::max(2.0, 2 * strokes.wall())),
      px(strokes.wall()), px(std::max(1.7 * strokes.wall(), strokes.path())), px(strokes.gate()), px(strokes.path()),
      px(strokes.path() * 1.5 + 0.4));
}

SvgKey key_of(const std::string& kind) {
  SvgKey key{kind, std::string(label(kind)), SvgKey::Sample::line, {}};
  if (kind == "start" || kind == "goal") key.sample = SvgKey::Sample::marker;
  if (kind == "rooms" || kind == "solid" || kind == "views") key.sample = SvgKey::Sample::patch;
  if (kind == "discs") key.sample = SvgKey::Sample::disc;
  if (kind == "milestones") key.sample = SvgKey::Sample::dot;
  return key;
}

}  // namespace taut::detail
