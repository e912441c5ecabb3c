// taut check: is the input valid, what is in it, and is a given path one that can be followed?
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <taut/cli/command.h>
#include <taut/cli/command_line.h>
#include <taut/cli/input.h>
#include <taut/cli/messages.h>
#include <taut/cli/run.h>
#include <taut/cli/world/check_report.h>
#include <taut/cli/world/claimed_length.h>
#include <taut/cli/world/geographic.h>
#include <taut/cli/world/snap_ends.h>
#include <taut/io/worlds/read_path.h>
#include <taut/search/verify.h>
#include <taut/search/verify_arcs.h>

namespace taut::cli {

namespace {

struct CheckOptions {
  WorldOptions world;
  QueryOptions query;
  CommonOptions common;
  std::string path;
};

void add_options(CommandLine& app, CheckOptions& options) {
  add_world_options(app, options.world);
  add_query_options(app, options.query);
  app.add_option(
         "--path", options.path,
         "Check these paths as well: the JSON of `taut solve`, GeoJSON, WKT, CSV, or a point `x y` a line; - is "
         "standard input")
      .type_name("FILE")
      .group("Query");
  app.callback([&options] {
    if (options.path == "-" && options.world.file == "-")
      throw UsageError("FILE and --path cannot both be standard input");
  });
}

// A disc's path of arcs: by its bends, against the walls of the world itself.
Verdict judge_arcs(const ClaimedPath& claimed, const World& world) {
  const ArcPath& path = *claimed.arcs;
  const std::vector<Box>& room = world.goal().room;
  if (!world.goal().point && !room.empty() &&
      std::ranges::none_of(room, [&](const Box& box) { return box.contains(path.goal); }))
    return {.reason = fmt::format("the path ends at {}, outside the goal room", point_text(path.goal))};
  const Gates gates{FreeSpace(world)};
  const ArcVerdict arcs =
      verify_arcs(path, gates, world.start().value_or(path.start), world.goal().point.value_or(path.goal));
  Verdict verdict;
  verdict.valid = arcs.valid;
  verdict.reason = arcs.reason;
  verdict.clearance = path.radius;
  return verdict;
}

// A disc's path of legs, by the disc itself and not the polygon around it; legs that stand for arcs come nearer to
// walls by what they say.
Verdict judge_legs(const ClaimedPath& claimed, const FreeSpace& space) {
  constexpr double kPrinted = 1e-6;  // of the tolerance: how far its digits and those of the points are off
  ArcPath path;
  path.radius = space.footprint().radius() - (1 + kPrinted) * claimed.tolerance;
  path.start = claimed.points.front();
  path.goal = claimed.points.back();
  for (const Point p : claimed.points)
    if (p != (path.bends.empty() ? path.start : path.bends.back().corner)) path.bends.push_back({p, 0});
  if (!path.bends.empty()) path.bends.pop_back();
  path.length = Length(claimed.points).interval();
  ClaimedPath legs;
  legs.arcs = std::move(path);
  Verdict verdict = judge_arcs(legs, space.world());
  verdict.clearance = space.footprint().radius() - claimed.tolerance;
  return verdict;
}

// An end that neither FILE nor an option names is where the path begins or ends.
Verdict judge(const ClaimedPath& claimed, const FreeSpace& space) {
  const World& world = space.world();
  if (claimed.arcs) return judge_arcs(claimed, world);
  const Path path{claimed.points, Length(claimed.points)};
  if (path.points.empty()) return {.reason = "the path has no points"};
  Goal goal = world.goal();
  if (!goal.point && goal.room.empty()) goal.point = path.points.back();
  Verdict verdict = verify(path, space, world.start().value_or(path.points.front()), goal);
  const Footprint& robot = space.footprint();
  if (!verdict.valid && robot.kind() == Footprint::Kind::disc && goal.point && claimed.tolerance < robot.radius() / 2)
    if (const Verdict legs = judge_legs(claimed, space); legs.valid) verdict = legs;
  if (verdict.valid) verdict.reason = false_claim(claimed, path.length);
  verdict.valid &= verdict.reason.empty();
  return verdict;
}

// A path of longitude and latitude in metres, where its ends are on the walls that they are on in degrees.
void project(std::vector<ClaimedPath>& paths, Input& input, const Snap& snap) {
  const GeographicWorld& geographic = *input.notes.geographic;
  std::vector<Point> ends;
  for (ClaimedPath& claimed : paths) {
    if (claimed.arcs) throw InputError({}, 0, "a path of arcs cannot be checked with --project");
    if (!claimed.points.empty()) ends.insert(ends.end(), {claimed.points.front(), claimed.points.back()});
    for (Point& p : claimed.points) {
      geographic.require_end(p, "the path's point");
      p = geographic.metres(p);
    }
    // What was printed of the points is rounded.
    const double measured = Length(claimed.points).value();
    if (claimed.length && std::abs(*claimed.length - measured) <= 4e-7 * static_cast<double>(claimed.points.size()))
      claimed.length.reset();
  }
  const std::optional<Point> start = input.world.start(), goal = input.world.goal().point;
  input.world = snapped_world(geographic.in_metres(ends), snap).world.with_ends(start, goal);
}

void require_free_ends(const FreeSpace& space, const Shown& shown) {
  const World& world = space.world();
  if (world.start()) require_free(space, *world.start(), "start", shown);
  if (world.goal().point) require_free(space, *world.goal().point, "goal", shown);
}

std::vector<Point> points_of(const std::vector<ClaimedPath>& paths) {
  std::vector<Point> points;
  for (const ClaimedPath& path : paths) points.insert(points.end(), path.points.begin(), path.points.end());
  return points;
}

int run(const CheckOptions& options, Run& run) {
  run.source(options.world.file);
  Input input = read_input(options.world, options.query, run);
  std::vector<ClaimedPath> paths;
  if (!options.path.empty())
    paths = read_paths(read_bytes(options.path), options.path == "-" ? "<stdin>" : options.path);
  if (input.notes.geographic) project(paths, input, options.world.read.snap);
  // What a path that is to be judged lies on must not have bent away from it.
  const FreeSpace space =
      run.stage("space", [&] { return triangulated(FreeSpace(input.world, options.query.robot, points_of(paths))); });
  require_free_ends(space, Shown(input.notes));
  CheckReport report(input, space);
  run.so_far(report.json(), report.text());
  for (const ClaimedPath& path : paths) run.stage("verify", [&] { report.add_path(path, judge(path, space)); });
  return run.end({.outcome = report.valid() ? Outcome::done : Outcome::invalid,
                  .reason = report.fault(),
                  .result = report.json(),
                  .line = report.text()});
}

}  // namespace

Command check_command(CommandLine& app) {
  return command<CheckOptions>(app, "check", "Say whether a world is valid and what is in it; check a path",
                               add_options, run);
}

}  // namespace taut::cli
