#include <taut/cli/chase_svg.h>

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include <taut/cli/png.h>
#include <taut/cli/report.h>

namespace taut::cli {

using namespace pursuit;

namespace {

constexpr double kSide = 960, kLegend = 64;
constexpr int kMostPixels = 1000;
constexpr Pixel kWall{52, 60, 82};

constexpr const char* kStyle =
    "<style>text{font:15px sans-serif;fill:#222}.robot{stroke:#0b62d6}.target{stroke:#d3221f}"
    ".way{fill:none;stroke-width:3;stroke-linejoin:round;stroke-linecap:round}"
    ".casing{stroke:#fff;stroke-width:5.5;stroke-opacity:.8}"
    ".rest{stroke-width:1.5;stroke-dasharray:3 5}circle{fill:#fff;stroke-width:2.5}"
    ".mark text{font-size:12px;paint-order:stroke;stroke:#fff;stroke-width:3px;stroke-linejoin:round}"
    ".robot text{fill:#0b62d6}.target text{fill:#d3221f}circle.solid.robot{fill:#0b62d6;stroke:#fff}"
    "circle.solid.target{fill:#d3221f;stroke:#fff}image{image-rendering:pixelated}</style>";

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text)
    out += c == '<' ? "&lt;" : c == '&' ? "&amp;" : c == '>' ? "&gt;" : std::string(1, c >= 0 && c < 32 ? '?' : c);
  return out;
}

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

Pixels pixels_of(const ChaseMap& map, int side) {
  const Shades shades(map);
  Pixels image{(map.x_size() + side - 1) / side, (map.y_size() + side - 1) / side, {}};
  for (int row = image.height - 1; row >= 0; --row)
    for (int column = 0; column < image.width; ++column)
      image.pixels.push_back(block(map, shades, 1 + column * side, 1 + row * side, side));
  return image;
}

/// A round number of seconds between marks.
int mark_step(int seconds) {
  int step = 1;
  for (const int times : {2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000})
    if (seconds / step > 8) step = times;
  return step;
}

class Picture {
 public:
  Picture(const ChaseMap& map, const ChaseRun& run) : map_(map), run_(run) {
    scale_ = kSide / std::max(map.x_size(), map.y_size());
    width_ = scale_ * map.x_size();
    height_ = scale_ * map.y_size();
    const std::vector<ChaseStep>& track = run.result.track;
    for (std::size_t i = 0; i + 1 < track.size(); ++i)
      robot_.insert(robot_.end(), static_cast<std::size_t>(track[i + 1].second - track[i].second), track[i].cell);
    robot_.push_back(track.back().cell);
  }

  std::string drawn(bool moves) {
    const double page = std::max(width_, 520.0);
    out_ = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" viewBox=\"0 0 {0:.0f} "
        "{1:.0f}\">{2}<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n",
        page, height_ + kLegend, kStyle);
    draw_map();
    draw_ways();
    moves ? draw_runners() : draw_marks();
    draw_legend();
    return out_ + "</svg>\n";
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
    const Pixels image = pixels_of(map_, side);
    const double height = scale_ * side * image.height;  // the blocks at the top and at the right may stick out
    out_ += fmt::format(
        "<svg width=\"{:.2f}\" height=\"{:.2f}\"><image y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" "
        "preserveAspectRatio=\"none\" href=\"{}\"/></svg>\n",
        width_, height_, height_ - height, scale_ * side * image.width, height, png_address(image));
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
      out_ += fmt::format("<path class=\"way casing\" d=\"{0}\"/><path class=\"way {1}\" d=\"{0}\"/>\n", way,
                          is_robot ? "robot" : "target");
    }
  }

  void mark(CellIndex cell, const std::string& text, bool above) {
    const auto [x, y] = place(cell);
    out_ += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3.5\"/>", x, y);
    const bool right = x < width_ - 60;
    out_ += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" stroke=\"none\">{}</text>",
                        x + (right ? 6 : -6), std::max(12.0, y + (above ? -6 : 14)), right ? "start" : "end", text);
  }

  void draw_marks() {
    const int step = mark_step(seconds());
    for (const auto& [who, above] : {std::pair{"target", true}, std::pair{"robot", false}}) {
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
    out_ += "<g class=\"mark robot\">";
    mark(robot_.back(), fmt::format("{} at {}", run_.is_caught() ? "caught" : "ends", seconds()), false);
    out_ += "</g>\n";
  }

  // The last twentieth of the time they stand still.
  void draw_runners() {
    const int most = 3000, every = seconds() / most + 1, pause = std::max(1, seconds() / every / 20);
    const double lasts = std::clamp(seconds() / 25.0, 4.0, 40.0);
    for (const char* who : {"target", "robot"}) {
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
          "<circle class=\"solid {}\" r=\"8\"><animate attributeName=\"cx\" dur=\"{:.1f}s\" repeatCount=\"indefinite\" "
          "values=\"{}\"/><animate attributeName=\"cy\" dur=\"{:.1f}s\" repeatCount=\"indefinite\" "
          "values=\"{}\"/></circle>\n",
          who, lasts, xs, lasts, ys);
    }
  }

  void draw_legend() {
    const ChaseResult& r = run_.result;
    out_ += fmt::format("<text x=\"8\" y=\"{:.0f}\" font-weight=\"bold\">{}</text>", height_ + 24,
                        escaped(title_of(map_.source())));
    out_ += fmt::format("<text x=\"8\" y=\"{:.0f}\">{}, cost {}, {} s, {} moves, planner {}, clock {}</text>",
                        height_ + 48, run_.is_caught() ? "caught" : "not caught", map_.cost_text(r.cost), r.time,
                        r.moves, run_.request.planner_name(), name(run_.request.clock));
    const double x = std::max(width_, 520.0) - 150;
    for (const auto& [who, down] : {std::pair{"robot", 0}, std::pair{"target", 75}})
      out_ +=
          fmt::format("<path class=\"way {0}\" d=\"M{1:.0f} {2:.0f}h18\"/><text x=\"{3:.0f}\" y=\"{4:.0f}\">{0}</text>",
                      who, x + down, height_ + 19, x + down + 24, height_ + 24);
    out_ += "\n";
  }

  const ChaseMap& map_;
  const ChaseRun& run_;
  double scale_ = 1, width_ = 0, height_ = 0;
  std::vector<CellIndex> robot_;  // one a second
  std::string out_;
};

}  // namespace

std::string chase_svg(const ChaseMap& map, const ChaseRun& run, bool moves) { return Picture(map, run).drawn(moves); }

}  // namespace taut::cli
