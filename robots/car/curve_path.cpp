#include <taut/robots/car/curve_path.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace taut::car {

namespace {

using Kind = CurveSegment::Kind;

Pose driven(const Pose& from, Kind kind, double length, double radius) {
  if (kind == Kind::straight)
    return {from.x + length * std::cos(from.heading), from.y + length * std::sin(from.heading), from.heading};
  const double turn = (kind == Kind::left ? length : -length) / radius, middle = from.heading + turn / 2;
  const double chord = 2 * radius * std::sin(length / radius / 2);
  return {from.x + chord * std::cos(middle), from.y + chord * std::sin(middle), from.heading + turn};
}

}  // namespace

CurvePath::CurvePath(const Pose& from, double radius, std::vector<CurveSegment> segments)
    : from_(from), radius_(radius), segments_(std::move(segments)) {
  for (const CurveSegment& s : segments_) length_ += std::abs(s.length);
}

std::string CurvePath::word() const {
  std::string text;
  for (const CurveSegment& s : segments_) {
    text += s.kind == Kind::left ? 'L' : s.kind == Kind::right ? 'R' : 'S';
    if (s.length < 0) text += '-';
  }
  return text;
}

Pose CurvePath::pose_at(double along) const {
  Pose pose = from_;
  double left = std::max(along, 0.0);
  for (const CurveSegment& s : segments_) {
    const double part = std::min(left, std::abs(s.length));
    pose = driven(pose, s.kind, std::copysign(part, s.length), radius_);
    left -= part;
  }
  return pose;
}

std::vector<Pose> CurvePath::sampled(double spacing) const {
  std::vector<Pose> poses{from_};
  for (const CurveSegment& s : segments_) {
    const Pose begin = poses.back();
    const auto parts = static_cast<std::size_t>(std::ceil(std::abs(s.length) / spacing));
    for (std::size_t i = 1; i <= parts; ++i)
      poses.push_back(driven(begin, s.kind, s.length * static_cast<double>(i) / static_cast<double>(parts), radius_));
  }
  return poses;
}

}  // namespace taut::car
