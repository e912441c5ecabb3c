// taut drive: a car through a maze whose roadblocks show only from near; with --car, any car in any world.
#include <initializer_list>
#include <string>

#include <taut/cli/command.h>
#include <taut/cli/drive/map.h>
#include <taut/cli/jobs.h>
#include <taut/cli/run.h>
#include <taut/io/worlds/read_world.h>

namespace taut::cli {

namespace {

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
  const std::string for_maps = first_given(app, {"--sample", "--all", "--open", "--planner", "--policy", "--walls",
                                                 "--show-values", "--controls", "--html"});
  const std::string for_cars =
      first_given(app, {"--from", "--to", "--weight", "--wall-thickness", "--polygons", "--format", "--resolution",
                        "--snap", "--unknown-free", "--repair", "--geojson", "--wkt", "--poses", "--csv"});
  if (options.world.car && !for_maps.empty())
    throw UsageError("--car drives in a world of walls: not with " + for_maps);
  if (!options.world.car && for_cars == "--csv" && options.all) return;
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
  if (!options.report.html.empty() && !options.all) throw UsageError("--html compares the samples of --all");
  if (!options.output.animation.empty() && options.all) throw UsageError("--animate draws one drive: give --sample I");
  if (app.count("--jobs") > 0 && !options.all) throw UsageError("--jobs shares the samples of --all among threads");
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
  app.add_flag("--all", options.all, "Drive all samples of the file; --csv then has a row a drive");
  add_jobs_option(app, options.common.limits);
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
  app.add_option("--svg", options.output.svg, "Draw the drive, all of --all on one sheet; - is standard output")
      .type_name("FILE")
      .group("Output");
  add_html_option(app, options.report);
  add_path_file_options(app, options.output.files);
  add_animate_option(app, options.output.animation, "Draw the car as it drives, an SVG that plays in a browser");
  app.add_flag("--show-values", options.show_values,
               "Draw the surface and the arrows of value iteration; --planner value-iteration does")
      .group("Output");
  app.add_flag("--controls", options.controls, "Put each drive's controls into the JSON").group("Output");
  app.callback([&app, &options] {
    options.file = options.world.world.file;
    settle_animation(app, options.output.animation, options.output.svg, options.common.json);
    require_consistent(app, options);
    if (options.all) options.report.csv = std::exchange(options.output.files.csv, {});
  });
  add_explanations(app);
}

int run(const DriveOptions& options, Run& run) {
  run.promise(options.output.svg);
  run.promise(options.output.animation);
  promise_reports(options.report, run);
  promise(run, options.output.files);
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
