// taut drive: a car through a maze whose roadblocks show only from near; with --car, any car in any world.
#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <taut/cli/command.h>
#include <taut/cli/command_line.h>
#include <taut/cli/drive/table.h>
#include <taut/cli/drive/world.h>
#include <taut/cli/keeping.h>
#include <taut/cli/report.h>
#include <taut/cli/run.h>
#include <taut/geometry/errors.h>
#include <taut/io/pictures/drive_svg.h>
#include <taut/io/worlds/road_map.h>
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
  roadblocks::DriverKind planner = roadblocks::DriverKind::policy;
  const roadblocks::Peer* peer = nullptr;  ///< instead
  roadblocks::Aim aim = roadblocks::Aim::expected;
  roadblocks::WallReading walls = roadblocks::WallReading::points;
  DriveOutput output;
  bool show_values = false;
  bool controls = false;
  WorldDriveOptions world;
  CommonOptions common;
};

void choose_planner(const std::string& word, DriveOptions& options) {
  const auto kind = roadblocks::driver_named(word);
  options.peer = roadblocks::peer_named(word);
  if (!kind && !options.peer) {
    if (word == "ours") throw UsageError("'ours' is policy here; did you mean `--planner policy`?");
    std::string names = "policy, optimist, pessimist, clairvoyant";
    for (const roadblocks::Peer& peer : roadblocks::peers()) names += ", " + std::string(peer.name);
    throw UsageError("'" + word + "' is none of " + names);
  }
  if (kind) options.planner = *kind;
}

std::string planner_name(const DriveOptions& options) {
  return std::string(options.peer ? options.peer->name : roadblocks::name(options.planner));
}

roadblocks::Aim aim_of(const std::string& word) {
  if (word == "expected") return roadblocks::Aim::expected;
  if (word == "worst") return roadblocks::Aim::worst;
  throw UsageError("'" + word + "' is not expected or worst");
}

roadblocks::WallReading walls_of(const std::string& word) {
  if (word == "points") return roadblocks::WallReading::points;
  if (word == "squares") return roadblocks::WallReading::squares;
  throw UsageError("'" + word + "' is not points or squares");
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
  if (app.count("--policy") > 0 && planner_name(options) != "policy")
    throw UsageError("--policy is for --planner policy");
  if (options.controls && options.common.json.empty()) throw UsageError("--controls needs --json");
  if (options.output.draws() && options.all) throw UsageError("--svg draws one drive: give --sample I");
  if (options.show_values && !options.output.draws()) throw UsageError("--show-values needs --svg");
}

void add_explanations(CommandLine& app) {
  app.explain("Planners", {{"policy", "the fewest steps over what may be learnt on the way (--policy)"},
                           {"optimist", "takes unknown roadblocks for open until it sees otherwise"},
                           {"pessimist", "takes unknown roadblocks for closed while there is another way"},
                           {"clairvoyant", "is told the sample: a bound for all others"},
                           {"rrt", "a random tree of the car's controls (--seed); like all below, an optimist"},
                           {"rrt-field", "the same, half of the samples along the way of a disc"},
                           {"rrt-star", "a random tree that rewires"},
                           {"rrt-connect", "two random trees, one from the goal"},
                           {"value-iteration", "on cells x 8 headings"}});
  app.explain("Walls", {{"points", "a wall is its cell's centre, tested at the end of a step"},
                        {"squares", "a wall is its whole cell, tested all along the step"}});
  app.example("taut drive map.txt --all --policy worst --json drives.json");
  app.example("taut drive plan.geojson --car length=0.4,width=0.2,radius=0.3 --from 1,1,90 --to 5,3 --svg drive.svg");
}

