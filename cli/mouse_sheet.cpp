#include <taut/cli/mouse_sheet.h>
#include <taut/io/colour_scale.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include <taut/io/detail/svg_path.h>

namespace taut::cli {

namespace {

using detail::svg_number;
using detail::xml_text;
using micromouse::CellSide;

constexpr double kMap = 960, kWidestCell = 48, kMargin = 24, kNarrowest = 660, kRow = 24;

constexpr std::string_view kColours = R"(
.mouse{font:14px system-ui,sans-serif}
.mouse .page{fill:#f7f6f2}
.mouse .floor{fill:#fff}
.mouse .sight{fill-opacity:.3}
.mouse .goal{fill:#7a3fd4;fill-opacity:.22}
.mouse .start{fill:#1d8f5a;fill-opacity:.25}
.mouse .posts{fill:#c03a2b}
.mouse .seen{stroke:#2c3440;fill:none}
.mouse .unseen{stroke:#9aa3b2;fill:none}
.mouse .run1{stroke:#2f6fb5;fill:none;stroke-opacity:.75}
.mouse .run2{stroke:#e0651c;fill:none}
.mouse .fastest{stroke:#1d8f5a;fill:none}
.mouse .wedge{fill:#c2185b;stroke:#fff}
.mouse .flood{fill:#5a6474}
.mouse .legend{fill:#2c3440}
.mouse .legend .fact{fill:#5a6474}
@media(prefers-color-scheme:dark){
.mouse .page{fill:#15181d}
.mouse .floor{fill:#1f242c}
.mouse .seen{stroke:#e8ebf0}
.mouse .unseen{stroke:#5a6474}
.mouse .run1{stroke:#76b1ef}
.mouse .fastest{stroke:#4fd093}
.mouse .flood,.mouse .legend .fact{fill:#a3adbc}
.mouse .legend{fill:#e8ebf0}
}
)";

double key_width(const MouseSheet::Key& key) { return 34 + 7.6 * static_cast<double>(key.label.size()) + 22; }

std::string scale_sample(double x, double y) {
  std::string out;
  for (int i = 0; i < 6; ++i)
    out += fmt::format(R"(<rect class="sight" x="{}" y="{}" width="4.2" height="14" fill="{}"/>)",
                       svg_number(x + 4.2 * i), svg_number(y - 12), shade_colour(i / 5.0));
  return out;
}

std::string sample(const MouseSheet::Key& key, double x, double y) {
  if (key.group == "scale") return scale_sample(x, y);
  if (key.group == "flood")
    return fmt::format(R"(<text class="fact" x="{}" y="{}">7</text>)", svg_number(x + 8), svg_number(y));
  if (key.group == "goal" || key.group == "start")
    return fmt::format(R"(<rect class="{}" x="{}" y="{}" width="24" height="14"/>)", key.group, svg_number(x),
                       svg_number(y - 12));
  return fmt::format(R"(<g class="{}"><path d="M{} {}h24"/></g>)", key.group, svg_number(x), svg_number(y - 5));
}

}  // namespace

Point middle(Cell cell) { return {cell.x + 0.5, cell.y + 0.5}; }

std::vector<CellSide> standing_walls(const GridMaze& maze) {
  std::vector<CellSide> walls;
  for (int y = 0; y < maze.height(); ++y)
    for (int x = 0; x < maze.width(); ++x)
      for (const Side side : kSides)
        if (maze.wall({x, y}, side) && micromouse::canonical({{x, y}, side}) == CellSide{{x, y}, side})
          walls.push_back({{x, y}, side});
  return walls;
}

MouseSheet::MouseSheet(const GridMaze& maze, std::string title, std::vector<std::string> facts, std::vector<Key> keys)
    : maze_(maze), title_(std::move(title)), facts_(std::move(facts)), keys_(std::move(keys)) {
  pitch_ = std::min(kWidestCell, kMap / std::max(maze.width(), maze.height()));
  width_ = std::max(kNarrowest, pitch_ * maze.width() + 2 * kMargin);
  map_height_ = pitch_ * maze.height() + 2 * kMargin;
}

Point MouseSheet::pixel(Point p) const {
  return {(width_ - pitch_ * maze_.width()) / 2 + pitch_ * p.x, kMargin + pitch_ * (maze_.height() - p.y)};
}

Point MouseSheet::pixel(Cell cell) const { return pixel(middle(cell)); }

std::string MouseSheet::head() const {
  const double height = map_height_ + kRow * (2 + key_rows().second) + 4;
  return fmt::format(
             R"(<svg xmlns="http://www.w3.org/2000/svg" class="mouse" width="{0}" height="{1}" viewBox="0 0 {0} {1}">)",
             svg_number(width_), svg_number(height)) +
         "\n<title>" + xml_text(title_) + "</title>\n" + style() +
         R"(<rect class="page" width="100%" height="100%"/>)" + "\n" +
         fmt::format(R"(<rect class="floor" x="{}" y="{}" width="{}" height="{}"/>)", svg_number(pixel(Point{0, 0}).x),
                     svg_number(kMargin), svg_number(pitch_ * maze_.width()), svg_number(pitch_ * maze_.height())) +
         "\n" + legend();
}

std::string MouseSheet::style() const {
  const auto css = [&](const char* name, double part, const char* more) {
    return fmt::format(".mouse .{}{{stroke-width:{}{}}}\n", name, svg_number(pitch_ * part), more);
  };
  return "<style>" + std::string(kColours) + css("seen", 0.13, "") +
         css("unseen", 0.05, fmt::format(";stroke-dasharray:{0} {0}", svg_number(pitch_ / 9)).c_str()) +
         css("run1", 0.07, ";stroke-linejoin:round;stroke-linecap:round") +
         css("run2", 0.16, ";stroke-linejoin:round;stroke-linecap:round") +
         css("fastest", 0.08, ";stroke-linejoin:round;stroke-linecap:round") + css("wedge", 0.04, "") +
         fmt::format(".mouse .flood{{font-size:{}px}}\n", svg_number(pitch_ * 0.27)) + "</style>\n";
}

std::pair<std::string, int> MouseSheet::key_rows() const {
  std::string out;
  double x = kMargin;
  int row = 0;
  for (const Key& key : keys_) {
    if (x > kMargin && x + key_width(key) > width_ - kMargin + 22) x = kMargin, ++row;
    const double y = map_height_ + kRow * (2 + row) + 8;
    out += sample(key, x, y) +
           fmt::format(R"(<text x="{}" y="{}">{}</text>)", svg_number(x + 32), svg_number(y), xml_text(key.label)) +
           "\n";
    x += key_width(key);
  }
  return {out, keys_.empty() ? 0 : row + 1};
}

std::string MouseSheet::legend() const {
  const auto text = [&](int row, const char* attributes, const std::string& content) {
    return fmt::format(R"(<text x="{}" y="{}"{}>{}</text>)", svg_number(kMargin),
                       svg_number(map_height_ + 8 + kRow * row), attributes, xml_text(content)) +
           "\n";
  };
  return group("legend", text(0, R"( font-weight="600")", title_) +
                             text(1, R"( class="fact")", fmt::format("{}", fmt::join(facts_, " \xC2\xB7 "))) +
                             key_rows().first);
}

std::string MouseSheet::posts() const {
  const double side = pitch_ * 0.17;
  std::string data;
  for (int y = 0; y <= maze_.height(); ++y)
    for (int x = 0; x <= maze_.width(); ++x) {
      const Point p = pixel(Point{static_cast<double>(x), static_cast<double>(y)});
      data += fmt::format("M{} {}h{}v{}h-{}z", svg_number(p.x - side / 2), svg_number(p.y - side / 2), svg_number(side),
                          svg_number(side), svg_number(side));
    }
  return group("posts", path(data));
}

std::string MouseSheet::goal() const {
  std::string data;
  for (const Cell c : maze_.goal.empty() ? centre_room(maze_.width(), maze_.height()) : maze_.goal) data += square(c);
  return group("goal", path(data));
}

std::string MouseSheet::start() const { return group("start", path(square(maze_.start))); }

std::string MouseSheet::wall(const CellSide& wall) const {
  static constexpr std::array<std::array<double, 4>, 4> kEnds{{{0, 1, 1, 1}, {1, 0, 1, 1}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
  const auto& e = kEnds[static_cast<std::size_t>(wall.side)];
  return line({{wall.cell.x + e[0], wall.cell.y + e[1]}, {wall.cell.x + e[2], wall.cell.y + e[3]}});
}

std::string MouseSheet::square(Cell cell) const {
  const Point p = pixel(Point{static_cast<double>(cell.x), cell.y + 1.0});
  return fmt::format("M{0} {1}h{2}v{2}h-{2}z", svg_number(p.x), svg_number(p.y), svg_number(pitch_));
}

std::string MouseSheet::line(const std::vector<Point>& points) const {
  std::string data;
  for (const Point& point : points) {
    const Point p = pixel(point);
    data += (data.empty() ? "M" : "L") + svg_number(p.x) + " " + svg_number(p.y);
  }
  return data;
}

std::string MouseSheet::wedge() const {
  const auto at = [&](double x, double y) { return svg_number(x * pitch_) + "," + svg_number(y * pitch_) + " "; };
  return "<polygon class=\"wedge\" points=\"" + at(0, -0.32) + at(0.23, 0.26) + at(0, 0.15) + at(-0.23, 0.26) + "\"/>";
}

std::string MouseSheet::placed(Cell cell, double degrees) const {
  const Point p = pixel(cell);
  return fmt::format("translate({} {}) rotate({})", svg_number(p.x), svg_number(p.y), svg_number(degrees));
}

std::string MouseSheet::group(const std::string& name, const std::string& content) {
  return content.empty() ? "" : "<g class=\"" + name + "\">" + content + "</g>\n";
}

std::string MouseSheet::path(const std::string& data) { return data.empty() ? "" : "<path d=\"" + data + "\"/>"; }

}  // namespace taut::cli
