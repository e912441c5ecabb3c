#include <taut/io/grid_svg.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <taut/io/detail/svg_path.h>

namespace taut {

namespace {

constexpr std::size_t kShades = 64;
constexpr double kPlaySeconds = 8;
constexpr double kPathSeconds = 2;

/// Dark blue to yellow, evenly in lightness: between five colours.
std::string shade_colour(std::size_t shade) {
  constexpr std::array<std::array<double, 3>, 5> kStops{
      {{59, 54, 124}, {49, 104, 142}, {53, 160, 133}, {128, 204, 92}, {247, 228, 80}}};
  const double at = static_cast<double>(shade) / (kShades - 1) * (kStops.size() - 1);
  const auto i = std::min(static_cast<std::size_t>(at), kStops.size() - 2);
  const double part = at - static_cast<double>(i);
  const auto mixed = [&](std::size_t c) {
    return static_cast<int>(std::lround(kStops[i][c] + part * (kStops[i + 1][c] - kStops[i][c])));
  };
  return fmt::format("#{:02x}{:02x}{:02x}", mixed(0), mixed(1), mixed(2));
}

class GridPage {
 public:
  GridPage(const OccupancyGrid& grid, const GridPicture& what) : grid_(grid), what_(what) {
    cell_ = std::clamp(960.0 / std::max(grid.width, grid.height), 0.5, 64.0);
    width_ = std::max(cell_ * grid.width, 420.0) + 2 * kMargin;
    height_ = cell_ * grid.height + 2 * kMargin + 92;
  }

  std::string text() {
    out_ = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"grid\" role=\"img\" viewBox=\"0 0 {0:.2f} {1:.2f}\" "
        "width=\"{0:.2f}\" "
        "height=\"{1:.2f}\">\n<title>{2}</title>\n",
        width_, height_, detail::xml_text(what_.title));
    out_ += "<style>.grid text{font-family:system-ui,sans-serif;fill:#2b3240}.grid .fact{fill:#6b7280}</style>\n";
    out_ += fmt::format("<rect width=\"{:.2f}\" height=\"{:.2f}\" fill=\"#f7f6f2\"/>\n", width_, height_);
    out_ += fmt::format("<g transform=\"translate({0} {0}) scale({1:.6f})\">\n", kMargin, cell_);
    cells();
    if (cell_ >= 6) lines();
    frontier();
    path();
    ends();
    out_ += "</g>\n";
    legend();
    return out_ + "</svg>\n";
  }

 private:
  static constexpr double kMargin = 24;
  static constexpr std::uint8_t kFree = 255, kBlocked = 254;

  void cells() {
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
    const auto put = [&](const std::string& d, const std::string& colour, const std::string& more) {
      if (!d.empty())
        out_ += fmt::format("<path fill=\"{}\" shape-rendering=\"crispEdges\" d=\"{}\"{}\n", colour, d, more);
    };
    put(runs[kFree], "#ffffff", "/>");
    put(runs[kBlocked], "#2b3240", "/>");
    for (std::size_t s = 0; s < kShades; ++s) {
      if (what_.animated) put(runs[s], "#ffffff", "/>");
      put(runs[s], shade_colour(s), appears(kPlaySeconds * static_cast<double>(s) / kShades));
    }
  }

  /// The rest of an element: hidden until then, when it is animated.
  std::string appears(double seconds) const {
    if (!what_.animated) return "/>";
    return fmt::format(
        " visibility=\"hidden\"><set attributeName=\"visibility\" to=\"visible\" begin=\"{:.3f}s\"/></path>", seconds);
  }

  void lines() {
    std::string d;
    for (std::uint32_t c = 0; c <= grid_.width; ++c) d += fmt::format("M{} 0v{}", c, grid_.height);
    for (std::uint32_t r = 0; r <= grid_.height; ++r) d += fmt::format("M0 {}h{}", r, grid_.width);
    out_ += fmt::format("<path stroke=\"#d5d8de\" stroke-width=\"0.02\" fill=\"none\" d=\"{}\"/>\n", d);
  }