void add_options(CommandLine& app, DriveOptions& options) {
  add_world_drive_options(app, options.world);
  app.add_option("--sample", options.sample, "Drive this sample of the file (default: its first)").type_name("I");
  app.add_flag("--all", options.all, "Drive all samples of the file");
  app.add_option("--open", options.bits, "Drive with these roadblocks open, as 101 for A and C").type_name("BITS");
  app.add_option_function(
         "--planner", [&options](const std::string& word) { choose_planner(word, options); },
         "Who drives (default: policy)")
      .type_name("NAME");
  app.add_option_function(
         "--policy", [&options](const std::string& word) { options.aim = aim_of(word); },
         "What the planner policy makes least: expected (default) or worst steps over what may be learnt")
      .type_name("NAME");
  app.add_option_function(
         "--walls", [&options](const std::string& word) { options.walls = walls_of(word); },
         "What a closed cell is (default: points)")
      .type_name("NAME");
  app.add_option("--svg", options.output.svg, "Draw the drive; - is standard output").type_name("FILE").group("Output");
  add_animate_option(app, options.output.animation, "Draw the car as it drives, an SVG that plays in a browser");
  app.add_flag("--show-values", options.show_values,
               "Draw the surface and the arrows of value iteration; --planner value-iteration does")
      .group("Output");
  app.add_flag("--controls", options.controls, "Put each drive's controls into the JSON").group("Output");
  app.callback([&app, &options] {
    options.file = options.world.world.file;
    settle_animation(app, options.output.animation, options.output.svg, options.common.json);
    require_consistent(app, options);
  });
  add_explanations(app);
}

std::vector<roadblocks::Sample> chosen_samples(const DriveOptions& options, const roadblocks::RoadMap& map,
                                               const std::string& name) {
  if (!options.bits.empty()) return {{0, roadblocks_of(options.bits, map.course, "--open")}};
  if (options.all && map.samples.empty()) throw InputError(name, 0, "has no samples for --all; give --open BITS");
  if (options.all) return map.samples;
  if (options.sample) {
    for (const roadblocks::Sample& sample : map.samples)
      if (sample.number == *options.sample) return {sample};
    throw InputError(name, 0, fmt::format("has no sample {}", *options.sample));
  }
  if (!map.samples.empty()) return {map.samples.front()};
  return {{0, roadblocks_of(std::string(map.course.roadblocks.size(), '1'), map.course)}};
}

/// Takes the time of another driver's decisions.
class TimedDriver : public roadblocks::Driver {
 public:
  TimedDriver(std::unique_ptr<roadblocks::Driver> driver, const Run& run) : driver_(std::move(driver)), run_(run) {}

  std::optional<double> next(const roadblocks::ObservedMap& map, const roadblocks::Pose& pose) override {
    const double begin = run_.seconds().cpu;
    const std::optional<double> control = driver_->next(map, pose);
    const double ms = 1000 * (run_.seconds().cpu - begin);
    if (asked_++ == 0)
      first_ = ms;
    else
      slowest_later_ = std::max(slowest_later_, ms);
    return control;
  }
  int replans() const override { return driver_->replans(); }
  bool gave_up() const override { return driver_->gave_up(); }
  bool exact() const override { return driver_->exact(); }
  double first() const { return first_; }                  ///< the first plan, CPU milliseconds
  double slowest_later() const { return slowest_later_; }  ///< the slowest decision after it

 private:
  std::unique_ptr<roadblocks::Driver> driver_;
  const Run& run_;
  int asked_ = 0;
  double first_ = 0, slowest_later_ = 0;
};

// Of one drive.
Outcome outcome_of(roadblocks::Outcome outcome) {
  switch (outcome) {
    case roadblocks::Outcome::reached: return Outcome::found;
    case roadblocks::Outcome::no_route: return Outcome::none;
    case roadblocks::Outcome::limit:
    case roadblocks::Outcome::gave_up: return Outcome::unproven;
    case roadblocks::Outcome::collision: break;
  }
  throw std::logic_error("the car collided: a driver never enters what it does not know to be free");
}

/// With what was known at the end, as a driver along values would plan from the start.
ValueLayer last_values(const roadblocks::Course& course, const roadblocks::Drive& drive,
                       roadblocks::WallReading walls) {
  roadblocks::ValuePlanner planner(course, walls);
  planner.plan(drive.poses.front(), drive.known() & ~drive.open);
  if (!planner.grid()) return {};
  return value_layer(*planner.grid(), *planner.values());
}

std::string picture_of(const RoadblockDrive& result, const roadblocks::Course& course, const DriveOptions& options,
                       const std::string& source, bool animate) {
  const bool has_values = options.show_values || planner_name(options) == "value-iteration";
  const ValueLayer values = has_values ? last_values(course, result.drive, options.walls) : ValueLayer{};
  DrivePicture picture{fmt::format("{}, sample {}", title_of(source), result.sample.number),
                       {std::string(name(result.drive.outcome)), count_text(result.steps(), "step"),
                        count_text(static_cast<std::size_t>(result.drive.replans), "replan"), planner_name(options)},
                       options.walls,
                       animate,
                       has_values ? &values : nullptr};
  return drive_svg(course, result.drive, picture);
}

