#include <taut/cli/drive/world.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include <taut/cli/drive/world_svg.h>
#include <taut/cli/exit_code.h>
#include <taut/cli/input.h>
#include <taut/cli/output.h>
#include <taut/cli/report.h>
#include <taut/cli/timing.h>
#include <taut/geometry/errors.h>
#include <taut/io/results/detail/result_values.h>
#include <taut/io/results/barrier_words.h>
#include <taut/io/results/plane_json.h>
#include <taut/io/results/result_json.h>
#include <taut/robots/car/drive_check.h>
#include <taut/search/no_path.h>
#include <taut/search/voronoi_search.h>

namespace taut::cli {

namespace {

constexpr std::size_t kMostPoses = 3'000'000;  // expanded, until the planner gives up
constexpr double kDegree = std::numbers::pi / 180;

std::optional<int> heading_of(const std::optional<DriveEnd>& end) {
  if (!end || !end->degrees) return std::nullopt;
  return car::nearest_heading(std::remainder(*end->degrees, 360) * kDegree);
}

double degrees_of(int heading) { return car::heading_angle(heading) / kDegree; }

nlohmann::ordered_json json_of(const car::LatticePose& pose) {
  return {pose.at.x, pose.at.y, degrees_of(pose.heading)};
}

/// Straight pieces and arcs, as driven.
nlohmann::ordered_json segments_json(const std::vector<car::Leg>& legs) {
  auto segments = nlohmann::ordered_json::array();
  for (const car::Leg& leg : legs) {
    const car::LegCurve curve = car::curve_of(leg);
    const double gear = leg.backward ? -1 : 1;
    const auto straight = [&](double length) {
      if (length > 0) segments.push_back({{"kind", "straight"}, {"length", gear * length}});
    };
    straight(curve.before);
    if (curve.turn != 0)
      segments.push_back({{"kind", (curve.turn > 0) == (gear > 0) ? "left" : "right"},
                          {"length", gear * curve.radius * std::abs(curve.turn)},
                          {"radius", curve.radius}});
    straight(curve.after);
  }
  return segments;
}

std::size_t reversals_of(const std::vector<car::Leg>& legs) {
  std::size_t count = 0;
  for (std::size_t i = 1; i < legs.size(); ++i) count += legs[i].backward != legs[i - 1].backward;
  return count;
}

class Driver {
 public:
  Driver(const WorldDriveOptions& options, const DriveOutput& output, std::string name)
      : options_(options), output_(output), name_(std::move(name)) {}

  int run(std::string_view bytes) {
    prepare_last_words();
    const World world = timed("read", seconds_.read, [&] { return read(bytes); });
    const car::CarSpace space =
        timed("space", seconds_.space, [&] { return car::CarSpace(FreeSpace(world), *options_.car); });
    query_.start = *world.start();
    query_.heading = heading_of(options_.from);
    query_.goals = goal_points(space.space(), world.goal());
    query_.goal_heading = heading_of(options_.to);
    query_.weight = options_.weight;
    query_.limits.expansions = kMostPoses;
    if (query_.goals.empty()) throw InputError(name_, 0, "the goal's room lies outside the world");
    drive_ = timed("drive", seconds_.search, [&] { return plan(space); });
    if (drive_.status == SearchStatus::found) check(space);
    if (drive_.status == SearchStatus::none) explain(space);
    seconds_.total = total_.seconds();
    begin_stage("write");
    const std::string still = output_.svg.empty() ? "" : drawing(space, false);
    const std::string film = output_.animation.empty() ? "" : drawing(space, true);
    const std::string json = output_.json.empty() ? "" : json_text();
    finish();
    write_file(output_.svg, still);
    write_file(output_.animation, film);
    write_file(output_.json, json);
    if (!output_.quiet && !output_.stdout_taken()) print(name_ + ": " + line() + "\n");
    return drive_.status == SearchStatus::found ? kFound : drive_.status == SearchStatus::none ? kNone : kStopped;
  }

 private:
  World read(std::string_view bytes) const {
    ReadOptions read = options_.world.read;
    read.source = name_;
    World world = read_world(bytes, read);
    if (options_.world.wall_thickness) world = world.with_wall_thickness(*options_.world.wall_thickness);
    const auto point = [](const std::optional<DriveEnd>& end) { return end ? std::optional(end->at) : std::nullopt; };
    if (options_.from || options_.to) world = world.with_ends(point(options_.from), point(options_.to));
    require_ends({world, {}, name_});
    return world;
  }

  car::PlannedDrive plan(const car::CarSpace& space) const {
    try {
      return car::planned_drive(space, query_);
    } catch (const InputError& error) {
      throw InputError(std::string_view(error.what()).starts_with(name_) ? "" : name_, 0, error.what());
    }
  }

  void check(const car::CarSpace& space) const {
    const auto fault = car::fault_of(drive_.legs, space.space(), *options_.car);
    if (fault) throw std::logic_error(fmt::format("the drive's leg {} {}", fault->leg, fault->text));
  }

  void explain(const car::CarSpace& space) {
    const double r = options_.car->inner_radius();
    if (r > 0 && drive_.barrier) {
      const Gates gates(space.space());
      barrier_ = barrier_of(gates, drive_.barrier->barrier);
      reason_ = fmt::format("not even the disc of radius {} inside the car gets through: {}", number_text(r),
                            blocked_text(gates, *drive_.barrier, barrier_, query_.start, query_.goals.front(), r));
      return;
    }
    const auto walls = NoPath(space.space()).walls(query_.start, {query_.goals.front(), {}});
    if (!walls || walls->empty()) return leave_unproven();
    barrier_.walls = joined_walls(*walls, space.space().world().box());
    reason_ = separation_text(barrier_);
  }

