// taut audit: a car's drive, by the exact sweeps of verify_drive.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <taut/cli/solve/audit.h>
#include <taut/geometry/errors.h>
#include <taut/io/pictures/car_svg.h>
#include <taut/io/results/words.h>
#include <taut/io/worlds/read_drive.h>
#include <taut/robots/car/verify_drive.h>
#include <taut/search/path_audit.h>

namespace taut::cli {

namespace {

/// Does the car that stands there meet the wall, by doubles?
bool covers(const car::Pose& pose, const car::CarShape& shape, const Segment& wall) {
  const double c = std::cos(pose.heading), s = std::sin(pose.heading);
  double low = 0, high = 1;  // what of the wall is left between the sides
  const auto along = [&](Point p) { return c * (p.x - pose.x) + s * (p.y - pose.y); };
  const auto aside = [&](Point p) { return c * (p.y - pose.y) - s * (p.x - pose.x); };
  const auto clip = [&](double a, double b, double least, double most) {
    if (a == b) return least < a && a < most;
    const double t = (least - a) / (b - a), u = (most - a) / (b - a);
    low = std::max(low, std::min(t, u));
    high = std::min(high, std::max(t, u));
    return low < high || (low == high && wall.a == wall.b);
  };
  return clip(along(wall.a), along(wall.b), -shape.back, shape.front) &&
         clip(aside(wall.a), aside(wall.b), -shape.half_width, shape.half_width);
}

Point first_place(const car::Leg& leg, const car::CarShape& shape, const Segment& wall) {
  constexpr int kSteps = 4096;
  for (int i = 0; i <= kSteps; ++i) {
    const car::Pose pose = car::pose_on(leg, static_cast<double>(i) / kSteps);
    if (covers(pose, shape, wall)) return {pose.x, pose.y};
  }
  return leg.from.at;
}

struct DriveAudit {
  std::optional<car::DriveFault> fault{};
  std::optional<Point> at{};
  std::optional<NearObstacle> wall{};
  double length = 0;
  std::optional<ShortestLength> shortest{};  ///< of the disc inside the car

  std::string text() const {
    std::string out = fmt::format("leg {} {}", fault->leg, fault->text);
    if (at) out += fmt::format("; first at about {}, {}", point_text(*at), taut::text(*wall));
    return out;
  }
};

DriveAudit audited(const ClaimedDrive& drive, const car::CarShape& shape, const World& world, bool wants_gap) {
  DriveAudit audit;
  const FreeSpace space(world);
  audit.fault = car::verify_drive(drive.legs, space, shape);
  if (audit.fault) {
    if (audit.fault->constraint == kNone) return audit;
    const Constraint& c = space.constraints()[audit.fault->constraint];
    audit.at = first_place(drive.legs[audit.fault->leg], shape, {c.a, c.b});
    audit.wall = nearest_obstacle(world, {c.a.x / 2 + c.b.x / 2, c.a.y / 2 + c.b.y / 2});
    return audit;
  }
  for (const car::Leg& leg : drive.legs) audit.length += car::curve_of(leg).length();
  if (!wants_gap || drive.legs.empty()) return audit;
  const double r = shape.inner_radius();
  const PathAuditor auditor(world, r > 0 ? Footprint::disc(r) : Footprint::point());
  audit.shortest = auditor.shortest(drive.legs.front().from.at, drive.legs.back().to.at);
  return audit;
}

std::string line_of(const DriveAudit& audit, std::size_t legs) {
  if (audit.fault) return "not valid: " + audit.text();
  std::string line = fmt::format("valid, length {:.6f}, {}", audit.length, count_text(legs, "leg"));
  if (audit.shortest) line += fmt::format(", no such car drives less than {:.6f}", audit.shortest->enclosure.lo);
  return line;
}

Json result_of(const DriveAudit& audit, std::size_t legs) {
  Json contact;
  if (audit.at) contact = {{"leg", audit.fault->leg}, {"at", *audit.at}, {"wall", wall_json(*audit.wall)}};
  return {{"kind", "drive"},
          {"valid", !audit.fault},
          {"reason", audit.fault ? Json(audit.text()) : Json()},
          {"contact", std::move(contact)},
          {"legs", legs},
          {"length", audit.fault ? Json() : Json(audit.length)},
          {"lower_bound", audit.shortest ? Json(audit.shortest->enclosure.lo) : Json()}};
}

std::string picture(const DriveAudit& audit, const ClaimedDrive& drive, const car::CarShape& shape, const Input& input,
                    const std::string& name) {
  CarPicture picture;
  picture.title = title_of(name);
  picture.facts = {audit.fault ? "not valid" : "valid", count_text(drive.legs.size(), "leg")};
  picture.legs = drive.legs;
  if (!drive.legs.empty()) {
    picture.start_pose = drive.legs.front().from;
    picture.start = drive.legs.front().from.at;
    picture.goals = {drive.legs.back().to.at};
  }
  if (audit.wall) picture.barrier = {audit.wall->side};
  return car_svg(input.world, shape, picture);
}

}  // namespace

int audit_drive(const AuditOptions& options, const Input& input, std::string_view bytes, const std::string& name,
                Run& run) {
  const ClaimedDrive drive = read_drive(bytes, name);
  const std::optional<car::CarShape> shape = options.car ? options.car : drive.car;
  if (!shape) throw InputError(name, 0, "does not say which car drives; say --car length=L,width=W,radius=R");
  const DriveAudit audit = run.stage("verify", [&] { return audited(drive, *shape, input.world, !options.no_gap); });
  Answer answer{.outcome = audit.fault ? Outcome::invalid : Outcome::done,
                .reason = audit.fault ? audit.text() : "",
                .result = result_of(audit, drive.legs.size()),
                .line = name + ": " + line_of(audit, drive.legs.size()) + "\n"};
  if (!options.svg.empty()) answer.files.push_back({options.svg, picture(audit, drive, *shape, input, name)});
  return run.end(std::move(answer));
}

}  // namespace taut::cli
