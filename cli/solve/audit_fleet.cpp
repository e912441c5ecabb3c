// taut audit: many robots with times, against each other and against walls.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include <taut/cli/solve/audit.h>
#include <taut/geometry/errors.h>
#include <taut/io/pictures/svg.h>
#include <taut/io/results/words.h>
#include <taut/io/worlds/read_fleet.h>
#include <taut/search/path_audit.h>

namespace taut::cli {

namespace {

using fleet::Collision;
using fleet::Robot;

/// A robot that its walls stop.
struct Bump {
  std::size_t robot = 0;
  double time = 0;
  std::string reason;
  std::optional<PathContact> contact;
};

class FleetAudit {
 public:
  FleetAudit(const AuditOptions& options, const Input& input, std::string name, Run& run)
      : options_(options), input_(input), name_(std::move(name)), run_(run) {}

  int judge(std::string_view bytes) {
    if (options_.robot.kind() == Footprint::Kind::polygon)
      throw InputError(name_, 0, "robots with times are discs; say --robot disc:R");
    const bool has_radius = options_.robot.kind() == Footprint::Kind::disc;
    robots_ = run_.stage("read", [&] {
      return read_fleet(bytes, has_radius ? std::optional(options_.robot.radius()) : std::nullopt, name_);
    });
    run_.stage("walls", [&] { ask_walls(); });
    run_.so_far(result(), "");
    const fleet::Ends ends = options_.vanish ? fleet::Ends::vanish : fleet::Ends::stay;
    collisions_ = run_.stage("collisions", [&] { return fleet::collisions(robots_, ends); });
    return end();
  }

 private:
  void ask_walls() {
    std::map<double, PathAuditor> auditors;  // by radius
    std::vector<Point> points;
    for (std::size_t i = 0; i < robots_.size(); ++i) {
      const Robot& robot = robots_[i];
      auto found = auditors.find(robot.radius);
      if (found == auditors.end())
        found = auditors.emplace(robot.radius, PathAuditor(input_.world, Footprint::disc(robot.radius))).first;
      points.clear();
      for (const fleet::TimedPoint& p : robot.points) points.push_back(p.at);
      PathAudit audit = found->second.check(points);
      if (!audit.valid) bumps_.push_back({i, time_of(robot, audit.contact), audit.reason, audit.contact});
    }
    std::stable_sort(bumps_.begin(), bumps_.end(), [](const Bump& a, const Bump& b) { return a.time < b.time; });
  }

  static double time_of(const Robot& robot, const std::optional<PathContact>& contact) {
    const std::size_t leg = contact ? contact->leg : 0;
    const fleet::TimedPoint a = robot.points[leg], b = robot.points[std::min(leg + 1, robot.points.size() - 1)];
    const double length = std::hypot(b.at.x - a.at.x, b.at.y - a.at.y);
    if (!contact || length == 0) return a.time;
    const double part = std::hypot(contact->at.x - a.at.x, contact->at.y - a.at.y) / length;
    return a.time + std::min(part, 1.0) * (b.time - a.time);
  }

  const std::string& id(std::size_t robot) const { return robots_[robot].id; }

  std::string text_of(const Collision& c) const {
    const std::string since =
        std::isfinite(c.from) ? fmt::format("from {}", number_text(c.from)) : "from the beginning";
    const std::string until = std::isfinite(c.to) ? fmt::format(" to {}", number_text(c.to)) : " on";
    return fmt::format("robots {} and {} collide {}{}, at {} and {}", id(c.first), id(c.second), since, until,
                       point_text(c.first_at), point_text(c.second_at));
  }

  std::string text_of(const Bump& bump) const {
    return fmt::format("robot {}: {}, at time {}", id(bump.robot), bump.reason, number_text(bump.time));
  }

  /// What happens first.
  std::string fault() const {
    if (collisions_.empty() && bumps_.empty()) return {};
    if (bumps_.empty() || (!collisions_.empty() && collisions_.front().from <= bumps_.front().time))
      return text_of(collisions_.front());
    return text_of(bumps_.front());
  }