  void leave_unproven() { drive_.status = SearchStatus::stopped; }

  std::string given_up_text() const {
    return fmt::format(
        "no drive found, which proves nothing: {} of {} lattices searched, the last with nodes {} apart and {} "
        "headings, {} poses",
        drive_.lattices, car::kLattices, number_text(drive_.step), drive_.headings, drive_.expanded);
  }

  std::string line() const {
    if (drive_.status == SearchStatus::none) return "no drive: " + reason_;
    if (drive_.status == SearchStatus::stopped) return given_up_text();
    return fmt::format(
        "length {:.6f}, at most {} times the shortest on its lattice, no such car drives less than {:.6f}; {}, {}, "
        "checked, {}",
        drive_.length, number_text(options_.weight), drive_.lower_bound, count_text(drive_.legs.size(), "leg"),
        count_text(reversals_of(drive_.legs), "reversal"), seconds_text(seconds_.total));
  }

  std::string drawing(const car::CarSpace& space, bool animate) const {
    WorldDrivePicture picture;
    picture.title = title_of(name_);
    if (drive_.status == SearchStatus::found)
      picture.facts = {fmt::format("length {:.6g}", drive_.length), count_text(drive_.legs.size(), "leg"),
                       count_text(reversals_of(drive_.legs), "reversal")};
    else
      picture.facts = {drive_.status == SearchStatus::none ? "no drive, proven" : "no drive found"};
    picture.legs = drive_.legs;
    if (drive_.status == SearchStatus::found) picture.start_pose = drive_.start;
    picture.start = query_.start;
    picture.goals = query_.goals;
    picture.barrier = barrier_.walls;
    for (const Segment& gate : barrier_.gate_segments()) picture.barrier.push_back(gate);
    picture.animate = animate;
    return world_drive_svg(space.space().world(), *options_.car, picture);
  }

  nlohmann::ordered_json head(const char* status) const {
    const car::CarShape& shape = *options_.car;
    return {{"program", "taut"},
            {"version", TAUT_VERSION},
            {"source", name_},
            {"status", status},
            {"reached", drive_.status == SearchStatus::found},
            {"car",
             {{"front", shape.front},
              {"back", shape.back},
              {"half_width", shape.half_width},
              {"radius", shape.radius},
              {"reverse", shape.reverse}}}};
  }

  nlohmann::ordered_json times() const {
    return {{"read", seconds_.read}, {"space", seconds_.space}, {"search", seconds_.search}, {"total", seconds_.total}};
  }

  std::string json_text() const {
    static constexpr const char* kStatus[] = {"found", "none", "stopped"};
    nlohmann::ordered_json json = head(kStatus[static_cast<int>(drive_.status)]);
    if (drive_.status == SearchStatus::found) {
      json["length"] = drive_.length;
      json["lower_bound"] = drive_.lower_bound;
      json["weight"] = options_.weight;
      json["collisions"] = 0;
      json["verified"] = true;
      json["reversals"] = reversals_of(drive_.legs);
      json["start"] = json_of(drive_.start);
      json["end"] = json_of(drive_.legs.empty() ? drive_.start : drive_.legs.back().to);
      json["segments"] = segments_json(drive_.legs);
      auto legs = nlohmann::ordered_json::array();
      for (const car::Leg& leg : drive_.legs)
        legs.push_back({{"from", json_of(leg.from)},
                        {"to", json_of(leg.to)},
                        {"headings", {leg.from.heading, leg.to.heading}},
                        {"backward", leg.backward}});
      json["legs"] = std::move(legs);
    } else {
      json["reason"] = drive_.status == SearchStatus::none ? reason_ : given_up_text();
      if (drive_.status == SearchStatus::none) json["barrier"] = nlohmann::ordered_json::parse(json_line(barrier_json(barrier_)));
    }
    json["lattice"] = {{"step", drive_.step},
                       {"headings", drive_.headings},
                       {"searched", drive_.lattices},
                       {"expanded", drive_.expanded},
                       {"tested", drive_.tested}};
    json["seconds"] = times();
    return detail::json_text(json);
  }

  void prepare_last_words() const {
    if (output_.json.empty()) return;
    on_stop([json = head("stopped"), total = total_, file = output_.json](const Stop& why) mutable {
      json["reason"] = why.reason;
      json["stage"] = why.stage;
      json["seconds"] = {{"total", total.seconds()}};
      write_file(file, detail::json_text(json));
    });
  }

  const WorldDriveOptions& options_;
  const DriveOutput& output_;
  std::string name_;
  car::DriveQuery query_;
  car::PlannedDrive drive_;
  Barrier barrier_;
  std::string reason_;
  StageSeconds seconds_;
  Stopwatch total_;
};

bool is_road_map(std::string_view bytes) {
  for (std::size_t at = 0; at < bytes.size();) {
    const std::size_t end = std::min(bytes.find('\n', at), bytes.size());
    const std::string_view row = bytes.substr(at, end - at);
    if (row.starts_with("grid ") || row.starts_with("roadblock ")) return true;
    at = end + 1;
  }
  return false;
}

}  // namespace

void require_road_map(std::string_view bytes, const std::string& name) {
  if (is_road_map(bytes)) return;
  try {
    detect_format(bytes, name);
  } catch (const InputError&) {
    return;
  }
  throw InputError(name, 0,
                   "is no roadblock map but a world; say which car drives there: --car length=L,width=W,radius=R");
}

int drive_in_world(const WorldDriveOptions& options, std::string_view bytes, const std::string& name,
                   const DriveOutput& output) {
  if (is_road_map(bytes)) throw InputError(name, 0, "is a roadblock map, whose rules fix the car; leave out --car");
  return Driver(options, output, name).run(bytes);
}

}  // namespace taut::cli
