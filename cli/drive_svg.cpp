#include <taut/cli/drive_svg.h>

#include <fmt/format.h>

#include <algorithm>

namespace taut::cli {

namespace {

using car::Pose;

constexpr std::size_t kEvery = 8;      // poses an outline
constexpr std::size_t kFrames = 1500;  // of an animation, at most
constexpr double kStepsPerSecond = 60;

constexpr const char* kStyle =
    "<style>.page{fill:#fff}.seen{fill:#fff3c4}.wall{fill:#b9bec7}.dot{fill:#30343b}.open{fill:#5fb878}.closed{fill:#"
    "d64545}"
    ".unknown{fill:#9a8fd0}.letter,.legend{font:0.8px "
    "sans-serif;fill:#fff;text-anchor:middle}.legend{font-size:1.3px;fill:#30343b;text-anchor:start}"
    ".car{fill:none;stroke:#2b6cb0;stroke-width:.04;stroke-opacity:.45}.last{fill:#2b6cb0;fill-opacity:.5;stroke:#"
    "1a4971;stroke-width:.08}"
    ".way{fill:none;stroke:#1a4971;stroke-width:.16}.back{fill:none;stroke:#d9822b;stroke-width:.22}.start{fill:#"
    "2b6cb0}.goal{fill:#c2255c}</style>\n";

/// On the surface's blue the way is warm.
constexpr const char* kValueStyle =
    "<style>.car{stroke:#e8590c;stroke-opacity:.4;stroke-width:.05}.way{stroke:#e8590c;stroke-width:.26}.back{stroke:#"
    "f8b500;stroke-width:"
    ".3}"
    ".last{fill:#e8590c;fill-opacity:.8;stroke:#fff}.start{fill:#e8590c;stroke:#fff;stroke-width:.15}.goal{stroke:#fff;"
    "stroke-width:.15}.wall{fill:#868e96}</style>\n";

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text)
    out += c == '<' ? "&lt;" : c == '&' ? "&amp;" : c == '>' ? "&gt;" : c >= ' ' && c <= '~' ? std::string(1, c) : "?";
  return out;
}

std::string square_path(int x, int y) { return fmt::format("M{} {}h1v1h-1z", x - 0.5, y - 0.5); }

std::string outline(const Pose& pose) {
  const auto c = car::corners(pose);
  return fmt::format("M{:.2f} {:.2f}L{:.2f} {:.2f}L{:.2f} {:.2f}L{:.2f} {:.2f}z", c[0].x, c[0].y, c[1].x, c[1].y,
                     c[2].x, c[2].y, c[3].x, c[3].y);
}

class DrivePicture {
 public:
  DrivePicture(const car::Course& course, const car::Drive& drive) : course_(course), drive_(drive) {}

