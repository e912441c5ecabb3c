// taut drive: a car through a maze whose roadblocks show only from near; with --car, any car in any world.
#include <fmt/format.h>
#include <CLI/Error.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include <taut/cli/command.h>
#include <taut/cli/drive_svg.h>
#include <taut/cli/drive_world.h>
#include <taut/cli/exit_code.h>
#include <taut/cli/output.h>
#include <taut/cli/report.h>
#include <taut/cli/timing.h>
#include <taut/geometry/errors.h>
#include <taut/io/read_world.h>
#include <taut/robots/car/drivers.h>

namespace taut::cli {

namespace {

struct DriveOptions {
  std::string file;
  std::optional<int> sample;
  bool all = false;
  std::string bits;
  car::DriverKind planner = car::DriverKind::ours;
  car::WallReading walls = car::WallReading::points;
  std::string svg, json;
  bool animate = false;
  bool controls = false;
  bool quiet = false;
  WorldDriveOptions world;
  CommonOptions common;
};

car::DriverKind planner_of(const std::string& word) {
  if (const auto kind = car::driver_named(word)) return *kind;
  throw CLI::ValidationError("--planner: '" + word + "' is not ours, optimist, pessimist or clairvoyant");
}

car::WallReading walls_of(const std::string& word) {
  if (word == "points") return car::WallReading::points;
  if (word == "squares") return car::WallReading::squares;
  throw CLI::ValidationError("--walls: '" + word + "' is not points or squares");
}

void require_consistent(const DriveOptions& options) {
  if (options.sample.has_value() + options.all + !options.bits.empty() > 1)
    throw CLI::ValidationError("only one of --sample, --all and --open");
  if (options.svg == "-" && options.json == "-")
    throw CLI::ValidationError("only one of --svg and --json can have standard output");
  if (options.world.car && (options.sample || options.all || !options.bits.empty() || options.controls))
    throw CLI::ValidationError("--car drives in a world of walls: not with --sample, --all, --open or --controls");
  if (!options.world.car && !options.world.first().empty())
    throw CLI::ValidationError(options.world.first() + " needs --car: a roadblock map says where its own car starts");
  if (!options.svg.empty() && options.all) throw CLI::ValidationError("--svg draws one drive: give --sample I");
  if (options.animate && options.svg.empty()) throw CLI::ValidationError("--animate needs --svg");
}

void add_options(CLI::App& app, DriveOptions& options) {
  add_world_drive_options(app, options.world);
  app.add_option("--sample", options.sample, "Drive this sample of the file (default: its first)")->type_name("I");
  app.add_flag("--all", options.all, "Drive all samples of the file");
  app.add_option("--open", options.bits, "Drive with these roadblocks open, as 101 for A and C")->type_name("BITS");
  app.add_option_function<std::string>(
         "--planner", [&options](const std::string& word) { options.planner = planner_of(word); },
         "ours (default), optimist, pessimist, clairvoyant (knows the sample: a bound)")
      ->type_name("NAME");
  app.add_option_function<std::string>(
         "--walls", [&options](const std::string& word) { options.walls = walls_of(word); },
         "points (default, the course's rule): a wall is its cell's centre, tested at the end of a step; squares: "
         "whole cells, the whole step")
      ->type_name("NAME");
  app.add_option("--svg", options.svg, "Draw the drive; - is standard output")->type_name("FILE")->group("Output");
  app.add_flag("--animate", options.animate, "Let the car drive in the picture")->group("Output");
  app.add_option("--json", options.json, "An array of results, one a sample; - is standard output")
      ->type_name("FILE")
      ->group("Output");
  app.add_flag("--controls", options.controls, "Put each drive's controls into the JSON")->group("Output");
  app.add_flag("-q,--quiet", options.quiet, "Print no table")->group("Output");
  app.callback([&options] {
    options.file = options.world.world.file;
    require_consistent(options);
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

struct Result {
  car::Sample sample;
  car::Drive drive;
};

nlohmann::ordered_json json_of(const Result& result, const car::Course& course, bool controls) {
  nlohmann::ordered_json json{{"sample", result.sample.number},
                              {"open", car::bits_of(result.sample.open, course)},
                              {"reached", result.drive.outcome == car::Outcome::reached},
                              {"outcome", car::name(result.drive.outcome)},
                              {"steps", result.drive.controls.size()},
                              {"collisions", result.drive.outcome == car::Outcome::collision ? 1 : 0},
                              {"replans", result.drive.replans}};
  if (controls) json["controls"] = result.drive.controls;
  return json;
}

std::string row(const Result& result, const car::Course& course) {
  return fmt::format("{:>6}  {:<{}}  {:<9}  {:>6}  {:>7}\n", result.sample.number,
                     car::bits_of(result.sample.open, course), std::max<std::size_t>(course.roadblocks.size(), 4),
                     car::name(result.drive.outcome), result.drive.controls.size(), result.drive.replans);
}

// A collision is a defect of the driver: it never enters what it does not know to be free.
ExitCode code_of(car::Outcome outcome) {
  switch (outcome) {
    case car::Outcome::reached: return kFound;
    case car::Outcome::no_route: return kNone;
    case car::Outcome::limit: return kStopped;
    case car::Outcome::collision: break;
  }
  return kInternal;
}

int run(const DriveOptions& options) {
  require_writable(options.svg);
  require_writable(options.json);
  begin_stage("read");
  const std::string name = options.file == "-" ? "<stdin>" : options.file;
  const std::string bytes = read_bytes(options.file);
  if (options.world.car)
    return drive_in_world(options.world, bytes, name, {options.svg, options.json, options.animate, options.quiet});
  require_road_map(bytes, name);
  const car::RoadMap map = car::read_road_map(bytes, name);
  car::require_start_free(map.course, options.walls, name);
  begin_stage("drive");
  car::LatticePlanner planner(map.course, options.walls);
  auto results = nlohmann::ordered_json::array();
  std::string table =
      fmt::format("{:>6}  {:<{}}  {:<9}  {:>6}  {:>7}\n", "sample", "open",
                  std::max<std::size_t>(map.course.roadblocks.size(), 4), "outcome", "steps", "replans");
  std::string picture;
  int code = kFound;
  for (const car::Sample& sample : chosen_samples(options, map, name)) {
    const auto driver = car::make_driver(options.planner, planner, sample.open);
    const Result result{sample, car::drive(map.course, sample.open, *driver, options.walls)};
    code = std::max<int>(code, code_of(result.drive.outcome));
    results.push_back(json_of(result, map.course, options.controls));
    table += row(result, map.course);
    if (!options.svg.empty())
      picture =
          drive_svg(map.course, result.drive, options.walls, options.animate,
                    fmt::format("{}, sample {}: {}, {} steps, {} replans", title_of(name), sample.number,
                                car::name(result.drive.outcome), result.drive.controls.size(), result.drive.replans));
  }
  finish();
  write_file(options.svg, picture);
  write_file(options.json, results.dump(2) + "\n");
  if (!options.quiet && options.svg != "-" && options.json != "-") print(table);
  return code;
}

}  // namespace

Command drive_command(CLI::App& app) {
  return command<DriveOptions>(app, "drive", "Drive a car through a maze with roadblocks that show only from near",
                               add_options, run);
}

}  // namespace taut::cli
