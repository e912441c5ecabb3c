#include <taut/io/pictures/colour_scale.h>
#include <taut/io/pictures/svg_front.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <taut/io/pictures/detail/svg_frame.h>
#include <taut/io/pictures/detail/svg_layers.h>
#include <taut/io/pictures/detail/svg_motion.h>
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

std::string changing(const char* what, const SvgFilm& film, const std::string& values) {
  return fmt::format(
      "<animate attributeName=\"{}\" dur=\"{}s\" repeatCount=\"indefinite\" calcMode=\"discrete\" values=\"{}\"/>",
      what, px(film.seconds), values);
}

/// What the disc sweeps, and its way.
std::string swept(const FreeSpace& space, const detail::SvgFrame& frame, const SvgFilm& film) {
  const detail::SvgLayers layers(space, frame.map().min, detail::kMapPixels);
  std::string ways, widths;
  for (const SvgFilm::Moment& moment : film.moments) {
    detail::SvgPath path(layers.scale());
    path.chain(moment.curves);
    ways += (ways.empty() ? "" : ";") + path.text();
    widths += (widths.empty() ? "" : ";") + px(2 * layers.scale().length(moment.radius));
  }
  // Where nothing moves, the last of them.
  const std::string last = ways.substr(ways.rfind(';') + 1), moves = changing("d", film, ways);
  return fmt::format(
      "<g class=\"film moving\"><path style=\"fill:none;stroke:#e8873a;stroke-opacity:.45;stroke-linecap:round;"
      "stroke-linejoin:round\" stroke-width=\"{}\" d=\"{}\">{}{}</path><path "
      "style=\"fill:none;stroke:#b4470b;stroke-width:2\" d=\"{}\">{}</path></g>\n",
      widths.substr(widths.rfind(';') + 1), last, moves, changing("stroke-width", film, widths), last, moves);
}

class Chart {
 public:
  Chart(const SvgPicture& picture, std::span<const SvgStep> steps, const SvgFrontWords& words)
      : picture_(picture), steps_(steps), words_(words) {
    most_radius_ = steps.back().radius > 0 ? 1.12 * steps.back().radius : 1;
    const double low = begin(0).y, high = steps.back().length;
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

  /// A dot that follows the film.
  std::string runner() const {
    const SvgFilm& film = words_.film;
    std::string xs, ys;
    for (const SvgFilm::Moment& moment : film.moments) {
      xs += (xs.empty() ? "" : ";") + px(x(moment.radius));
      ys += (ys.empty() ? "" : ";") + px(y(moment.length));
    }
    return fmt::format(
        "<circle class=\"moving\" style=\"fill:#e8873a;stroke:#fff;stroke-width:2\" r=\"9\" cx=\"{}\" "
        "cy=\"{}\">{}{}</circle>",
        px(x(film.moments.back().radius)), px(y(film.moments.back().length)), changing("cx", film, xs),
        changing("cy", film, ys));
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
    text(kLeft, kTop - 8, "facts", "start", words_.length);
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

  /// Where a step begins.
  Point begin(std::size_t i) const {
    if (!steps_[i].curve.empty()) return steps_[i].curve.front();
    return {i ? steps_[i - 1].radius : 0, steps_[i].length};
  }

  void step(std::size_t i) {
    const Point from = begin(i);
    const double level = y(steps_[i].length);
    if (i)
      line(x(from.x), y(steps_[i - 1].length), x(from.x), y(from.y),
           "fill:none;stroke:#8a94a6;stroke-width:1.5;stroke-dasharray:3 4");
    std::string d = fmt::format("M{} {}", px(x(from.x)), px(y(from.y)));
    for (const Point p : steps_[i].curve) d += fmt::format("L{} {}", px(x(p.x)), px(y(p.y)));
    out_ += fmt::format("<path style=\"fill:none;stroke:{};stroke-width:6;stroke-linecap:butt\" d=\"{}L{} {}\"/>\n",
                        colour(i), d, px(x(steps_[i].radius)), px(level));
    out_ += fmt::format("<circle style=\"fill:{}\" cx=\"{}\" cy=\"{}\" r=\"6\"/>\n", colour(i), px(x(steps_[i].radius)),
                        px(level));
  }

  void list() {
    const std::array<double, 3> columns{kLeft + 90, kLeft + 230, kLeft + 260};
    double at = kListTop;
    text(columns[0], at, "facts", "end", "radius up to");
    text(columns[1], at, "facts", "end", "length");
    text(columns[2], at, "facts", "start", words_.place);
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
  const SvgFrontWords& words_;
  double most_radius_ = 1, least_length_ = 0, most_length_ = 1;
  std::string out_;
};

/// On the sheet itself, so that one clock and one button hold for both.
std::string film_layer(const FreeSpace& space, const Chart& chart, const SvgFilm& film) {
  const detail::SvgFrame frame(detail::SvgLayers::size(space.world(), detail::kMapPixels), "", {}, {});
  const double width = std::max(frame.width(), kWidth);
  return swept(space, frame, film) +
         fmt::format("<g transform=\"translate({} 0)\">{}</g>\n", px(width), chart.runner()) +
         detail::film_controls({2 * width - 4, 3});
}

}  // namespace

std::string svg_front(const FreeSpace& space, const SvgPicture& picture, std::span<const SvgStep> steps,
                      const SvgFrontWords& words) {
  Chart chart(picture, steps, words);
  const std::array<std::string, 2> pictures{svg(space, picture), chart.draw()};
  std::string sheet = svg_sheet(pictures, 2);
  if (words.film.moments.empty()) return sheet;
  sheet.insert(sheet.rfind("</svg>"), film_layer(space, chart, words.film));
  return sheet.insert(sizeof "<svg" - 1, " class=\"taut\"");
}

}  // namespace taut
