#include <taut/io/pictures/detail/mouse_sheet.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include <taut/io/pictures/detail/svg_motion.h>
#include <taut/io/pictures/detail/svg_path.h>

namespace taut::detail {

namespace {

using micromouse::CellSide;

constexpr double kWidestCell = 48;

constexpr std::string_view kColours = R"(
.taut.mouse .floor{fill:#fff}
.taut.mouse .sight{fill-opacity:.3}
.taut.mouse .rooms{fill:#7a3fd4;fill-opacity:.14}
.taut.mouse .posts{fill:#c03a2b}
.taut.mouse .seen{stroke:#2c3440;fill:none}
.taut.mouse .unseen{stroke:#9aa3b2;fill:none}
.taut.mouse .run1,.taut.mouse .shortest{stroke:#0b7fc1;fill:none}
.taut.mouse .run2,.taut.mouse .fastest{stroke:#ee5a10;fill:none}
.taut.mouse .wedge{fill:#ee5a10;stroke:#fff}
.taut.mouse .flood,.taut.mouse .flood text{fill:#5a6474}
@media(prefers-color-scheme:dark){
.taut.mouse .floor{fill:#1d2430}
.taut.mouse .rooms{fill:#b48cff;fill-opacity:.2}
.taut.mouse .posts{fill:#e0705f}
.taut.mouse .seen{stroke:#d4dbe6}
.taut.mouse .unseen{stroke:#5a6474}
.taut.mouse .run1,.taut.mouse .shortest{stroke:#4cc2ff}
.taut.mouse .run2,.taut.mouse .fastest{stroke:#ff8340}
.taut.mouse .wedge{fill:#ff8340;stroke:#12161d}
.taut.mouse .flood,.taut.mouse .flood text{fill:#a3adbc}
}
)";

}  // namespace

namespace {

std::vector<SvgKey> with_ruler(std::vector<SvgKey> keys, double pitch) {
  keys.push_back(ruler_key(pitch, "cell", "cells"));
  return keys;
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

MouseSheet::MouseSheet(const GridMaze& maze, std::string title, std::vector<std::string> facts,
                       std::vector<SvgKey> keys)
    : maze_(maze),
      pitch_(std::min(kWidestCell, kMapPixels / std::max(maze.width(), maze.height()))),
      frame_({pitch_ * maze.width(), pitch_ * maze.height()}, std::move(title), std::move(facts),
             with_ruler(std::move(keys), pitch_)) {}

std::string MouseSheet::controls() const { return film_controls({frame_.width() - 4, 3}); }

Point MouseSheet::pixel(Point p) const {
  return {frame_.map().min.x + pitch_ * p.x, frame_.map().max.y - pitch_ * p.y};
}

Point MouseSheet::pixel(Cell cell) const { return pixel(middle(cell)); }

std::string MouseSheet::head() const {
  return frame_.head("mouse", style()) +
         fmt::format(R"(<rect class="floor" x="{}" y="{}" width="{}" height="{}"/>)", svg_number(frame_.map().min.x),
                     svg_number(frame_.map().min.y), svg_number(pitch_ * maze_.width()),
                     svg_number(pitch_ * maze_.height())) +
         "\n";
}

std::string MouseSheet::style() const {
  const auto css = [&](const char* name, double part, const char* more) {
    return fmt::format(".taut.mouse .{}{{stroke-width:{}{}}}\n", name, svg_number(pitch_ * part), more);
  };
  return std::string(kColours) + css("seen", 0.13, "") +
         css("unseen", 0.05, fmt::format(";stroke-dasharray:{0} {0}", svg_number(pitch_ / 9)).c_str()) +
         css("run1", 0.07, ";stroke-linejoin:round;stroke-linecap:round") +
         css("run2", 0.16, ";stroke-linejoin:round;stroke-linecap:round") +
         css("shortest", 0.16, ";stroke-linejoin:round;stroke-linecap:round;stroke-opacity:.75") +
         css("fastest", 0.08, ";stroke-linejoin:round;stroke-linecap:round") + css("wedge", 0.04, "") +
         fmt::format(".taut.mouse .flood text{{font-size:{}px}}\n.taut.mouse .marks text{{font-size:{}px}}\n",
                     svg_number(pitch_ * 0.27), svg_number(pitch_ * 0.2));
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

std::vector<Cell> MouseSheet::goal_cells() const {
  return maze_.goal.empty() ? centre_room(maze_.width(), maze_.height()) : maze_.goal;
}

std::string MouseSheet::goal_room() const {
  std::string data;
  for (const Cell c : goal_cells()) data += square(c);
  return group("rooms", path(data));
}

std::string MouseSheet::ends() const {
  const std::vector<Cell> goal = goal_cells();
  Point sum;
  for (const Cell c : goal) sum = {sum.x + middle(c).x, sum.y + middle(c).y};
  const auto count = static_cast<double>(goal.size());
  const double radius = std::clamp(0.27 * pitch_, 4.0, 11.0);
  return marker("start", pixel(maze_.start), radius, pitch_) +
         marker("goal", pixel(Point{sum.x / count, sum.y / count}), radius, pitch_);
}

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

}  // namespace taut::detail
