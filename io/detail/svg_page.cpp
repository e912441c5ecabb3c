#include <taut/io/detail/svg_page.h>

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include <taut/io/detail/svg_path.h>

namespace taut::detail {

namespace {

constexpr double kNarrowest = 480;  // of a page, so that a legend fits
constexpr double kRow = 26;
constexpr double kTitleSize = 19, kTextSize = 15;
constexpr double kSample = 26;  // the width of a key's sample

double text_width(std::string_view text, double size) { return 0.55 * size * static_cast<double>(text.size()); }

std::string_view label(std::string_view key) {
  if (key == "rooms") return "goal room";
  if (key == "solid") return "out of reach";
  if (key == "gates") return "narrow place";
  if (key == "guides") return "straight line";
  if (key == "views") return "in sight";
  if (key == "separation") return "walls between start and goal";
  return key;
}

double key_width(const std::string& key) { return kSample + 8 + text_width(label(key), kTextSize) + 22; }

struct KeyPlace {
  double x;
  int row;
};

// Keys flow from left to right and wrap.
std::vector<KeyPlace> key_places(double page_width, const std::vector<std::string>& keys) {
  std::vector<KeyPlace> places;
  double x = kMargin;
  int row = 0;
  for (const std::string& key : keys) {
    if (x > kMargin && x + key_width(key) > page_width - kMargin + 22) {
      x = kMargin;
      ++row;
    }
    places.push_back({x, row});
    x += key_width(key);
  }
  return places;
}

std::string shortened(std::string text, double width, double size) {
  const auto most = static_cast<std::size_t>(width / (0.55 * size));
  if (text.size() <= most) return text;
  std::size_t from = text.size() - most + 1;  // the end of a path says more than its beginning
  while (from < text.size() && (static_cast<unsigned char>(text[from]) & 0xc0) == 0x80) ++from;
  return "\xE2\x80\xA6" + text.substr(from);
}

std::string sample(const std::string& key, double x, double y) {
  const double middle = x + kSample / 2;
  if (key == "start" || key == "goal") return marker(key, {middle, y}, 7, 100);
  if (key == "rooms" || key == "solid" || key == "views")
    return fmt::format(R"(<g class="{}"><rect x="{}" y="{}" width="{}" height="14" rx="2"/></g>)", key,
                       svg_number(x + 3), svg_number(y - 7), svg_number(kSample - 6));
  const std::string line = fmt::format("M{} {}h{}", svg_number(x + 1), svg_number(y), svg_number(kSample - 2));
  const std::string casing = key == "path" ? fmt::format(R"(<path class="casing" d="{}"/>)", line) : "";
  return fmt::format(R"(<g class="{0} sample">{1}<path class="line" d="{2}"/></g>)", key, casing, line);
}

constexpr std::string_view kColours = R"(
.taut .page{fill:#f7f6f2}
.taut .solid{fill:#ccd2dc;fill-rule:evenodd}
.taut .free{fill:#fff;fill-rule:evenodd}
.taut .rooms{fill:#7a3fd4;fill-opacity:.14}
.taut .views{fill:#e8a713;fill-opacity:.13}
.taut .roadmap{stroke:#a9c9e8}
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
.taut .start{fill:#12965f;stroke:#12965f}
.taut .goal{fill:#7a3fd4;stroke:#7a3fd4}
.taut .rim{stroke:#fff;fill:none}
.taut text{fill:#2c3440}
.taut .facts{fill:#5a6474}
@media (prefers-color-scheme:dark){
.taut .page{fill:#12161d}
.taut .solid{fill:#3c4656}
.taut .free{fill:#1d2430}
.taut .rooms{fill:#b48cff;fill-opacity:.2}
.taut .views{fill:#ffd166;fill-opacity:.13}
.taut .roadmap{stroke:#38608c}
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
.taut .path .casing,.taut .rim{stroke:#12161d}
.taut .start{fill:#35c98c;stroke:#35c98c}
.taut .goal{fill:#b48cff;stroke:#b48cff}
.taut text{fill:#e5e9f0}
.taut .facts{fill:#a4aebd}
}
)";

}  // namespace

double SvgPage::wall_stroke() const { return std::clamp(0.11 * corridor, 0.5, 5.0); }
double SvgPage::path_stroke() const { return std::clamp(0.17 * corridor, 1.6, 6.0); }
double SvgPage::gate_stroke() const { return std::clamp(0.12 * corridor, 2.0, 5.0); }
double SvgPage::roadmap_stroke() const { return std::clamp(0.02 * corridor, 0.15, 1.0); }
double SvgPage::marker_radius() const { return std::clamp(0.27 * corridor, 6.0, 11.0); }

SvgPage page_for(Point aspect, double corridor, const std::vector<std::string>& keys) {
  SvgPage page;
  const double width = aspect.x * kMapPixels, height = aspect.y * kMapPixels;
  page.width = std::max(width + 2 * kMargin, kNarrowest);
  const double left = (page.width - width) / 2;
  page.map = {{left, kMargin}, {left + width, kMargin + height}};
  page.legend_top = page.map.max.y + kMargin;
  const auto places = key_places(page.width, keys);
  const int rows = 2 + (places.empty() ? 0 : places.back().row + 1);
  page.height = page.legend_top + rows * kRow + 10;
  page.corridor = corridor * kMapPixels;
  return page;
}

std::string style(const SvgPage& page) {
  const auto px = [](double v) { return svg_number(v); };
  return fmt::format(
      "<style>{}"
      ".taut .roadmap,.taut .openings,.taut .walls,.taut .separation,.taut .gates,.taut .shades,.taut "
      ".path{{fill:none;stroke-linecap:round;stroke-linejoin:round}}\n"
      ".taut .roadmap{{stroke-width:{}}}\n"
      ".taut .openings{{stroke-width:{};stroke-dasharray:{}}}\n"
      ".taut .walls{{stroke-width:{}}}\n"
      ".taut .walls .bar{{stroke-linecap:square}}\n"
      ".taut .separation{{stroke-width:{}}}\n"
      ".taut .gates{{stroke-width:{}}}\n"
      ".taut .path .line{{stroke-width:{}}}\n"
      ".taut .path .casing{{stroke-width:{}}}\n"
      ".taut .sample{{stroke-width:3}}\n"
      ".taut .sample.roadmap{{stroke-width:1.5}}\n"
      ".taut .path.sample .line{{stroke-width:4}}\n"
      ".taut .path.sample .casing{{stroke-width:6}}\n"
      ".taut text{{font:{}px system-ui,'Segoe UI',Roboto,Helvetica,Arial,sans-serif}}\n"
      ".taut .title{{font-size:{}px;font-weight:600}}\n"
      "</style>\n",
      kColours, px(page.roadmap_stroke()), px(0.6 * page.wall_stroke()), px(std::max(2.0, 2 * page.wall_stroke())),
      px(page.wall_stroke()), px(std::max(1.7 * page.wall_stroke(), page.path_stroke())), px(page.gate_stroke()),
      px(page.path_stroke()), px(page.path_stroke() * 1.5 + 0.4), kTextSize, kTitleSize);
}

std::string legend(const SvgPage& page, const std::string& title, const std::vector<std::string>& facts,
                   const std::vector<std::string>& keys) {
  const double room = page.width - 2 * kMargin;
  std::string out = "<g class=\"legend\">\n";
  const auto line = [&](const char* kind, const std::string& text, double y, double size) {
    out += fmt::format("<text class=\"{}\" x=\"{}\" y=\"{}\">{}</text>\n", kind, svg_number(kMargin), svg_number(y),
                       xml_text(shortened(text, room, size)));
  };
  line("title", title, page.legend_top + 16, kTitleSize);
  line("facts", fmt::format("{}", fmt::join(facts, " \xC2\xB7 ")), page.legend_top + 16 + kRow, kTextSize);
  const auto places = key_places(page.width, keys);
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const double y = page.legend_top + 11 + (2 + places[i].row) * kRow;
    out += sample(keys[i], places[i].x, y);
    out += fmt::format("<text x=\"{}\" y=\"{}\">{}</text>\n", svg_number(places[i].x + kSample + 8), svg_number(y + 5),
                       label(keys[i]));
  }
  return out + "</g>\n";
}

std::string marker(const std::string& kind, Point at, double radius, double corridor) {
  const std::string x = svg_number(at.x), y = svg_number(at.y);
  const auto shape = [&](const char* attributes, double r) {
    if (kind == "start") return fmt::format(R"(<circle {} cx="{}" cy="{}" r="{}"/>)", attributes, x, y, svg_number(r));
    const std::string d = svg_number(1.2 * r);
    return fmt::format(R"(<path {0} d="M{1} {2}m0-{3}l{3} {3}l-{3} {3}l-{3}-{3}z"/>)", attributes, x, y, d);
  };
  std::string out = fmt::format("<g class=\"{}\">", kind);
  if (2 * radius <= 0.75 * corridor) {
    out += shape(R"(class="rim" stroke-width="3")", radius) + shape(R"(stroke="none")", radius);
  } else {
    out += shape(R"(class="rim" stroke-width="5")", radius) +
           shape(R"(fill="none" style="fill:none" stroke-width="2.2")", radius) +
           shape(R"(stroke="none")", std::min(0.3 * radius, 0.4 * corridor));
  }
  return out + "</g>\n";
}

}  // namespace taut::detail
