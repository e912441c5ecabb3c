// taut audit: anybody's plans, judged.
#include <taut/cli/solve/audit.h>

#include <taut/cli/command.h>
#include <taut/cli/command_line.h>
#include <taut/cli/drive/world.h>
#include <taut/geometry/errors.h>
#include <taut/io/worlds/read_drive.h>
#include <taut/io/worlds/read_fleet.h>

namespace taut::cli {

namespace {

void add_options(CommandLine& app, AuditOptions& options) {
  add_world_options(app, options.world);
  app.add_option("PLANS", options.plans,
                 "Paths: CSV, JSON, GeoJSON, WKT, poses of ROS, what OMPL prints; a drive of `taut drive --car`; or "
                 "robots with times, `id t x y` a line; - is standard input")
      .required();
  add_robot_option(app, options.robot);
  app.add_option_function(
         "--car", [&options](const std::string& text) { options.car = car_shape_of(text); },
         "The car of a drive, where the file does not say: length=L,width=W,radius=R,rear=B,reverse=no")
      .type_name("CAR")
      .group("Query");
  app.add_flag("--ends", options.ends, "Paths have to lead from the world's start to its goal").group("Query");
  app.add_flag("--no-gap", options.no_gap, "Do not look for the shortest path to compare with").group("Query");
  app.add_flag("--prove", options.prove,
               "Let the judge of certificates confirm that no path is shorter, too (point and square)")
      .group("Query");
  app.add_flag("--vanish", options.vanish,
               "Robots are nowhere before their first and after their last time (default: they stand there)")
      .group("Query");
  add_svg_option(app, options.svg, "Write a picture: where it goes wrong");
  app.callback([&options] {
    if (options.plans == "-" && options.world.file == "-")
      throw UsageError("FILE and PLANS cannot both be standard input");
    if (options.prove && options.robot.kind() == Footprint::Kind::disc)
      throw UsageError("--prove is for a point or a square, not for a disc");
    if (options.prove && options.no_gap) throw UsageError("--prove makes no sense with --no-gap");
    require_one_stdout({{"--svg", options.svg}, {"--json", options.common.json}});
  });
  app.example("taut audit maze.txt paths.csv --svg faults.svg");
  app.example("taut audit hall.geojson robots.txt --robot disc:0.3");
}

int run(const AuditOptions& options, Run& run) {
  run.source(options.world.file);
  run.promise(options.svg);
  const Input input = read_input(options.world, run);
  const std::string name = options.plans == "-" ? "<stdin>" : options.plans;
  const std::string bytes = read_bytes(options.plans);
  if (holds_drive(bytes)) return audit_drive(options, input, bytes, name, run);
  if (options.car) throw InputError(name, 0, "holds no drive of a car: there are no \"legs\" with \"headings\"");
  if (holds_fleet(bytes)) return audit_fleet(options, input, bytes, name, run);
  return audit_paths(options, input, bytes, name, run);
}

}  // namespace

Json wall_json(const NearObstacle& wall) {
  if (wall.kind == NearObstacle::Kind::none) return nullptr;
  const char* const kind = wall.kind == NearObstacle::Kind::wall    ? "wall"
                           : wall.kind == NearObstacle::Kind::solid ? "obstacle"
                                                                    : "outline";
  return {
      {"from", wall.side.a}, {"to", wall.side.b}, {"line", wall.line > 0 ? Json(wall.line) : Json()}, {"kind", kind}};
}

Command audit_command(CommandLine& app) {
  return command<AuditOptions>(app, "audit", "Judge anybody's plans: valid, or where not; how near, how long",
                               add_options, run);
}

}  // namespace taut::cli
