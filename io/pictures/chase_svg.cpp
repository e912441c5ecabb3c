#include <taut/io/pictures/chase_svg.h>

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include <taut/io/pictures/detail/svg_frame.h>
#include <taut/io/pictures/detail/svg_motion.h>
#include <taut/io/pictures/png.h>

namespace taut::pursuit {

namespace {

constexpr int kMostPixels = 1000;
constexpr Pixel kWall{75, 86, 104};  // as .obstacle

// On a dark page the map is turned to its negative, its hues kept: dear cells stay the ones that stand out.
constexpr const char* kStyle = R"(.taut.chase .way{fill:none;stroke-width:3;stroke-linejoin:round;stroke-linecap:round}
.taut.chase .casing{stroke-width:5.5;stroke-opacity:.8}
.taut.chase .rest{stroke-width:1.5;stroke-dasharray:3 5}
.taut.chase .mark circle{fill:#fff;stroke-width:2.5}
.taut.chase .mark text{font-size:12px;paint-order:stroke;stroke:#fff;stroke-width:3px;stroke-linejoin:round}
.taut.chase .forward text{fill:#b8430a}
.taut.chase .target text{fill:#5f2bb0}
.taut.chase circle.target{fill:#7a3fd4;stroke:#fff;stroke-width:2}
.taut.chase image{image-rendering:pixelated}
@media (prefers-color-scheme:dark){
.taut.chase image,.taut.chase .cost{filter:invert(1) hue-rotate(180deg)}
.taut.chase .mark circle{fill:#12161d}
.taut.chase .mark text{stroke:#12161d}
.taut.chase .forward text{fill:#ffa06b}
.taut.chase .target text{fill:#cdb3ff}
.taut.chase circle.target{fill:#b48cff;stroke:#12161d}
}
)";

std::string colour_of(const Pixel& p) { return fmt::format("#{:02x}{:02x}{:02x}", p[0], p[1], p[2]); }

/// Cells as shades: the dearer the darker, by orders of magnitude.
class Shades {
 public:
  explicit Shades(const ChaseMap& map) {
    for (const std::uint32_t cost : map.costs())
      if (cost != ChaseMap::kObstacle) {
        least_ = std::min(least_, cost);
        most_ = std::max(most_, cost);
      }
  }
  Pixel of(double cost) const {
    const double range = std::log1p(static_cast<double>(most_) - static_cast<double>(least_));
    const double at = range > 0 ? std::log1p(std::max(0.0, cost - static_cast<double>(least_))) / range : 0;
    const auto mix = [&](double light, double dark) { return static_cast<std::uint8_t>(light + (dark - light) * at); };
    return {mix(252, 206), mix(250, 150), mix(244, 92)};
  }
  std::uint32_t least() const { return least_; }
  std::uint32_t most() const { return most_; }
  /// From the least to the greatest, in equal steps of shade.
  std::vector<std::string> scale() const {
    std::vector<std::string> colours;
    colours.reserve(24);
    const double range = std::log1p(static_cast<double>(most_) - static_cast<double>(least_));
    for (int i = 0; i < 24; ++i) {
      colours.push_back(colour_of(of(least_ + std::expm1(range * i / 23))));
    }
    return colours;
  }

 private:
  std::uint32_t least_ = ChaseMap::kObstacle;
  std::uint32_t most_ = 0;
};

Pixel block(const ChaseMap& map, const Shades& shades, int x0, int y0, int side) {
  double sum = 0;
  int free = 0, walls = 0;
  for (int x = x0; x < std::min(x0 + side, map.x_size() + 1); ++x)
    for (int y = y0; y < std::min(y0 + side, map.y_size() + 1); ++y) {
      const CellIndex cell = map.index({x, y});
      if (map.is_free(cell)) {
        sum += map.cost(cell);
        ++free;
      } else {
        ++walls;
      }
    }
  return 2 * walls >= free + walls ? kWall : shades.of(sum / free);
}

Pixels pixels_of(const ChaseMap& map, const Shades& shades, int side) {
  Pixels image{(map.x_size() + side - 1) / side, (map.y_size() + side - 1) / side, {}};
  for (int row = image.height - 1; row >= 0; --row)
    for (int column = 0; column < image.width; ++column)
      image.pixels.push_back(block(map, shades, 1 + column * side, 1 + row * side, side));
  return image;
}

/// Each pixel becomes times x times: not every viewer heeds image-rendering and leaves cells sharp.
Pixels enlarged(const Pixels& image, int times) {
  Pixels out{image.width * times, image.height * times, {}};
  for (int row = 0; row < out.height; ++row)
    for (int column = 0; column < out.width; ++column)
      out.pixels.push_back(image.pixels[static_cast<std::size_t>(row / times * image.width + column / times)]);
  return out;
}

/// A round number of seconds between marks.
int mark_step(int seconds) {
  int step = 1;
  for (const int times : {2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000})
    if (seconds / step > 8) step = times;
  return step;
}

constexpr double kDigit = 7, kLine = 12;  // the size of a label's letters, roughly

struct Label {
  double x = 0, y = 0, width = 0;
  bool overlaps(const Label& other) const {
    return x < other.x + other.width && other.x < x + width && std::abs(y - other.y) < kLine;
  }
};

class Picture {
 public:
  Picture(const ChaseMap& map, const ChaseRun& run, const std::string& title)
      : map_(map),
        run_(run),
        shades_(map),
        scale_(taut::detail::kMapPixels / std::max(map.x_size(), map.y_size())),
        width_(scale_ * map.x_size()),
        height_(scale_ * map.y_size()),
        frame_({width_, height_}, title, facts(), keys()) {
    const std::vector<ChaseStep>& track = run.result.track;
    for (std::size_t i = 0; i + 1 < track.size(); ++i)
      robot_.insert(robot_.end(), static_cast<std::size_t>(track[i + 1].second - track[i].second), track[i].cell);
    robot_.push_back(track.back().cell);
  }

  std::string drawn(bool moves) {
    out_ = frame_.head("chase", kStyle);
    out_ += fmt::format("<g transform=\"translate({:.2f} {:.2f})\">\n", frame_.map().min.x, frame_.map().min.y);
    draw_map();
    draw_ways();
    draw_marks();
    if (moves) draw_runners();
    out_ += "</g>\n";
    if (moves) out_ += taut::detail::film_controls({frame_.width() - 4, 3});
    return out_ + frame_.foot();
  }

 private:
  std::pair<double, double> place(CellIndex cell) const {
    const Cell c = map_.cell(cell);
    return {(c.x - 0.5) * scale_, height_ - (c.y - 0.5) * scale_};
  }
  std::size_t shift() const { return run_.request.clock == Clock::one ? 1 : 0; }
  int seconds() const { return static_cast<int>(robot_.size()) - 1; }
  /// Where the target is at a second; at its ends before and after.
  CellIndex target(int second) const {
    const std::size_t at = static_cast<std::size_t>(second) < shift() ? 0 : static_cast<std::size_t>(second) - shift();
    return map_.target()[std::min(at, map_.duration() - 1)];
  }

  void draw_map() {
    const int side = (std::max(map_.x_size(), map_.y_size()) + kMostPixels - 1) / kMostPixels;
    const Pixels image = pixels_of(map_, shades_, side);
    const int times = std::max(1, kMostPixels / std::max(image.width, image.height));
    const double height = scale_ * side * image.height;  // the blocks at the top and at the right may stick out
    out_ += fmt::format(
        "<svg width=\"{:.2f}\" height=\"{:.2f}\"><image y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" "
        "preserveAspectRatio=\"none\" href=\"{}\"/></svg>\n",
        width_, height_, height_ - height, scale_ * side * image.width, height, png_address(enlarged(image, times)));
  }

  std::string line(const std::vector<CellIndex>& cells) const {
    std::string points;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (i > 0 && cells[i] == cells[i - 1]) continue;
      const auto [x, y] = place(cells[i]);
      points += fmt::format("{}{:.1f} {:.1f}", points.empty() ? "M" : " ", x, y);
    }
    return points;
  }

  void draw_ways() {
    std::vector<CellIndex> until, after;
    for (int s = 0; s <= seconds(); ++s) until.push_back(target(s));
    for (std::size_t s = robot_.size() - 1; s < map_.duration() + shift(); ++s)
      after.push_back(target(static_cast<int>(s)));
    if (after.size() > 1) out_ += fmt::format("<path class=\"way rest target\" d=\"{}\"/>\n", line(after));
    for (const bool is_robot : {false, true}) {
      const std::string way = line(is_robot ? robot_ : until);
      out_ += fmt::format(
          "<g class=\"path\"><path class=\"way casing\" d=\"{0}\"/><path class=\"way {1}\" d=\"{0}\"/></g>\n", way,
          is_robot ? "line" : "target");
    }
  }

  void mark(CellIndex cell, const std::string& text, bool above) {
    const auto [x, y] = place(cell);
    out_ += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3.5\"/>", x, y);
    const bool right = x < width_ - 60;
    const double width = kDigit * static_cast<double>(text.size());
    const Label label{x + (right ? 6 : -6 - width), std::max(12.0, y + (above ? -6 : 14)), width};
    if (std::any_of(labels_.begin(), labels_.end(), [&](const Label& other) { return label.overlaps(other); })) return;
    labels_.push_back(label);
    out_ += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" stroke=\"none\">{}</text>",
                        x + (right ? 6 : -6), label.y, right ? "start" : "end", text);
  }

  // Where there is no room for a label its mark is without one; the end comes first.
  void draw_marks() {
    const int step = mark_step(seconds());
    out_ += "<g class=\"mark forward\">";
    mark(robot_.back(), fmt::format("{} at {}", run_.is_caught() ? "caught" : "ends", seconds()), false);
    out_ += "</g>\n";
    for (const auto& [who, above] : {std::pair{"target", true}, std::pair{"forward", false}}) {
      const bool is_robot = !above;
      out_ += fmt::format("<g class=\"mark {}\">", who);
      const auto at = [&](int s) { return is_robot ? robot_[static_cast<std::size_t>(s)] : target(s); };
      for (int s = 0; s < seconds(); s += step) {
        const int from = s;
        while (s + step < seconds() && at(s + step) == at(from)) s += step;
        mark(at(from), s == from ? std::to_string(s) : fmt::format("{} to {}", from, s), above);
      }
      out_ += "</g>\n";
    }
  }

  // The last twentieth of the time they stand still.
  void draw_runners() {
    const int most = 3000, every = seconds() / most + 1, pause = std::max(1, seconds() / every / 20);
    const double lasts = std::clamp(seconds() / 25.0, 4.0, 40.0);
    for (const char* who : {"target", "runner"}) {
      std::string xs, ys;
      const auto add = [&](int second) {
        const bool is_robot = who[0] == 'r';
        const auto [x, y] = place(is_robot ? robot_[static_cast<std::size_t>(second)] : target(second));
        xs += fmt::format("{}{:.1f}", xs.empty() ? "" : ";", x);
        ys += fmt::format("{}{:.1f}", ys.empty() ? "" : ";", y);
      };
      for (int s = 0; s < seconds(); s += every) add(s);
      for (int i = 0; i <= pause; ++i) add(seconds());
      out_ += fmt::format(
          "<circle class=\"{0} moving\" cx=\"{4}\" cy=\"{5}\" r=\"8\"><animate attributeName=\"cx\" dur=\"{1:.1f}s\" "
          "repeatCount=\"indefinite\" values=\"{2}\"/><animate attributeName=\"cy\" dur=\"{1:.1f}s\" "
          "repeatCount=\"indefinite\" "
          "values=\"{3}\"/></circle>\n",
          who, lasts, xs, ys, xs.substr(0, xs.find(';')), ys.substr(0, ys.find(';')));
    }
  }

  std::vector<std::string> facts() const {
    const ChaseResult& r = run_.result;
    return {run_.is_caught() ? "caught" : "not caught",
            "cost " + map_.cost_text(r.cost),
            fmt::format("{} s", r.time),
            fmt::format("{} moves", r.moves),
            fmt::format("planner {}", run_.request.planner_name()),
            fmt::format("clock {}", name(run_.request.clock))};
  }

  std::vector<taut::detail::SvgKey> keys() const {
    using enum taut::detail::SvgKey::Sample;
    std::vector<taut::detail::SvgKey> keys{{"path", "robot", line, {}}, {"target", "target", line, {}}};
    if (run_.result.track.back().second + 1 < static_cast<int>(map_.duration() + shift()))
      keys.push_back({"target rest", "target later", line, {}});
    keys.push_back({"obstacle", "obstacle", patch, {}});
    keys.push_back({"cost",
                    fmt::format("cost {} to {}", map_.cost_text(shades_.least()), map_.cost_text(shades_.most())),
                    scale, shades_.scale()});
    keys.push_back(taut::detail::ruler_key(scale_, "cell", "cells"));
    return keys;
  }

  const ChaseMap& map_;
  const ChaseRun& run_;
  Shades shades_;
  double scale_, width_, height_;
  taut::detail::SvgFrame frame_;
  std::vector<Label> labels_;
  std::vector<CellIndex> robot_;  // one a second
  std::string out_;
};

}  // namespace

std::string chase_svg(const ChaseMap& map, const ChaseRun& run, const std::string& title, bool moves) {
  return Picture(map, run, title).drawn(moves);
}

}  // namespace taut::pursuit
