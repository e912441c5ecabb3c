#include <taut/io/pictures/car_svg.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <taut/io/pictures/detail/svg_frame.h>
#include <taut/io/pictures/detail/svg_motion.h>

namespace taut {

namespace {

using car::Pose;

constexpr std::size_t kFrames = 1200;   // of an animation, at most
constexpr double kCarsASecond = 6;      // car lengths
constexpr double kOutlinesEvery = 1.5;  // car lengths

constexpr const char* kStyle = R"(.taut.car-in-world .beyond{fill:#ccd2dc}
.taut.car-in-world .free{fill:#fff}
.taut.car-in-world .solid{fill:#4b5668;stroke:#2c3440}
.taut.car-in-world .wall{fill:none;stroke:#2c3440;stroke-width:2;stroke-linecap:round}
.taut.car-in-world .thick{stroke:#4b5668;stroke-linecap:square}
.taut.car-in-world .swept{fill:#ee5a10;fill-opacity:.16}
.taut.car-in-world .outlines{fill:none;stroke:#ee5a10;stroke-width:.7;stroke-opacity:.6}
.taut.car-in-world .ahead{fill:none;stroke:#ee5a10;stroke-width:2}
.taut.car-in-world .back{fill:none;stroke:#00838f;stroke-width:2.4}
.taut.car-in-world .car{fill:#ee5a10;fill-opacity:.55;stroke:#9a3606}
.taut.car-in-world .barrier{fill:none;stroke:#d3245e;stroke-width:3}
@media (prefers-color-scheme:dark){
.taut.car-in-world .beyond{fill:#3c4656}
.taut.car-in-world .free{fill:#1d2430}
.taut.car-in-world .solid{fill:#8e9aad;stroke:#d4dbe6}
.taut.car-in-world .wall{stroke:#d4dbe6}
.taut.car-in-world .thick{stroke:#8e9aad}
.taut.car-in-world .swept{fill:#ff8340}
.taut.car-in-world .outlines{stroke:#ff8340}
.taut.car-in-world .ahead{stroke:#ff8340}
.taut.car-in-world .back{stroke:#4dd0e1}
.taut.car-in-world .car{fill:#ff8340;stroke:#ffd9c2}
.taut.car-in-world .barrier{stroke:#ff5c8d}
}
.taut.car-in-world .sample.ahead,.taut.car-in-world .sample.back{stroke-width:4}
)";

class Picture {
 public:
  Picture(const World& world, const car::CarShape& shape, const CarPicture& picture)
      : world_(world),
        shape_(shape),
        picture_(picture),
        box_(world.box()),
        scale_(detail::kMapPixels / std::max(box_.max.x - box_.min.x, box_.max.y - box_.min.y)),
        frame_({(box_.max.x - box_.min.x) * scale_, (box_.max.y - box_.min.y) * scale_}, picture.title, picture.facts,
               keys()) {
    lay_poses();
  }

  std::string draw() {
    out_ = frame_.head("car-in-world", kStyle);
    world();
    sweep();
    way();
    for (const Segment& s : picture_.barrier) path("barrier", line(s));
    last();
    marker("start", picture_.start);
    for (const Point goal : picture_.goals) marker("goal", goal);
    if (picture_.animate) out_ += detail::film_controls({frame_.width() - 4, 3});
    return out_ + frame_.foot();
  }

 private:
  std::vector<detail::SvgKey> keys() const {
    using enum detail::SvgKey::Sample;
    std::vector<detail::SvgKey> keys{{"start", "start", marker, {}}, {"goal", "goal", marker, {}}};
    const auto goes = [&](bool backward) {
      return std::any_of(picture_.legs.begin(), picture_.legs.end(),
                         [&](const car::Leg& leg) { return leg.backward == backward; });
    };
    if (goes(false)) keys.push_back({"ahead", "forward", line, {}});
    if (goes(true)) keys.push_back({"back", "reverse", line, {}});
    if (!picture_.legs.empty()) keys.push_back({"swept", "swept by the car", patch, {}});
    if (!picture_.barrier.empty()) keys.push_back({"barrier", "in the way", line, {}});
    keys.push_back(detail::ruler_key(scale_));
    return keys;
  }

  Point pixel(Point p) const {
    const double y = world_.y_down() ? p.y - box_.min.y : box_.max.y - p.y;
    return {(p.x - box_.min.x) * scale_ + frame_.map().min.x, y * scale_ + frame_.map().min.y};
  }
  std::string at(Point p) const {
    const Point dot = pixel(p);
    return fmt::format("{:.2f} {:.2f}", dot.x, dot.y);
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
  void marker(const char* kind, Point p) {
    const double half = shape_.half_width * scale_;
    out_ += detail::marker(kind, pixel(p), std::clamp(0.8 * half, 5.0, 9.0), half);
  }

  void world() {
    const Box map = frame_.map();
    const bool walled = world_.boundary() == Boundary::walled;
    out_ += fmt::format("<rect class=\"{}\" x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\"/>\n",
                        walled ? "beyond" : "free", map.min.x, map.min.y, map.max.x - map.min.x, map.max.y - map.min.y);
    for (const Area& area : world_.areas()) path("free", polygon(area.polygon), " fill-rule=\"evenodd\"");
    if (walled)
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
    path("outlines", some);
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
    path("ahead", ahead);
    path("back", back);
  }

  void last() {
    if (poses_.empty()) return;
    if (!picture_.animate || poses_.size() < 2) return path("car", outline(poses_.back()));
    std::string frames;
    const std::size_t every = (poses_.size() + kFrames - 1) / kFrames;
    for (std::size_t i = 0; i < poses_.size(); i += every) frames += outline(poses_[i]) + ";";
    frames += outline(poses_.back());
    const double seconds = std::max(2.0, length_ / (shape_.front + shape_.back) / kCarsASecond);
    out_ += fmt::format(
        "<path class=\"car moving\" d=\"{}\"><animate attributeName=\"d\" dur=\"{:.2f}s\" repeatCount=\"indefinite\" "
        "values=\"{}\"/></path>\n",
        outline(poses_.back()), seconds, frames);
  }

  const World& world_;
  const car::CarShape& shape_;
  const CarPicture& picture_;
  Box box_;
  double scale_;  // pixels a unit
  detail::SvgFrame frame_;
  double length_ = 0, spacing_ = 1;
  std::vector<Pose> poses_;
  std::string out_;
};

}  // namespace

std::string car_svg(const World& world, const car::CarShape& shape, const CarPicture& picture) {
  return Picture(world, shape, picture).draw();
}

}  // namespace taut