  void frontier() {
    std::string d;
    for (const GridPlace& p : what_.frontier)
      d += fmt::format("M{:.2f} {:.2f}h.7v.7h-.7z", p.column + 0.15, p.row + 0.15);
    if (!d.empty())
      out_ +=
          "<path stroke=\"#b4532a\" stroke-width=\"0.12\" fill=\"none\" d=\"" + d + "\"" + appears(kPlaySeconds) + "\n";
  }

  void path() {
    if (what_.path.size() < 2) return;
    std::string d;
    double length = 0;
    for (std::size_t i = 0; i < what_.path.size(); ++i) {
      const GridPlace& p = what_.path[i];
      d += fmt::format("{}{} {}", i == 0 ? "M" : "L", p.column + 0.5, p.row + 0.5);
      if (i > 0)
        length += std::hypot(double(p.column) - what_.path[i - 1].column, double(p.row) - what_.path[i - 1].row);
    }
    const double stroke = std::max(0.22, 2.5 / cell_);
    std::string more = "/>";
    if (what_.animated)
      more = fmt::format(
          " stroke-dasharray=\"{0:.3f}\" stroke-dashoffset=\"{0:.3f}\"><animate attributeName=\"stroke-dashoffset\" "
          "from=\"{0:.3f}\" to=\"0\" begin=\"{1}s\" dur=\"{2}s\" fill=\"freeze\"/></path>",
          length, kPlaySeconds, kPathSeconds);
    out_ += fmt::format(
        "<path stroke=\"#f0580c\" stroke-width=\"{:.3f}\" stroke-linejoin=\"round\" stroke-linecap=\"round\" "
        "fill=\"none\" "
        "d=\"{}\"{}\n",
        stroke, d, more);
  }

  void ends() {
    const double radius = std::max(0.32, 5 / cell_);
    if (what_.start)
      out_ += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{:.3f}\" fill=\"#12925c\"/>\n", what_.start->column + 0.5,
                          what_.start->row + 0.5, radius);
    if (what_.goal)
      out_ +=
          fmt::format("<path fill=\"#7a3fd0\" d=\"M{} {:.3f}l{r:.3f} {r:.3f}l-{r:.3f} {r:.3f}l-{r:.3f} -{r:.3f}z\"/>\n",
                      what_.goal->column + 0.5, what_.goal->row + 0.5 - 1.2 * radius, fmt::arg("r", 1.2 * radius));
  }

  void legend() {
    const double top = kMargin + cell_ * grid_.height;
    out_ += fmt::format("<text x=\"{}\" y=\"{:.2f}\" font-size=\"18\" font-weight=\"600\">{}</text>\n", kMargin,
                        top + 32, detail::xml_text(what_.title));
    std::string facts;
    for (const std::string& fact : what_.facts) facts += (facts.empty() ? "" : " \xC2\xB7 ") + fact;
    out_ += fmt::format("<text class=\"fact\" x=\"{}\" y=\"{:.2f}\" font-size=\"13\">{}</text>\n", kMargin, top + 54,
                        detail::xml_text(facts));
    if (what_.visited.empty()) return;
    out_ += "<defs><linearGradient id=\"order\">";
    for (std::size_t s = 0; s < kShades; s += 9)
      out_ += fmt::format("<stop offset=\"{:.3f}\" stop-color=\"{}\"/>", static_cast<double>(s) / (kShades - 1),
                          shade_colour(s));
    out_ += "</linearGradient></defs>\n";
    out_ += fmt::format("<rect x=\"{}\" y=\"{:.2f}\" width=\"120\" height=\"10\" fill=\"url(#order)\"/>\n", kMargin,
                        top + 70);
    out_ += fmt::format("<text class=\"fact\" x=\"{}\" y=\"{:.2f}\" font-size=\"13\">visited, first to last{}</text>\n",
                        kMargin + 130, top + 79, what_.frontier.empty() ? "" : "; outlined: frontier");
  }

  std::size_t index(GridPlace p) const { return std::size_t{p.row} * grid_.width + p.column; }

  const OccupancyGrid& grid_;
  const GridPicture& what_;
  double cell_ = 1, width_ = 0, height_ = 0;
  std::string out_;
};

}  // namespace

std::string grid_svg(const OccupancyGrid& grid, const GridPicture& picture) { return GridPage(grid, picture).text(); }

}  // namespace taut
