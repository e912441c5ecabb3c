#include <taut/io/pictures/drive_svg.h>

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include <taut/io/pictures/detail/svg_frame.h>
#include <taut/io/pictures/detail/svg_motion.h>

namespace taut {

namespace {

using roadblocks::Pose;

constexpr std::size_t kEvery = 8;               // poses an outline
constexpr std::size_t kWholeBranches = 20'000;  // of a larger tree the chords alone
constexpr std::size_t kFrames = 1500;           // of an animation, at most
constexpr double kStepsPerSecond = 60;

// In cells.
constexpr const char* kStyle = R"(.taut.drive .ground{fill:#fff}
.taut.drive .seen{fill:#e8a713;fill-opacity:.16}
.taut.drive .wall{fill:#ccd2dc}
.taut.drive .dot{fill:#2c3440}
.taut.drive .block{fill-opacity:.85}
.taut.drive .open{fill:#4aa96c}
.taut.drive .closed{fill:#d3245e}
.taut.drive .unknown{fill:#8a93a3}
.taut.drive .letter{font-size:.8px;fill:#fff;text-anchor:middle}
.taut.drive .outlines{fill:none;stroke:#ee5a10;stroke-opacity:.4;stroke-width:.04}
.taut.drive .casing{fill:none;stroke:#fff;stroke-width:.36;stroke-linecap:round}
.taut.drive .ahead{fill:none;stroke:#ee5a10;stroke-width:.18;stroke-linecap:round}
.taut.drive .back{fill:none;stroke:#00838f;stroke-width:.24;stroke-linecap:round}
.taut.drive .tree{fill:none;stroke:#8fb6dc;stroke-width:.06}
.taut.drive .goal-tree{fill:none;stroke:#b48cff;stroke-width:.06}
.taut.drive .sample.tree,.taut.drive .sample.goal-tree{stroke-width:2}
.taut.drive .car{fill:#ee5a10;fill-opacity:.55;stroke:#9a3606;stroke-width:.08}
@media (prefers-color-scheme:dark){
.taut.drive .ground{fill:#1d2430}
.taut.drive .seen{fill:#ffd166;fill-opacity:.14}
.taut.drive .wall{fill:#3c4656}
.taut.drive .dot{fill:#d4dbe6}
.taut.drive .outlines{stroke:#ff8340}
.taut.drive .casing{stroke:#12161d}
.taut.drive .ahead{stroke:#ff8340}
.taut.drive .back{stroke:#4dd0e1}
.taut.drive .car{fill:#ff8340;stroke:#ffd9c2}
}
.taut.drive .sample.ahead,.taut.drive .sample.back{stroke-width:4}
)";

/// On the surface, which is the same by day and by night.
constexpr const char* kValueStyle = R"(.taut.drive .wall{fill:#868e96}
.taut.drive .outlines{stroke:#fff;stroke-width:.05}
.taut.drive .casing{stroke:#fff}
.taut.drive .car{fill:#ff8340;fill-opacity:.9;stroke:#fff}
)";

std::string square_path(int x, int y) { return fmt::format("M{} {}h1v1h-1z", x - 0.5, y - 0.5); }

std::string outline(const Pose& pose) {
  const auto c = roadblocks::corners(pose);
  return fmt::format("M{:.2f} {:.2f}L{:.2f} {:.2f}L{:.2f} {:.2f}L{:.2f} {:.2f}z", c[0].x, c[0].y, c[1].x, c[1].y,
                     c[2].x, c[2].y, c[3].x, c[3].y);
}

class Picture {
 public:
  Picture(const roadblocks::Course& course, const roadblocks::Drive& drive, const DrivePicture& what)
      : course_(course),
        drive_(drive),
        what_(what),
        cell_(detail::kMapPixels / std::max(course.width, course.height)),
        frame_({cell_ * course.width, cell_ * course.height}, what.title, what.facts, keys()) {}

  std::string draw() {
    out_ = frame_.head("drive", std::string(kStyle) + (what_.values ? kValueStyle : ""));
    const Box map = frame_.map();  // an inner <svg> cuts off what reaches beyond the map
    out_ +=
        fmt::format("<svg x=\"{:.3f}\" y=\"{:.3f}\" width=\"{:.3f}\" height=\"{:.3f}\" viewBox=\".5 .5 {} {}\">\n",
                    map.min.x, map.min.y, map.max.x - map.min.x, map.max.y - map.min.y, course_.width, course_.height);
    out_ += fmt::format("<rect class=\"ground\" x=\".5\" y=\".5\" width=\"{}\" height=\"{}\"/>\n", course_.width,
                        course_.height);
    what_.values ? void(out_ += what_.values->surface) : seen();
    walls();
    if (what_.values) out_ += what_.values->arrows;
    tree(false);
    tree(true);
    roadblocks();
    outlines();
    way();
    car();
    out_ += "</svg>\n";
    out_ += marker("start", course_.start) + marker("goal", course_.goal);
    if (what_.animate) out_ += detail::film_controls({frame_.width() - 4, 3});
    return out_ + frame_.foot();
  }

 private:
  std::vector<detail::SvgKey> keys() const {
    using enum detail::SvgKey::Sample;
    std::vector<detail::SvgKey> keys{
        {"start", "start", marker, {}}, {"goal", "goal", marker, {}}, {"ahead", "forward and turns", line, {}}};
    if (std::count(drive_.controls.begin(), drive_.controls.end(), roadblocks::kReverse) > 0)
      keys.push_back({"back", "reverse", line, {}});
    const roadblocks::RoadblockSet known = drive_.known();
    const auto all = (roadblocks::RoadblockSet{1} << course_.roadblocks.size()) - 1;
    if (known & drive_.open) keys.push_back({"open", "seen open", patch, {}});
    if (known & ~drive_.open) keys.push_back({"closed", "seen closed", patch, {}});
    if (all & ~known) keys.push_back({"unknown", "never seen", patch, {}});
    if (has_tree(false)) keys.push_back({"tree", "the tree that was grown", line, {}});
    if (has_tree(true)) keys.push_back({"goal-tree", "the one from the goal", line, {}});
    if (what_.values)
      keys.push_back({"values", what_.values->scale, scale, what_.values->colours});
    else
      keys.push_back({"seen", "in sight", patch, {}});
    keys.push_back(detail::ruler_key(cell_, "cell", "cells"));
    return keys;
  }

  std::string marker(const char* kind, Point at) const {
    const Point pixel{frame_.map().min.x + cell_ * (at.x - 0.5), frame_.map().min.y + cell_ * (at.y - 0.5)};
    return detail::marker(kind, pixel, std::clamp(0.45 * cell_, 6.0, 11.0), 4 * cell_);
  }

  void path(const char* kind, const std::string& d) {
    if (!d.empty()) out_ += fmt::format("<path class=\"{}\" d=\"{}\"/>\n", kind, d);
  }

  void seen() {
    std::vector<std::uint8_t> near(course_.walls.size());
    constexpr int kReach = static_cast<int>(roadblocks::kSight) + 1;
    for (const Pose& pose : drive_.poses)
      for (int dy = -kReach; dy <= kReach; ++dy)
        for (int dx = -kReach; dx <= kReach; ++dx) {
          const Cell c{static_cast<int>(pose.x) + dx, static_cast<int>(pose.y) + dy};
          const double x = c.x - pose.x, y = c.y - pose.y;
          if (course_.has(c) && x * x + y * y <= roadblocks::kSight * roadblocks::kSight) near[course_.index(c)] = 1;
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

  void walls() {
    path("wall", cells([&](Cell c) { return course_.is_wall(c); }));
    if (what_.reading == roadblocks::WallReading::squares) return;
    std::string d;
    for (int y = 1; y <= course_.height; ++y)
      for (int x = 1; x <= course_.width; ++x)
        if (course_.is_wall({x, y})) d += fmt::format("M{} {}h.2v.2h-.2z", x - 0.1, y - 0.1);
    path("dot", d);
  }

  void roadblocks() {
    const roadblocks::RoadblockSet known = drive_.known();
    for (std::size_t i = 0; i < course_.roadblocks.size(); ++i) {
      const roadblocks::Roadblock& block = course_.roadblocks[i];
      const char* state = !((known >> i) & 1) ? "unknown" : (drive_.open >> i) & 1 ? "open" : "closed";
      for (const Cell c : block.cells) {
        path(state, square_path(c.x, c.y));
        out_ += fmt::format("<text class=\"letter\" x=\"{}\" y=\"{}\">{}</text>\n", c.x, c.y + 0.3, block.letter);
      }
    }
  }

  bool has_tree(bool from_goal) const {
    return std::ranges::any_of(what_.tree, [&](const auto& branch) { return branch.from_goal == from_goal; });
  }

  void tree(bool from_goal) {
    const bool as_chords = what_.tree.size() > kWholeBranches;
    std::string d;
    for (const roadblocks::TreeBranch& branch : what_.tree) {
      if (branch.from_goal != from_goal) continue;
      for (std::size_t i = 0; i < branch.way.size();
           i += as_chords ? std::max<std::size_t>(branch.way.size() - 1, 1) : 1)
        d += fmt::format("{}{:.2f} {:.2f}", i == 0 ? 'M' : 'L', branch.way[i].x, branch.way[i].y);
    }
    path(from_goal ? "goal-tree" : "tree", d);
  }

  void outlines() {
    std::string d;
    for (std::size_t i = 0; i < drive_.poses.size(); i += kEvery) d += outline(drive_.poses[i]);
    path("outlines", d);
  }

  void way() {
    std::string ahead, back;
    for (std::size_t i = 0; i < drive_.controls.size(); ++i) {
      const Pose &a = drive_.poses[i], &b = drive_.poses[i + 1];
      std::string& d = drive_.controls[i] == roadblocks::kReverse ? back : ahead;
      d += fmt::format("M{:.3f} {:.3f}L{:.3f} {:.3f}", a.x, a.y, b.x, b.y);
    }
    path("casing", ahead + back);
    path("back", back);
    path("ahead", ahead);
  }

  void car() {
    if (!what_.animate || drive_.controls.empty()) return path("car", outline(drive_.poses.back()));
    std::string frames;
    const std::size_t every = (drive_.controls.size() + kFrames - 1) / kFrames;
    for (std::size_t i = 0; i < drive_.poses.size(); i += every) frames += outline(drive_.poses[i]) + ";";
    frames += outline(drive_.poses.back());
    out_ += fmt::format(
        "<path class=\"car moving\" d=\"{}\"><animate attributeName=\"d\" dur=\"{:.2f}s\" repeatCount=\"indefinite\" "
        "values=\"{}\"/></path>\n",
        outline(drive_.poses.back()), static_cast<double>(drive_.controls.size()) / kStepsPerSecond, frames);
  }

  const roadblocks::Course& course_;
  const roadblocks::Drive& drive_;
  const DrivePicture& what_;
  double cell_;  // in pixels
  detail::SvgFrame frame_;
  std::string out_;
};

}  // namespace

std::string drive_svg(const roadblocks::Course& course, const roadblocks::Drive& drive, const DrivePicture& picture) {
  return Picture(course, drive, picture).draw();
}

}  // namespace taut
