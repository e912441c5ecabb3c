// taut drive: a car through a maze whose roadblocks show only from near; with --car, any car in any world.
#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <taut/cli/command.h>
#include <taut/cli/command_line.h>
#include <taut/cli/drive/report.h>
#include <taut/cli/drive/svg.h>
#include <taut/cli/drive/world.h>
#include <taut/cli/exit_code.h>
#include <taut/cli/output.h>
#include <taut/cli/report.h>
#include <taut/cli/timing.h>
#include <taut/geometry/errors.h>
#include <taut/io/worlds/read_world.h>
#include <taut/robots/roadblocks/drivers.h>
#include <taut/robots/roadblocks/peers.h>
#include <taut/robots/roadblocks/value_planner.h>

namespace taut::cli {

namespace {

struct DriveOptions {
  std::string file;
  std::optional<int> sample;
  bool all = false;
  std::string bits;
  car::DriverKind planner = car::DriverKind::ours;
  const car::Peer* peer = nullptr;  ///< instead
  car::Aim aim = car::Aim::expected;
  car::WallReading walls = car::WallReading::points;
  DriveOutput output;
  bool show_values = false;
  bool controls = false;
  WorldDriveOptions world;
  CommonOptions common;
};

void choose_planner(const std::string& word, DriveOptions& options) {
  const auto kind = car::driver_named(word);
  options.peer = car::peer_named(word);
  if (!kind && !options.peer) {
    std::string names = "ours, optimist, pessimist, clairvoyant";
    for (const car::Peer& peer : car::peers()) names += ", " + std::string(peer.name);
    throw UsageError("--planner: '" + word + "' is none of " + names);
  }
  if (kind) options.planner = *kind;
}

std::string planner_name(const DriveOptions& options) {
  return std::string(options.peer ? options.peer->name : car::name(options.planner));
}

car::Aim aim_of(const std::string& word) {
  if (word == "expected") return car::Aim::expected;
  if (word == "worst") return car::Aim::worst;
  throw UsageError("--policy: '" + word + "' is not expected or worst");
}

car::WallReading walls_of(const std::string& word) {
  if (word == "points") return car::WallReading::points;
  if (word == "squares") return car::WallReading::squares;
  throw UsageError("--walls: '" + word + "' is not points or squares");
}

/// The first of these options that is given; empty when none is.
std::string first_given(const CommandLine& app, std::initializer_list<const char*> names) {
  for (const char* name : names)
    if (app.count(name) > 0) return name;
  return "";
}

/// Each option is for roadblock maps, for general cars or for both: none is ignored.
void require_one_kind(const CommandLine& app, const DriveOptions& options) {
  const std::string for_maps = first_given(
      app, {"--sample", "--all", "--open", "--planner", "--policy", "--walls", "--show-values", "--controls"});
  const std::string for_cars =
      first_given(app, {"--from", "--to", "--weight", "--wall-thickness", "--polygons", "--format"});
  if (options.world.car && !for_maps.empty())
    throw UsageError("--car drives in a world of walls: not with " + for_maps);
  if (!options.world.car && !for_cars.empty())
    throw UsageError(for_cars + " needs --car: a roadblock map says where its own car starts");
}

void require_consistent(const CommandLine& app, const DriveOptions& options) {
  require_one_kind(app, options);
  if (options.sample.has_value() + options.all + !options.bits.empty() > 1)
    throw UsageError("only one of --sample, --all and --open");
  if (options.bits.find_first_not_of("01") != std::string::npos)
    throw UsageError("--open: '" + options.bits + "' is not of 0 and 1, one a roadblock");
  if (app.count("--policy") > 0 && planner_name(options) != "ours") throw UsageError("--policy is for --planner ours");
  if (options.controls && options.output.json.empty()) throw UsageError("--controls needs --json");
  if (options.output.draws() && options.all) throw UsageError("--svg draws one drive: give --sample I");
  if (options.show_values && !options.output.draws()) throw UsageError("--show-values needs --svg");
}

void add_options(CommandLine& app, DriveOptions& options) {
  add_world_drive_options(app, options.world);
  app.add_option("--sample", options.sample, "Drive this sample of the file (default: its first)").type_name("I");
  app.add_flag("--all", options.all, "Drive all samples of the file");
  app.add_option("--open", options.bits, "Drive with these roadblocks open, as 101 for A and C").type_name("BITS");
  app.add_option_function(
         "--planner", [&options](const std::string& word) { choose_planner(word, options); },
         "ours (default), optimist, pessimist, clairvoyant (knows the sample: a bound); to compare with: rrt, "
         "rrt-field, rrt-star, rrt-connect (with --seed), value-iteration")
      .type_name("NAME");
  app.add_option_function(
         "--policy", [&options](const std::string& word) { options.aim = aim_of(word); },
         "What the planner ours makes least: expected (default) or worst steps over what may be learnt")
      .type_name("NAME");
  app.add_option_function(
         "--walls", [&options](const std::string& word) { options.walls = walls_of(word); },
         "points (default, the course's rule): a wall is its cell's centre, tested at the end of a step; squares: "
         "whole cells, the whole step")
      .type_name("NAME");
  app.add_option("--svg", options.output.svg, "Draw the drive; - is standard output").type_name("FILE").group("Output");
  add_animate_option(app, options.output.animation, "Draw the car as it drives, an SVG that plays in a browser");
  app.add_flag("--show-values", options.show_values,
               "Draw the surface and the arrows of value iteration; --planner value-iteration does")
      .group("Output");
  app.add_option("--json", options.output.json, "An array of results, one a sample; - is standard output")
      .type_name("FILE")
      .group("Output");
  app.add_flag("--controls", options.controls, "Put each drive's controls into the JSON").group("Output");
  app.add_flag("-q,--quiet", options.output.quiet, "Print no table").group("Output");
  app.callback([&app, &options] {
    options.file = options.world.world.file;
    settle_animation(app, options.output.animation, options.output.svg, options.output.json);
    require_consistent(app, options);
  });
}

std::vector<car::Sample> chosen_samples(const DriveOptions& options, const car::RoadMap& map, const std::string& name) {
  if (!options.bits.empty()) return {{0, car::roadblocks_of(options.bits, map.course, "--open")}};
  if (options.all && map.samples.empty()) throw InputError(name, 0, "has no samples for --all; give --open BITS");
  if (options.all) return map.samples;
  if (options.sample) {
    for (const car::Sample& sample : map.samples)
      if (sample.number == *options.sample) return {sample};
    throw InputError(name, 0, fmt::format("has no sample {}", *options.sample));
  }
  if (!map.samples.empty()) return {map.samples.front()};
  return {{0, car::roadblocks_of(std::string(map.course.roadblocks.size(), '1'), map.course)}};
}

/// Takes the time of another driver's decisions.
class TimedDriver : public car::Driver {
 public:
  explicit TimedDriver(std::unique_ptr<car::Driver> driver) : driver_(std::move(driver)) {}

