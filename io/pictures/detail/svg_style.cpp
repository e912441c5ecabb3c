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
  if (key == "views") return "in sight";
  if (key == "discs") return "the disc";
  if (key == "separation") return "walls between start and goal";
  return key;
}

constexpr std::string_view kColours = R"(
.taut .solid{fill:#ccd2dc;fill-rule:evenodd}
.taut .free{fill:#fff;fill-rule:evenodd}
.taut .rooms{fill:#7a3fd4;fill-opacity:.14}
.taut .views{fill:#e8a713;fill-opacity:.13}
.taut .roadmap{stroke:#8fb6dc}
.taut .milestones{stroke:#3f7fbf}
.taut .discs{fill:#ee5a10;fill-opacity:.16;stroke:#ee5a10;stroke-width:1.5}
.taut .openings{stroke:#b9bfca}
.taut .walls{stroke:#2c3440}
.taut .walls .bar{stroke:#4b5668}
.taut .walls .area{fill:#4b5668;fill-rule:evenodd;stroke:none}
.taut .separation{stroke:#d3245e}
.taut .gates{stroke:#0b7fc1}
.taut .guides{fill:none;stroke:#0b7fc1;stroke-width:1.5;stroke-dasharray:6 4}
.taut .labels text{font-weight:bold;stroke:#fff;stroke-width:3;paint-order:stroke}
.taut .runner{fill:#0b7fc1}
.taut .path .line{stroke:#ee5a10}
.taut .path .casing{stroke:#fff}
@media (prefers-color-scheme:dark){
.taut .solid{fill:#3c4656}
.taut .free{fill:#1d2430}
.taut .rooms{fill:#b48cff;fill-opacity:.2}
.taut .views{fill:#ffd166;fill-opacity:.13}
.taut .roadmap{stroke:#47749f}
.taut .milestones{stroke:#7db4ea}
.taut .discs{fill:#ff8340;stroke:#ff8340}
.taut .openings{stroke:#566274}
.taut .walls{stroke:#d4dbe6}
.taut .walls .bar{stroke:#8e9aad}
.taut .walls .area{fill:#8e9aad}
.taut .separation{stroke:#ff5c8d}
.taut .gates{stroke:#4cc2ff}
.taut .guides{stroke:#4cc2ff}
.taut .labels{fill:#e5e9f0}
.taut .labels text{stroke:#12161d}
.taut .runner{fill:#4cc2ff}
.taut .path .line{stroke:#ff8340}
.taut .path .casing{stroke:#12161d}
}
)";

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
      "{}"
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
      kColours, px(strokes.roadmap()), px(strokes.milestone()), px(0.6 * strokes.wall()),
      px(std::max(2.0, 2 * strokes.wall())), px(strokes.wall()), px(std::max(1.7 * strokes.wall(), strokes.path())),
      px(strokes.gate()), px(strokes.path()), px(strokes.path() * 1.5 + 0.4));
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
