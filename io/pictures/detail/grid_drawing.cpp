#include <taut/io/pictures/detail/grid_drawing.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <taut/io/pictures/colour_scale.h>

namespace taut::detail {

namespace {

constexpr std::size_t kShades = 64;

std::string colour_of(std::size_t shade) { return flood_colour(static_cast<double>(shade) / (kShades - 1)); }

}  // namespace

std::string GridDrawing::style() {
  return ".taut.grid .path .line{fill:none;stroke-linejoin:round;stroke-linecap:round}\n";
}

std::vector<SvgKey> GridDrawing::keys(const GridPicture& picture) {
  using enum SvgKey::Sample;
  std::vector<SvgKey> keys;
  if (picture.start) keys.push_back({"start", "start", marker, {}});
  if (picture.goal) keys.push_back({"goal", "goal", marker, {}});
  if (picture.path.size() >= 2) keys.push_back({"path", "path", line, {}});
  if (!picture.frontier.empty()) keys.push_back({"frontier", "frontier", line, {}});
  if (!picture.visited.empty()) {
    std::vector<std::string> colours;
    for (std::size_t s = 0; s < kShades; s += 3) colours.push_back(colour_of(s));
    keys.push_back({"visited", "visited, first to last", scale, std::move(colours)});
  }
  keys.push_back({"obstacle", "blocked", patch});
  return keys;
}

std::string GridDrawing::text() {
  out_ = fmt::format("<g transform=\"translate({:.3f} {:.3f}) scale({:.6f})\">\n", corner_.x, corner_.y, cell_);
  cells();
  if (cell_ >= 6) lines();
  frontier();
  path();
  out_ += "</g>\n";
  ends();
  return std::move(out_);
}

void GridDrawing::cells() {
  std::vector<std::uint8_t> kind(grid_.blocked.size(), kFree);
  for (std::size_t i = 0; i < kind.size(); ++i)
    if (grid_.blocked[i] != 0) kind[i] = kBlocked;
  const std::size_t count = std::max<std::size_t>(what_.visited.size(), 1);
  for (std::size_t n = what_.visited.size(); n-- > 0;)  // the first taking counts
    kind[index(what_.visited[n])] = static_cast<std::uint8_t>(n * kShades / count);
  std::array<std::string, 256> runs;
  for (std::uint32_t row = 0; row < grid_.height; ++row)
    for (std::uint32_t column = 0, end; column < grid_.width; column = end) {
      const std::uint8_t here = kind[index({row, column})];
      for (end = column + 1; end < grid_.width && kind[index({row, end})] == here;) ++end;
      runs[here] += fmt::format("M{} {}h{}v1h-{}z", column, row, end - column, end - column);
    }
  const auto put = [&](const std::string& d, const std::string& ink, const std::string& more) {
    if (!d.empty()) out_ += fmt::format("<path {} shape-rendering=\"crispEdges\" d=\"{}\"{}\n", ink, d, more);
  };
  put(runs[kFree], "class=\"free\"", "/>");
  put(runs[kBlocked], "class=\"obstacle\"", "/>");
  for (std::size_t s = 0; s < kShades; ++s) {
    if (what_.animated) put(runs[s], "class=\"free\"", "/>");
    put(runs[s], fmt::format("class=\"appears\" fill=\"{}\"", colour_of(s)),
        appears(kGridPlaySeconds * static_cast<double>(s) / kShades));
  }
}

// The rest of an element: hidden until then, when it is animated.
std::string GridDrawing::appears(double seconds) const {
  if (!what_.animated) return "/>";
  return fmt::format(
      " visibility=\"hidden\"><set attributeName=\"visibility\" to=\"visible\" begin=\"{:.3f}s\"/></path>", seconds);
}

void GridDrawing::lines() {
  std::string d;
  for (std::uint32_t c = 0; c <= grid_.width; ++c) d += fmt::format("M{} 0v{}", c, grid_.height);
  for (std::uint32_t r = 0; r <= grid_.height; ++r) d += fmt::format("M0 {}h{}", r, grid_.width);
  out_ += fmt::format("<path class=\"grid\" stroke-width=\"0.02\" d=\"{}\"/>\n", d);
}

void GridDrawing::frontier() {
  std::string d;
  for (const GridPlace& p : what_.frontier)
    d += fmt::format("M{:.2f} {:.2f}h.7v.7h-.7z", p.column + 0.15, p.row + 0.15);
  if (!d.empty())
    out_ += "<path class=\"frontier appears\" stroke-width=\"0.12\" d=\"" + d + "\"" + appears(kGridPlaySeconds) + "\n";
}

void GridDrawing::path() {
  if (what_.path.size() < 2) return;
  std::string d;
  double length = 0;
  for (std::size_t i = 0; i < what_.path.size(); ++i) {
    const GridPlace& p = what_.path[i];
    d += fmt::format("{}{} {}", i == 0 ? "M" : "L", p.column + 0.5, p.row + 0.5);
    if (i > 0) length += std::hypot(double(p.column) - what_.path[i - 1].column, double(p.row) - what_.path[i - 1].row);
  }
  const double stroke = std::max(0.22, 2.5 / cell_);
  std::string more = "/>";
  if (what_.animated)
    more = fmt::format(
        " stroke-dasharray=\"{0:.3f}\" stroke-dashoffset=\"{0:.3f}\"><animate attributeName=\"stroke-dashoffset\" "
        "from=\"{0:.3f}\" to=\"0\" begin=\"{1}s\" dur=\"{2}s\" fill=\"freeze\"/></path>",
        length, kGridPlaySeconds, kGridPathSeconds);
  out_ += fmt::format("<g class=\"path\"><path class=\"line appears\" stroke-width=\"{:.3f}\" d=\"{}\"{}</g>\n", stroke,
                      d, more);
}

void GridDrawing::ends() {
  const double radius = std::clamp(0.32 * cell_, 5.0, 14.0);
  const auto put = [&](const char* kind, const std::optional<GridPlace>& place) {
    if (!place) return;
    const Point at{corner_.x + cell_ * (place->column + 0.5), corner_.y + cell_ * (place->row + 0.5)};
    out_ += marker(kind, at, radius, cell_);
  };
  put("start", what_.start);
  put("goal", what_.goal);
}

}  // namespace taut::detail
