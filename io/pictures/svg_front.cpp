#include <taut/io/pictures/colour_scale.h>
#include <taut/io/pictures/svg_front.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <taut/io/pictures/detail/svg_path.h>
#include <taut/io/pictures/svg_sheet.h>

namespace taut {

namespace {

constexpr double kWidth = 1008;                        // as a square world's picture
constexpr double kLeft = 110, kTop = 70, kSide = 560;  // of the plot
constexpr double kRight = kWidth - 60;
constexpr double kListTop = kTop + kSide + 110, kLine = 25;
constexpr std::size_t kListed = 11;

std::string px(double v) { return detail::svg_number(v); }

/// A round step between ticks, about six of them.
double tick_step(double range) {
  const double rough = range / 6, power = std::pow(10, std::floor(std::log10(rough)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (rough <= factor * power) return factor * power;
  return 10 * power;
}

class Chart {
 public:
  Chart(const SvgPicture& picture, std::span<const SvgStep> steps) : picture_(picture), steps_(steps) {
    most_radius_ = steps.back().radius > 0 ? 1.12 * steps.back().radius : 1;
    const double low = steps.front().length, high = steps.back().length;
    const double room = high > low ? 0.12 * (high - low) : std::max(0.1 * high, 1e-9);
    least_length_ = std::max(0.0, low - room);
    most_length_ = high + room;
  }

  std::string draw() {
    const double height = kListTop + kLine * static_cast<double>(std::min(steps_.size(), kListed) + 1) + 10;
    out_ = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"taut front\" width=\"{0}\" height=\"{1}\" "
        "viewBox=\"0 0 {0} {1}\">\n",
        px(kWidth), px(height));
    text(kLeft, 40, "title", "start", "The price of room");
    axes();
    nothing_larger();
    for (std::size_t i = 0; i < steps_.size(); ++i) step(i);
    list();
    return std::move(out_ += "</svg>\n");
  }

 private:
  double x(double radius) const { return kLeft + radius / most_radius_ * (kRight - kLeft); }
  double y(double length) const {
    return kTop + kSide - (length - least_length_) / (most_length_ - least_length_) * kSide;
  }

  void text(double x, double y, const char* kind, const char* anchor, const std::string& what) {
    out_ += fmt::format("<text class=\"{}\" x=\"{}\" y=\"{}\" text-anchor=\"{}\">{}</text>\n", kind, px(x), px(y),
                        anchor, detail::xml_text(what));
  }

  void line(double x1, double y1, double x2, double y2, const char* style) {
    out_ += fmt::format("<path style=\"{}\" d=\"M{} {}L{} {}\"/>\n", style, px(x1), px(y1), px(x2), px(y2));
  }

  void axes() {
    constexpr const char* kGrid = "fill:none;stroke:#8a94a6;stroke-opacity:.3";
    const double dx = tick_step(most_radius_), dy = tick_step(most_length_ - least_length_);
    for (double i = 0; i * dx <= most_radius_; ++i) {
      line(x(i * dx), kTop, x(i * dx), kTop + kSide, kGrid);
      text(x(i * dx), kTop + kSide + 24, "facts", "middle", fmt::format("{:.6g}", i * dx));
    }
    for (double i = std::ceil(least_length_ / dy); i * dy <= most_length_; ++i) {
      line(kLeft, y(i * dy), kRight, y(i * dy), kGrid);
      text(kLeft - 12, y(i * dy) + 5, "facts", "end", fmt::format("{:.6g}", i * dy));
    }
    text((kLeft + kRight) / 2, kTop + kSide + 54, "facts", "middle", "radius of the robot");
    text(kLeft, kTop - 8, "facts", "start", "length of its best path along the diagram");
  }

  void nothing_larger() {
    const double from = x(steps_.back().radius);
    out_ +=
        fmt::format("<rect style=\"fill:#8a94a6;fill-opacity:.18\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>\n",
                    px(from), px(kTop), px(kRight - from), px(kSide));
    out_ += fmt::format(
        "<text class=\"facts\" text-anchor=\"middle\" transform=\"translate({} {}) rotate(-90)\">no path, "
        "proven</text>\n",
        px((from + kRight) / 2 + 5), px(kTop + kSide / 2));
  }

  std::string colour(std::size_t i) const { return shade_colour(picture_.shades[i].shade); }

  void step(std::size_t i) {
    const double from = i ? steps_[i - 1].radius : 0, level = y(steps_[i].length);
    if (i)
      line(x(from), y(steps_[i - 1].length), x(from), level,
           "fill:none;stroke:#8a94a6;stroke-width:1.5;stroke-dasharray:3 4");
    line(x(from), level, x(steps_[i].radius), level,
         fmt::format("fill:none;stroke:{};stroke-width:6;stroke-linecap:butt", colour(i)).c_str());
    out_ += fmt::format("<circle style=\"fill:{}\" cx=\"{}\" cy=\"{}\" r=\"6\"/>\n", colour(i), px(x(steps_[i].radius)),
                        px(level));
  }

  void list() {
    const std::array<double, 3> columns{kLeft + 90, kLeft + 230, kLeft + 260};
    double at = kListTop;
    text(columns[0], at, "facts", "end", "radius up to");
    text(columns[1], at, "facts", "end", "length");
    text(columns[2], at, "facts", "start", "narrowest");
    const std::size_t all = steps_.size(), shown = std::min(all, kListed);
    for (std::size_t row = 0; row < shown; ++row) {
      at += kLine;
      // Of many the first half and the last; a line between says how many are left out.
      const bool gap = all > kListed && row == shown / 2;
      if (gap) {
        text(columns[2], at, "facts", "start", fmt::format("\xE2\x80\xA6 {} more", all - shown + 1));
        continue;
      }
      const std::size_t i = row < shown / 2 || all <= kListed ? row : all - shown + row;
      out_ += fmt::format("<rect style=\"fill:{}\" x=\"{}\" y=\"{}\" width=\"26\" height=\"6\"/>\n", colour(i),
                          px(kLeft - 40), px(at - 8));
      text(columns[0], at, "", "end", fmt::format("{:.6g}", steps_[i].radius));
      text(columns[1], at, "", "end", fmt::format("{:.6f}", steps_[i].length));
      text(columns[2], at, "facts", "start", steps_[i].place);
    }
  }

  const SvgPicture& picture_;
  std::span<const SvgStep> steps_;
  double most_radius_ = 1, least_length_ = 0, most_length_ = 1;
  std::string out_;
};

}  // namespace

std::string svg_front(const FreeSpace& space, const SvgPicture& picture, std::span<const SvgStep> steps) {
  const std::array<std::string, 2> pictures{svg(space, picture), Chart(picture, steps).draw()};
  return svg_sheet(pictures, 2);
}

}  // namespace taut
