#include <taut/cli/drive_world_svg.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace taut::cli {

namespace {

using car::Pose;

constexpr double kPixels = 960;
constexpr std::size_t kFrames = 1200;   // of an animation, at most
constexpr double kCarsASecond = 6;      // car lengths
constexpr double kOutlinesEvery = 1.5;  // car lengths

constexpr const char* kStyle =
    "<style>.page{fill:#fff}.beyond{fill:#b9bec7}.free{fill:#fff}.solid{fill:#b9bec7;stroke:#30343b;stroke-width:1}"
    ".wall{fill:none;stroke:#30343b;stroke-width:2;stroke-linecap:round}.thick{stroke:#b9bec7;stroke-linecap:square}"
    ".swept{fill:#2b6cb0;fill-opacity:.16}.car{fill:none;stroke:#2b6cb0;stroke-width:.7;stroke-opacity:.6}"
    ".last{fill:#2b6cb0;fill-opacity:.55;stroke:#1a4971;stroke-width:1}.way{fill:none;stroke:#1a4971;stroke-width:1.4}"
    ".back{fill:none;stroke:#d9822b;stroke-width:1.8}.start{fill:#2b6cb0}.goal{fill:#c2255c}"
    ".barrier{fill:none;stroke:#d64545;stroke-width:3}.legend{font:15px sans-serif;fill:#30343b}</style>\n";

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text)
    out += c == '<' ? "&lt;" : c == '&' ? "&amp;" : c >= ' ' && c <= '~' ? std::string(1, c) : "?";
  return out;
}

class Picture {
 public:
  Picture(const World& world, const car::CarShape& shape, const WorldDrivePicture& picture)
      : world_(world), shape_(shape), picture_(picture), box_(world.box()) {
    const double width = box_.max.x - box_.min.x, height = box_.max.y - box_.min.y;
    scale_ = kPixels / std::max(width, height);
    width_ = width * scale_ + 2 * kMargin;
    height_ = height * scale_ + 2 * kMargin;
    lay_poses();
  }

