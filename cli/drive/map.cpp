#include <taut/cli/drive/map.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

#include <taut/cli/drive/table.h>
#include <taut/cli/messages.h>
#include <taut/cli/progress.h>
#include <taut/cli/run.h>
#include <taut/geometry/errors.h>
#include <taut/geometry/parallel.h>
#include <taut/io/pictures/drive_svg.h>
#include <taut/io/pictures/svg_sheet.h>
#include <taut/io/worlds/roadblock_map.h>
#include <taut/robots/roadblocks/tree_planner.h>
#include <taut/robots/roadblocks/value_planner.h>
#include <taut/search/stopwatch.h>

namespace taut::cli {

namespace {

std::vector<roadblocks::Sample> chosen_samples(const DriveOptions& options, const roadblocks::RoadblockMap& map,
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

/// Trees draw anew for each sample.
std::uint64_t seed_of(const roadblocks::Sample& sample, const DriveOptions& options) {
  return options.common.seed + static_cast<std::uint64_t>(sample.number);
}

/// Takes the time of another driver's decisions.
class TimedDriver : public roadblocks::Driver {
 public:
  explicit TimedDriver(std::unique_ptr<roadblocks::Driver> driver) : driver_(std::move(driver)) {}

  std::optional<double> next(const roadblocks::ObservedMap& map, const roadblocks::Pose& pose) override {
    const Stopwatch watch(Stopwatch::Of::thread);
    const std::optional<double> control = driver_->next(map, pose);
    const double ms = 1000 * watch.seconds().cpu;
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

/// What a planner of trees grew in this drive; nothing of others.
std::vector<roadblocks::TreeBranch> trees_of(const RoadblockDrive& result, const roadblocks::Course& course,
                                             const DriveOptions& options) {
  constexpr std::pair<std::string_view, roadblocks::TreeKind> kKinds[] = {
      {"rrt", roadblocks::TreeKind::rrt},
      {"rrt-field", roadblocks::TreeKind::rrt_field},
      {"rrt-star", roadblocks::TreeKind::rrt_star},
      {"rrt-connect", roadblocks::TreeKind::rrt_connect}};
  for (const auto& [name, kind] : kKinds)
    if (options.peer && options.peer->name == name)
      return roadblocks::trees_of(course, options.walls, kind, seed_of(result.sample, options), result.drive);
  return {};
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
                       has_values ? &values : nullptr,
                       trees_of(result, course, options)};
  return drive_svg(course, result.drive, picture);
}

bool has_policy(const DriveOptions& options) {
  return !options.peer && options.planner == roadblocks::DriverKind::policy;
}

/// What the drives of one thread share.
struct Garage {
  Garage(const roadblocks::Course& course, const DriveOptions& options) : planner(course, options.walls) {
    if (has_policy(options)) policy.emplace(planner, options.aim);
  }
  roadblocks::LatticePlanner planner;
  std::optional<roadblocks::DrivePolicy> policy;
};

/// Trees draw anew for each sample; a sample drives the same alone and among all.
std::unique_ptr<roadblocks::Driver> driver_for(const roadblocks::Sample& sample, const roadblocks::Course& course,
                                               Garage& garage, const DriveOptions& options) {
  if (options.peer) return options.peer->make(course, options.walls, seed_of(sample, options));
  if (garage.policy) return roadblocks::make_driver(*garage.policy, garage.planner);
  return roadblocks::make_driver(options.planner, garage.planner, sample.open);
}

RoadblockDrive driven(const roadblocks::Sample& sample, const roadblocks::Course& course, Garage& garage,
                      const DriveOptions& options) {
  TimedDriver driver(driver_for(sample, course, garage, options));
  roadblocks::Drive drive = roadblocks::drive(course, sample.open, driver, options.walls);
  outcome_of(drive.outcome);
  const auto policy_exact = has_policy(options) ? std::optional(driver.exact()) : std::nullopt;
  return {sample, std::move(drive), driver.first(), driver.slowest_later(), policy_exact};
}

/// The drives so far, in three forms.
class Logbook {
 public:
  Logbook(const DriveOptions& options, const roadblocks::Course& course) : course_(course), options_(options) {}

  void add(RoadblockDrive drive) {
    samples_.push_back(roadblock_drive_json(drive, course_, options_.controls));
    drives_.push_back(std::move(drive));
  }
  Json json() const {
    return {{"planner", planner_name(options_)}, {"seed", options_.common.seed}, {"samples", samples_}};
  }
  std::string table() const { return drive_table(drives_, course_, options_.all); }
  const std::vector<RoadblockDrive>& drives() const { return drives_; }
  const RoadblockDrive& last() const { return drives_.back(); }

  /// The answer but for its pictures: what is least sure of all drives.
  Answer answer() const {
    Answer answer{.outcome = options_.all ? Outcome::done : Outcome::found, .result = json(), .line = table()};
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
  const DriveOptions& options_;
  std::vector<RoadblockDrive> drives_;
  Json samples_ = Json::array();
};

/// Side by side, where there are several.
std::string sheet_of(const Logbook& logbook, const roadblocks::Course& course, const DriveOptions& options,
                     const std::string& source) {
  std::vector<std::string> pictures;
  for (const RoadblockDrive& drive : logbook.drives())
    pictures.push_back(picture_of(drive, course, options, source, false));
  if (pictures.size() == 1) return pictures.front();
  return svg_sheet(pictures, static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(pictures.size())))));
}

/// What is driven, in the order of the samples, is kept.
void drive_all(const std::vector<roadblocks::Sample>& samples, const roadblocks::Course& course,
               const DriveOptions& options, Logbook& logbook, Run& run) {
  std::vector<RoadblockDrive> drives(samples.size());
  Keeping keeping;
  std::size_t noted = 0;
  const TellProgress show = shown_progress(options.common);
  ProgressCount done("drives", samples.size(), show);
  const auto note_until = [&](std::size_t over) {
    for (; noted < over; ++noted, done.add()) logbook.add(std::move(drives[noted]));
    keeping.tell([&] { run.so_far(logbook.json(), logbook.table()); });
  };
  each_in_parallel(samples.size(), {options.common.limits.jobs, {}, note_until}, [&] {
    auto garage = std::make_shared<Garage>(course, options);
    return [&, garage](std::size_t i) { drives[i] = driven(samples[i], course, *garage, options); };
  });
}

}  // namespace

std::string planner_name(const DriveOptions& options) {
  return std::string(options.peer ? options.peer->name : roadblocks::name(options.planner));
}

int drive_on_map(const DriveOptions& options, std::string_view bytes, const std::string& source, Run& run) {
  const roadblocks::RoadblockMap map = run.stage("read", [&] {
    require_roadblock_map(bytes, source);
    roadblocks::RoadblockMap read = read_roadblock_map(bytes, source);
    roadblocks::require_start_free(read.course, options.walls, source);
    return read;
  });
  Logbook logbook(options, map.course);
  run.stage("drive", [&] { drive_all(chosen_samples(options, map, source), map.course, options, logbook, run); });
  Answer answer = logbook.answer();
  const DriveOutput& output = options.output;
  if (!output.svg.empty())
    answer.files.push_back(
        {output.svg, run.stage("draw", [&] { return sheet_of(logbook, map.course, options, source); })});
  if (!output.animation.empty())
    answer.files.push_back({output.animation, picture_of(logbook.last(), map.course, options, source, true)});
  add_reports(answer, options.report, title_of(source), "outcome");
  return run.end(std::move(answer));
}

}  // namespace taut::cli