/// Trees draw anew for each sample; a sample drives the same alone and among all.
std::unique_ptr<roadblocks::Driver> driver_for(const roadblocks::Sample& sample, const roadblocks::Course& course,
                                               roadblocks::LatticePlanner& planner, const DriveOptions& options) {
  if (options.peer)
    return options.peer->make(course, options.walls, options.common.seed + static_cast<std::uint64_t>(sample.number));
  return roadblocks::make_driver(options.planner, planner, sample.open, options.aim);
}

RoadblockDrive driven(const roadblocks::Sample& sample, const roadblocks::Course& course,
                      roadblocks::LatticePlanner& planner, const DriveOptions& options, const Run& run) {
  TimedDriver driver(driver_for(sample, course, planner, options), run);
  roadblocks::Drive drive = roadblocks::drive(course, sample.open, driver, options.walls);
  outcome_of(drive.outcome);
  const bool has_policy = !options.peer && options.planner == roadblocks::DriverKind::policy;
  const auto policy_exact = has_policy ? std::optional(driver.exact()) : std::nullopt;
  return {sample, std::move(drive), driver.first(), driver.slowest_later(), policy_exact};
}

/// The drives so far, in three forms.
class Logbook {
 public:
  Logbook(const DriveOptions& options, const roadblocks::Course& course)
      : course_(course), driver_{planner_name(options), options.common.seed, options.controls}, all_(options.all) {}

  void add(RoadblockDrive drive) {
    json_.push_back(roadblock_drive_json(drive, course_, driver_));
    drives_.push_back(std::move(drive));
  }
  const Json& json() const { return json_; }
  std::string table() const { return drive_table(drives_, course_, all_); }
  const RoadblockDrive& last() const { return drives_.back(); }

  /// The answer but for its pictures: what is least sure of all drives.
  Answer answer() const {
    Answer answer{.outcome = Outcome::found, .result = json_, .line = table()};
    for (const RoadblockDrive& drive : drives_) {
      const Outcome outcome = outcome_of(drive.drive.outcome);
      if (exit_code(outcome) <= exit_code(answer.outcome)) continue;
      answer.outcome = outcome;
      answer.reason = fmt::format("sample {}: {}", drive.sample.number, name(drive.drive.outcome));
    }
    return answer;
  }

 private:
  const roadblocks::Course& course_;
  RoadblockDriver driver_;
  bool all_;
  std::vector<RoadblockDrive> drives_;
  Json json_ = Json::array();
};

int drive_on_map(const DriveOptions& options, std::string_view bytes, const std::string& source, Run& run) {
  const roadblocks::RoadMap map = run.stage("read", [&] {
    require_road_map(bytes, source);
    roadblocks::RoadMap read = read_road_map(bytes, source);
    roadblocks::require_start_free(read.course, options.walls, source);
    return read;
  });
  roadblocks::LatticePlanner planner(map.course, options.walls);
  Logbook logbook(options, map.course);
  Keeping keeping;
  for (const roadblocks::Sample& sample : chosen_samples(options, map, source)) {
    logbook.add(run.stage("drive", [&] { return driven(sample, map.course, planner, options, run); }));
    keeping.tell([&] { run.so_far(logbook.json(), logbook.table()); });
  }
  Answer answer = logbook.answer();
  const DriveOutput& output = options.output;
  if (!output.svg.empty())
    answer.files.push_back({output.svg, picture_of(logbook.last(), map.course, options, source, false)});
  if (!output.animation.empty())
    answer.files.push_back({output.animation, picture_of(logbook.last(), map.course, options, source, true)});
  return run.end(std::move(answer));
}

int run(const DriveOptions& options, Run& run) {
  run.promise(options.output.svg);
  run.promise(options.output.animation);
  run.source(options.file);
  const std::string source = options.file == "-" ? "<stdin>" : options.file;
  const std::string bytes = run.stage("read", [&] { return read_bytes(options.file); });
  return options.world.car ? drive_in_world(options.world, options.output, bytes, source, run)
                           : drive_on_map(options, bytes, source, run);
}

}  // namespace

Command drive_command(CommandLine& app) {
  return command<DriveOptions>(app, "drive", "Drive a car through a maze with roadblocks that show only from near",
                               add_options, run);
}

}  // namespace taut::cli