  std::string draw() {
    out_ = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" viewBox=\"0 0 {0:.0f} "
        "{1:.0f}\">\n<title>{2}</title>\n{3}",
        width_, height_ + kLegend, escaped(picture_.title), kStyle);
    out_ += fmt::format("<rect class=\"page\" width=\"{:.0f}\" height=\"{:.0f}\"/>\n", width_, height_ + kLegend);
    world();
    sweep();
    way();
    for (const Segment& s : picture_.barrier) path("barrier", line(s));
    dot("start", picture_.start);
    for (const Point goal : picture_.goals) dot("goal", goal);
    last();
    out_ += fmt::format("<text class=\"legend\" x=\"{}\" y=\"{:.0f}\">{}: {}</text>\n", kMargin, height_ + 14,
                        escaped(picture_.title), escaped(picture_.facts));
    return std::move(out_ += "</svg>\n");
  }

 private:
  static constexpr double kMargin = 12;
  static constexpr double kLegend = 28;

  std::string at(Point p) const {
    const double y = world_.y_down() ? p.y - box_.min.y : box_.max.y - p.y;
    return fmt::format("{:.2f} {:.2f}", (p.x - box_.min.x) * scale_ + kMargin, y * scale_ + kMargin);
  }
  std::string line(const Segment& s) const { return "M" + at(s.a) + "L" + at(s.b); }
  std::string ring(const Ring& points) const {
    std::string d;
    for (const Point p : points) d += (d.empty() ? "M" : "L") + at(p);
    return d + "z";
  }
  std::string polygon(const Polygon& p) const {
    std::string d = ring(p.outer);
    for (const Ring& hole : p.holes) d += ring(hole);
    return d;
  }
  void path(const char* kind, const std::string& d, const std::string& more = {}) {
    if (!d.empty()) out_ += fmt::format("<path class=\"{}\" d=\"{}\"{}/>\n", kind, d, more);
  }
  void dot(const char* kind, Point p) {
    const std::string place = at(p);
    const std::size_t blank = place.find(' ');
    out_ += fmt::format("<circle class=\"{}\" cx=\"{}\" cy=\"{}\" r=\"{:.2f}\"/>\n", kind, place.substr(0, blank),
                        place.substr(blank + 1), std::clamp(0.4 * shape_.half_width * scale_, 3.0, 6.0));
  }

  void world() {
    if (world_.boundary() == Boundary::walled)
      out_ += fmt::format("<rect class=\"beyond\" width=\"{:.0f}\" height=\"{:.0f}\"/>\n", width_, height_);
    for (const Area& area : world_.areas()) path("free", polygon(area.polygon), " fill-rule=\"evenodd\"");
    if (world_.boundary() == Boundary::walled)
      for (const Area& area : world_.areas()) path("wall", polygon(area.polygon));
    for (const Area& solid : world_.solids()) path("solid", polygon(solid.polygon), " fill-rule=\"evenodd\"");
    std::string thin;
    for (const Wall& wall : world_.walls()) {
      if (wall.thickness == 0)
        thin += line({wall.a, wall.b});
      else
        path("wall thick", line({wall.a, wall.b}),
             fmt::format(" style=\"stroke-width:{:.2f}\"", wall.thickness * scale_));
    }
    path("wall", thin);
  }

  void lay_poses() {
    if (picture_.start_pose) {
      const car::LatticePose& p = *picture_.start_pose;
      poses_.push_back({p.at.x, p.at.y, car::heading_angle(p.heading)});
    }
    const double size = shape_.front + shape_.back;
    spacing_ = std::min(0.1 * size, std::max(3 / scale_, 0.005 * size));
    for (const car::Leg& leg : picture_.legs) {
      const double length = car::curve_of(leg).length();
      length_ += length;
      const int parts = std::max(1, static_cast<int>(std::ceil(length / spacing_)));
      for (int i = 1; i <= parts; ++i) poses_.push_back(car::pose_on(leg, static_cast<double>(i) / parts));
    }
  }

  std::string outline(const Pose& pose) const {
    const double c = std::cos(pose.heading), s = std::sin(pose.heading);
    Ring corners;
    for (const auto& [x, y] : std::array<Point, 4>{{{shape_.front, shape_.half_width},
                                                    {-shape_.back, shape_.half_width},
                                                    {-shape_.back, -shape_.half_width},
                                                    {shape_.front, -shape_.half_width}}})
      corners.push_back({pose.x + c * x - s * y, pose.y + s * x + c * y});
    return ring(corners);
  }

  void sweep() {
    std::string area, some;
    const auto every = static_cast<std::size_t>(kOutlinesEvery * (shape_.front + shape_.back) / spacing_);
    for (std::size_t i = 0; i < poses_.size(); ++i) {
      area += outline(poses_[i]);
      if (i % every == 0) some += outline(poses_[i]);
    }
    path("swept", area);
    path("car", some);
  }

  void way() {
    std::string ahead, back;
    for (const car::Leg& leg : picture_.legs) {
      std::string& d = leg.backward ? back : ahead;
      for (int i = 0; i <= 8; ++i) {
        const Pose p = car::pose_on(leg, i / 8.0);
        d += (i == 0 ? "M" : "L") + at({p.x, p.y});
      }
    }
    path("way", ahead);
    path("back", back);
  }

  void last() {
    if (poses_.empty()) return;
    if (!picture_.animate || poses_.size() < 2) return path("last", outline(poses_.back()));
    std::string frames;
    const std::size_t every = (poses_.size() + kFrames - 1) / kFrames;
    for (std::size_t i = 0; i < poses_.size(); i += every) frames += outline(poses_[i]) + ";";
    frames += outline(poses_.back());
    const double seconds = std::max(2.0, length_ / (shape_.front + shape_.back) / kCarsASecond);
    out_ += fmt::format(
        "<path class=\"last\" d=\"{}\"><animate attributeName=\"d\" dur=\"{:.2f}s\" repeatCount=\"indefinite\" "
        "values=\"{}\"/></path>\n",
        outline(poses_.back()), seconds, frames);
  }

  const World& world_;
  const car::CarShape& shape_;
  const WorldDrivePicture& picture_;
  Box box_;
  double scale_ = 1, width_ = 0, height_ = 0, length_ = 0, spacing_ = 1;
  std::vector<Pose> poses_;
  std::string out_;
};

}  // namespace

std::string world_drive_svg(const World& world, const car::CarShape& shape, const WorldDrivePicture& picture) {
  return Picture(world, shape, picture).draw();
}

}  // namespace taut::cli