  std::string draw(car::WallReading reading, bool animate, const std::string& title, const ValueLayer* values) {
    const int width = course_.width + 2, height = course_.height + 5, pixels = 960;
    out_ = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{}\" height=\"{}\" viewBox=\"-0.5 -0.5 {} "
        "{}\">\n<title>{}</title>\n",
        pixels, pixels * height / width, width, height, escaped(title));
    out_ += kStyle;
    out_ += fmt::format("<rect class=\"page\" x=\"-0.5\" y=\"-0.5\" width=\"{}\" height=\"{}\"/>\n", width, height);
    if (values) {
      out_ += kValueStyle;
      out_ += values->surface;
    } else {
      seen();
    }
    walls(reading);
    if (values) out_ += values->arrows + values->legend;
    roadblocks();
    outlines();
    way();
    ends(animate);
    out_ += fmt::format("<text class=\"legend\" x=\"0.5\" y=\"{}\">{}</text>\n", course_.height + 2.6, escaped(title));
    return std::move(out_ += "</svg>\n");
  }

 private:
  void path(const char* kind, const std::string& d) {
    if (!d.empty()) out_ += fmt::format("<path class=\"{}\" d=\"{}\"/>\n", kind, d);
  }

  void seen() {
    std::vector<std::uint8_t> near(course_.walls.size());
    constexpr int kReach = static_cast<int>(car::kSight) + 1;
    for (const Pose& pose : drive_.poses)
      for (int dy = -kReach; dy <= kReach; ++dy)
        for (int dx = -kReach; dx <= kReach; ++dx) {
          const Cell c{static_cast<int>(pose.x) + dx, static_cast<int>(pose.y) + dy};
          const double x = c.x - pose.x, y = c.y - pose.y;
          if (course_.has(c) && x * x + y * y <= car::kSight * car::kSight) near[course_.index(c)] = 1;
        }
    path("seen", cells([&](Cell c) { return near[course_.index(c)] != 0; }));
  }

  template <typename Choose>
  std::string cells(Choose choose) const {
    std::string d;
    for (int y = 1; y <= course_.height; ++y)
      for (int x = 1; x <= course_.width; ++x)
        if (choose(Cell{x, y})) d += square_path(x, y);
    return d;
  }

  void walls(car::WallReading reading) {
    path("wall", cells([&](Cell c) { return course_.is_wall(c); }));
    if (reading == car::WallReading::squares) return;
    std::string d;
    for (int y = 1; y <= course_.height; ++y)
      for (int x = 1; x <= course_.width; ++x)
        if (course_.is_wall({x, y})) d += fmt::format("M{} {}h.2v.2h-.2z", x - 0.1, y - 0.1);
    path("dot", d);
  }

  void roadblocks() {
    car::RoadblockSet known = 0;
    for (const auto& [step, which] : drive_.sights) known |= which;
    for (std::size_t i = 0; i < course_.roadblocks.size(); ++i) {
      const car::Roadblock& block = course_.roadblocks[i];
      const char* state = !((known >> i) & 1) ? "unknown" : (drive_.open >> i) & 1 ? "open" : "closed";
      for (const Cell c : block.cells) {
        path(state, square_path(c.x, c.y));
        out_ += fmt::format("<text class=\"letter\" x=\"{}\" y=\"{}\">{}</text>\n", c.x, c.y + 0.3, block.letter);
      }
    }
  }

  void outlines() {
    std::string d;
    for (std::size_t i = 0; i < drive_.poses.size(); i += kEvery) d += outline(drive_.poses[i]);
    path("car", d);
  }

  void way() {
    std::string ahead, back;
    for (std::size_t i = 0; i < drive_.controls.size(); ++i) {
      const Pose &a = drive_.poses[i], &b = drive_.poses[i + 1];
      std::string& d = drive_.controls[i] == car::kReverse ? back : ahead;
      d += fmt::format("M{:.3f} {:.3f}L{:.3f} {:.3f}", a.x, a.y, b.x, b.y);
    }
    path("back", back);
    path("way", ahead);
  }

  void ends(bool animate) {
    out_ += fmt::format("<circle class=\"start\" cx=\"{}\" cy=\"{}\" r=\".5\"/>\n", course_.start.x, course_.start.y);
    out_ += fmt::format("<circle class=\"goal\" cx=\"{}\" cy=\"{}\" r=\".5\"/>\n", course_.goal.x, course_.goal.y);
    if (!animate || drive_.controls.empty()) return path("last", outline(drive_.poses.back()));
    std::string frames;
    const std::size_t every = (drive_.controls.size() + kFrames - 1) / kFrames;
    for (std::size_t i = 0; i < drive_.poses.size(); i += every) frames += outline(drive_.poses[i]) + ";";
    frames += outline(drive_.poses.back());
    out_ += fmt::format(
        "<path class=\"last\" d=\"{}\"><animate attributeName=\"d\" dur=\"{:.2f}s\" repeatCount=\"indefinite\" "
        "values=\"{}\"/></path>\n",
        outline(drive_.poses.back()), static_cast<double>(drive_.controls.size()) / kStepsPerSecond, frames);
  }

  const car::Course& course_;
  const car::Drive& drive_;
  std::string out_;
};

}  // namespace

std::string drive_svg(const car::Course& course, const car::Drive& drive, car::WallReading reading, bool animate,
                      const std::string& title, const ValueLayer* values) {
  return DrivePicture(course, drive).draw(reading, animate, title, values);
}

}  // namespace taut::cli
