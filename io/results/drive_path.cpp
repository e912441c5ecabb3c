#include <taut/io/results/drive_path.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace taut {

namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kSag = 1e-3;  // of the radius

class Writer {
 public:
  explicit Writer(const car::LatticePose& start, double gear) {
    add({start.at.x, start.at.y, car::heading_angle(start.heading)}, gear);
  }

  void add(const car::Leg& leg) {
    const car::LegCurve curve = car::curve_of(leg);
    const double whole = curve.length(), gear = leg.backward ? -1 : 1;
    if (whole == 0) return;
    const double arc = curve.radius * std::abs(curve.turn);
    if (curve.before > 0) straight(car::pose_on(leg, curve.before / whole), gear);
    if (arc > 0) bend(leg, curve, gear);
    if (curve.after > 0) straight({leg.to.at.x, leg.to.at.y, car::heading_angle(leg.to.heading)}, gear);
    // The ends of legs are exact.
    path_.points.back() = leg.to.at;
    path_.arcs.back().to = leg.to.at;
  }

  PathToWrite take() {
    path_.columns = {{"heading", std::move(headings_)}, {"gear", std::move(gears_)}};
    return std::move(path_);
  }

 private:
  void add(const car::Pose& pose, double gear) {
    path_.points.push_back({pose.x, pose.y});
    headings_.push_back(pose.heading / kDegree);
    gears_.push_back(gear);
  }

  void straight(const car::Pose& to, double gear) {
    ArcPiece piece;
    piece.from = path_.points.back();
    add(to, gear);
    piece.to = path_.points.back();
    path_.arcs.push_back(piece);
  }

  void bend(const car::Leg& leg, const car::LegCurve& curve, double gear) {
    const double whole = curve.length(), arc = curve.radius * std::abs(curve.turn);
    const int steps = std::max(1, static_cast<int>(std::ceil(std::abs(curve.turn) / (2 * std::acos(1 - kSag)))));
    ArcPiece piece;
    piece.from = path_.points.back();
    for (int k = 1; k <= steps; ++k) add(car::pose_on(leg, (curve.before + arc * k / steps) / whole), gear);
    piece.to = path_.points.back();
    piece.turn = curve.turn > 0 ? 1 : -1;
    const double heading = headings_.back() * kDegree, side = piece.turn * gear;
    // The centre lies square to the car, left of it when it turns counter-clockwise and goes ahead.
    piece.centre = {piece.to.x - side * curve.radius * std::sin(heading),
                    piece.to.y + side * curve.radius * std::cos(heading)};
    piece.from_angle = std::atan2(piece.from.y - piece.centre.y, piece.from.x - piece.centre.x);
    piece.sweep = std::abs(curve.turn);
    path_.arcs.push_back(piece);
    path_.tolerance = std::max(path_.tolerance, kSag * curve.radius);
  }

  PathToWrite path_{.name = "drive", .points = {}};
  std::vector<double> headings_, gears_;
};

}  // namespace

PathToWrite drive_path(const std::vector<car::Leg>& legs, const car::LatticePose& start, double length) {
  Writer writer(start, !legs.empty() && legs.front().backward ? -1 : 1);
  for (const car::Leg& leg : legs) writer.add(leg);
  PathToWrite path = writer.take();
  path.length = length;
  return path;
}

}  // namespace taut
