#include <taut/cli/drive/world.h>

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include <taut/cli/input.h>
#include <taut/cli/messages.h>
#include <taut/cli/world/foreign.h>
#include <taut/geometry/errors.h>
#include <taut/io/pictures/car_svg.h>
#include <taut/io/results/barrier_words.h>
#include <taut/io/results/drive_json.h>
#include <taut/io/results/drive_path.h>
#include <taut/robots/car/verify_drive.h>
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

Json json_of(const Barrier& barrier) {
  Json gates = Json::array();
  for (const NamedGate& gate : barrier.gates)
    gates.push_back({{"posts", gate.at}, {"width", gate.width}, {"width_text", gate.width_text}});
  return {{"walls", barrier.walls}, {"gates", std::move(gates)}};
}

Outcome outcome_of(SearchStatus status) {
  if (status == SearchStatus::stopped) return Outcome::unproven;
  return status == SearchStatus::found ? Outcome::found : Outcome::none;
}

class Driver {
 public:
  Driver(const WorldDriveOptions& options, const DriveOutput& output, std::string name, Run& run)
      : options_(options), output_(output), name_(std::move(name)), run_(run) {}

  int drive(std::string_view bytes) {
    const World world = run_.stage("read", [&] { return read(bytes); });
    const car::CarSpace space = run_.stage("space", [&] { return car::CarSpace(FreeSpace(world), *options_.car); });
    prepare_query(space);
    drive_ = run_.stage("drive", [&] { return plan(space); });
    if (drive_.status == SearchStatus::found) run_.stage("verify", [&] { check(space); });
    run_.so_far(car_drive_json(drive_, *options_.car, options_.weight));
    if (drive_.status == SearchStatus::none) run_.stage("explain", [&] { explain(space); });
    if (drive_.status == SearchStatus::stopped) reason_ = given_up_text();
    Answer answer{.outcome = outcome_of(drive_.status),
                  .reason = reason_,
                  .result = car_drive_json(drive_, *options_.car, options_.weight),
                  .line = name_ + ": " + line() + "\n"};
    if (drive_.status == SearchStatus::none) answer.result["barrier"] = json_of(barrier_);
    if (!output_.svg.empty()) answer.files.push_back({output_.svg, drawing(space, false)});
    if (!output_.animation.empty()) answer.files.push_back({output_.animation, drawing(space, true)});
    if (drive_.status == SearchStatus::found)
      add_path_files(answer.files, output_.files, {drive_path(drive_.legs, drive_.start, drive_.length)});
    return run_.end(std::move(answer));
  }

 private:
  void prepare_query(const car::CarSpace& space) {
    const World& world = space.space().world();
    query_.start = *world.start();
    query_.heading = heading_of(options_.from);
    query_.goals = goal_points(space.space(), world.goal());
    query_.goal_heading = heading_of(options_.to);
    query_.weight = options_.weight;
    query_.limits.expansions = kMostPoses;
    if (query_.goals.empty()) throw InputError(name_, 0, "the goal's room lies outside the world");
  }

  World read(std::string_view bytes) const {
    ReadOptions read = reading_of(options_.world.file, options_.world.read);
    const auto point = [](const std::optional<DriveEnd>& end) { return end ? std::optional(end->at) : std::nullopt; };
    read.start = point(options_.from);
    read.goal = point(options_.to);
    ReadNotes notes;
    World world = read_world(bytes, read, &notes);
    tell(notes, name_, run_);
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
    const auto fault = car::verify_drive(drive_.legs, space.space(), *options_.car);
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
    if (drive_.status == SearchStatus::stopped) return reason_;
    return fmt::format(
        "length {:.6f}, at most {} times the shortest on its lattice, no such car drives less than {:.6f}; {}, {}, "
        "checked, {}",
        drive_.length, number_text(options_.weight), drive_.lower_bound, count_text(drive_.legs.size(), "leg"),
        count_text(car::reversals_of(drive_.legs), "reversal"), seconds_text(run_.seconds().wall));
  }

  std::string drawing(const car::CarSpace& space, bool animate) const {
    CarPicture picture;
    picture.title = title_of(name_);
    if (drive_.status == SearchStatus::found)
      picture.facts = {fmt::format("length {:.6g}", drive_.length), count_text(drive_.legs.size(), "leg"),
                       count_text(car::reversals_of(drive_.legs), "reversal")};
    else
      picture.facts = {drive_.status == SearchStatus::none ? "no drive, proven" : "no drive found"};
    picture.legs = drive_.legs;
    if (drive_.status == SearchStatus::found) picture.start_pose = drive_.start;
    picture.start = query_.start;
    picture.goals = query_.goals;
    picture.barrier = barrier_.walls;
    for (const Segment& gate : barrier_.gate_segments()) picture.barrier.push_back(gate);
    picture.animate = animate;
    return car_svg(space.space().world(), *options_.car, picture);
  }

  const WorldDriveOptions& options_;
  const DriveOutput& output_;
  std::string name_;
  Run& run_;
  car::DriveQuery query_;
  car::PlannedDrive drive_;
  Barrier barrier_;
  std::string reason_;
};

}  // namespace

void require_roadblock_map(std::string_view bytes, const std::string& name) {
  if (file_kind(bytes) == FileKind::world)
    throw InputError(name, 0,
                     "is no roadblock map but a world; say which car drives there: --car length=L,width=W,radius=R");
  redirect(bytes, name, {FileKind::roadblock_map});
}

int drive_in_world(const WorldDriveOptions& options, const DriveOutput& output, std::string_view bytes,
                   const std::string& name, Run& run) {
  if (file_kind(bytes) == FileKind::roadblock_map)
    throw InputError(name, 0, "is a roadblock map, whose rules fix the car; leave out --car");
  return Driver(options, output, name, run).drive(bytes);
}

}  // namespace taut::cli