  std::size_t legs() const {
    std::size_t count = 0;
    for (const Robot& robot : robots_) count += robot.points.size() - 1;
    return count;
  }

  std::string line() const {
    const std::string all =
        fmt::format("{}: {}, {}", name_, count_text(robots_.size(), "robot"), count_text(legs(), "leg"));
    if (fault().empty()) return all + ": valid, no two collide and none meets a wall\n";
    return fmt::format("{}: not valid: {}; {}, {} at walls in all\n", all, fault(),
                       count_text(collisions_.size(), "collision"), count_text(bumps_.size(), "robot"));
  }

  Json json_of(const Collision& c) const {
    return {{"robots", Json::array({id(c.first), id(c.second)})},
            {"legs", Json::array({c.first_leg, c.second_leg})},
            {"from", c.from},
            {"to", c.to},
            {"at", Json::array({c.first_at, c.second_at})}};
  }

  Json json_of(const Bump& bump) const {
    Json json{{"robot", id(bump.robot)}, {"time", bump.time}, {"reason", bump.reason}};
    if (!bump.contact) return json;
    json["leg"] = bump.contact->leg;
    json["at"] = bump.contact->at;
    json["on"] = bump.contact->on;
    json["wall"] = wall_json(bump.contact->wall);
    return json;
  }

  Json result() const {
    Json collisions = Json::array(), walls = Json::array();
    for (std::size_t i = 0; i < std::min(collisions_.size(), kCollisionsListed); ++i)
      collisions.push_back(json_of(collisions_[i]));
    for (std::size_t i = 0; i < std::min(bumps_.size(), kCollisionsListed); ++i) walls.push_back(json_of(bumps_[i]));
    return {{"kind", "robots"},
            {"robots", robots_.size()},
            {"legs", legs()},
            {"collisions", collisions_.size()},
            {"at_walls", bumps_.size()},
            {"first_collisions", std::move(collisions)},
            {"first_at_walls", std::move(walls)}};
  }

  std::string picture() const {
    SvgPicture picture;
    picture.title = title_of(name_);
    picture.facts = {count_text(robots_.size(), "robot"), count_text(collisions_.size(), "collision")};
    for (const Robot& robot : robots_) {
      SvgShade shade{{}, 0.2};
      for (std::size_t i = 0; i + 1 < robot.points.size(); ++i) {
        const Point a = robot.points[i].at, b = robot.points[i + 1].at;
        shade.curves.push_back({a, {a.x / 2 + b.x / 2, a.y / 2 + b.y / 2}, b});
      }
      if (!shade.curves.empty()) picture.shades.push_back(std::move(shade));
    }
    if (!collisions_.empty()) {
      const Collision& c = collisions_.front();
      for (const auto& [robot, at] : {std::pair(c.first, c.first_at), std::pair(c.second, c.second_at)}) {
        picture.discs.push_back({at, robots_[robot].radius});
        picture.labels.push_back({at, id(robot)});
      }
    }
    for (const Bump& bump : bumps_) {
      if (!bump.contact || picture.labels.size() >= kPlansNamed) continue;
      picture.discs.push_back({bump.contact->at, robots_[bump.robot].radius});
      picture.labels.push_back({bump.contact->at, id(bump.robot)});
      picture.separation.push_back(bump.contact->wall.side);
    }
    return svg(FreeSpace(input_.world), picture);
  }

  int end() {
    Answer answer{.outcome = fault().empty() ? Outcome::done : Outcome::invalid,
                  .reason = fault(),
                  .result = result(),
                  .line = line()};
    if (!options_.svg.empty()) answer.files.push_back({options_.svg, picture()});
    return run_.end(std::move(answer));
  }

  const AuditOptions& options_;
  const Input& input_;
  std::string name_;
  Run& run_;
  std::vector<Robot> robots_;
  std::vector<Bump> bumps_;  ///< by time
  std::vector<Collision> collisions_;
};

}  // namespace

int audit_fleet(const AuditOptions& options, const Input& input, std::string_view bytes, const std::string& name,
                Run& run) {
  return FleetAudit(options, input, name, run).judge(bytes);
}

}  // namespace taut::cli