  std::optional<double> next(const car::ObservedMap& map, const car::Pose& pose) override {
    const Stopwatch watch;
    const std::optional<double> control = driver_->next(map, pose);
    const double ms = 1000 * watch.seconds();
    if (asked_++ == 0)
      first_ = ms;
    else
      slowest_later_ = std::max(slowest_later_, ms);
    return control;
  }
  int replans() const override { return driver_->replans(); }
  bool gave_up() const override { return driver_->gave_up(); }
  bool exact() const override { return driver_->exact(); }
  double first() const { return first_; }                  ///< the first plan, milliseconds
  double slowest_later() const { return slowest_later_; }  ///< the slowest decision after it

 private:
  std::unique_ptr<car::Driver> driver_;
  int asked_ = 0;
  double first_ = 0, slowest_later_ = 0;
};

// A collision is a defect of the driver: it never enters what it does not know to be free.
ExitCode code_of(car::Outcome outcome) {
  switch (outcome) {
    case car::Outcome::reached: return kFound;
    case car::Outcome::no_route: return kNone;
    case car::Outcome::limit:
    case car::Outcome::gave_up: return kStopped;
    case car::Outcome::collision: break;
  }
  return kInternal;
}

/// With what was known at the end, as a driver along values would plan from the start.
ValueLayer last_values(const car::Course& course, const car::Drive& drive, car::WallReading walls) {
  car::ValuePlanner planner(course, walls);
  planner.plan(drive.poses.front(), drive.known() & ~drive.open);
  if (!planner.grid()) return {};
  return value_layer(*planner.grid(), *planner.values());
}

std::string picture_of(const DriveResult& result, const car::Course& course, const DriveOptions& options,
                       const std::string& name, bool animate) {
  const bool has_values = options.show_values || planner_name(options) == "value-iteration";
  const ValueLayer values = has_values ? last_values(course, result.drive, options.walls) : ValueLayer{};
  DrivePicture picture{fmt::format("{}, sample {}", title_of(name), result.sample.number),
                       {std::string(car::name(result.drive.outcome)), count_text(result.steps(), "step"),
                        count_text(static_cast<std::size_t>(result.drive.replans), "replan"), planner_name(options)},
                       options.walls,
                       animate,
                       has_values ? &values : nullptr};
  return drive_svg(course, result.drive, picture);
}

/// Trees draw anew for each sample; a sample drives the same alone and among all.
std::unique_ptr<car::Driver> driver_for(const car::Sample& sample, const car::Course& course,
                                        car::LatticePlanner& planner, const DriveOptions& options) {
  if (options.peer)
    return options.peer->make(course, options.walls, options.common.seed + static_cast<std::uint64_t>(sample.number));
  return car::make_driver(options.planner, planner, sample.open, options.aim);
}

void write_results(const DriveOptions& options, const car::Course& course, const std::string& name,
                   const std::vector<DriveResult>& results) {
  const std::string still = options.output.svg.empty() ? "" : picture_of(results.back(), course, options, name, false);
  const std::string film =
      options.output.animation.empty() ? "" : picture_of(results.back(), course, options, name, true);
  write_file(options.output.svg, still);
  write_file(options.output.animation, film);
  const DriveReportOptions report{planner_name(options), options.common.seed, options.controls, options.all};
  write_file(options.output.json, drive_json(results, course, report));
  if (!options.output.quiet && !options.output.stdout_taken()) print(drive_table(results, course, report));
}

int run(const DriveOptions& options) {
  require_writable(options.output.svg);
  require_writable(options.output.animation);
  require_writable(options.output.json);
  begin_stage("read");
  const std::string name = options.file == "-" ? "<stdin>" : options.file;
  const std::string bytes = read_bytes(options.file);
  if (options.world.car) return drive_in_world(options.world, bytes, name, options.output);
  require_road_map(bytes, name);
  const car::RoadMap map = car::read_road_map(bytes, name);
  car::require_start_free(map.course, options.walls, name);
  begin_stage("drive");
  car::LatticePlanner planner(map.course, options.walls);
  std::vector<DriveResult> results;
  for (const car::Sample& sample : chosen_samples(options, map, name)) {
    TimedDriver driver(driver_for(sample, map.course, planner, options));
    car::Drive drive = car::drive(map.course, sample.open, driver, options.walls);
    const bool has_policy = !options.peer && options.planner == car::DriverKind::ours;
    const auto policy_exact = has_policy ? std::optional(driver.exact()) : std::nullopt;
    results.push_back({sample, std::move(drive), driver.first(), driver.slowest_later(), policy_exact});
  }
  finish();
  write_results(options, map.course, name, results);
  int code = kFound;
  for (const DriveResult& result : results) code = std::max<int>(code, code_of(result.drive.outcome));
  return code;
}

}  // namespace

Command drive_command(CommandLine& app) {
  return command<DriveOptions>(app, "drive", "Drive a car through a maze with roadblocks that show only from near",
                               add_options, run);
}

}  // namespace taut::cli
