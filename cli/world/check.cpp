// taut check: is the input valid, what is in it, and is a given path one that can be followed?
#include <fmt/format.h>

#include <cmath>

#include <taut/cli/command.h>
#include <taut/cli/command_line.h>
#include <taut/cli/input.h>
#include <taut/cli/messages.h>
#include <taut/cli/run.h>
#include <taut/cli/world/check_report.h>
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
  app.add_option("--path", options.path,
                 "Check this path as well: the JSON of `taut solve`, or a point `x y` a line; - is standard input")
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
  const Gates gates{FreeSpace(world)};
  const ArcVerdict arcs =
      verify_arcs(path, gates, world.start().value_or(path.start), world.goal().point.value_or(path.goal));
  Verdict verdict;
  verdict.valid = arcs.valid;
  verdict.reason = arcs.reason;
  verdict.clearance = path.radius;
  return verdict;
}

// An end that neither FILE nor an option names is where the path begins or ends.
Verdict judge(const ClaimedPath& claimed, const FreeSpace& space) {
  const World& world = space.world();
  if (claimed.arcs) return judge_arcs(claimed, world);
  const Path path{claimed.points, Length(claimed.points)};
  if (path.points.empty()) return {false, "the path has no points", 0, 0, kNone};
  Goal goal = world.goal();
  if (!goal.point && goal.room.empty()) goal.point = path.points.back();
  Verdict verdict = verify(path, space, world.start().value_or(path.points.front()), goal);
  const Interval measured = path.length.interval();
  const double slack = 1e-12 * measured.hi;  // the claim is a rounded number
  if (verdict.valid && claimed.length &&
      !(measured.lo - slack <= *claimed.length && (claimed.approximate || *claimed.length <= measured.hi + slack))) {
    verdict.valid = false;
    verdict.reason = fmt::format("it claims the length {}, but measures {}", *claimed.length, length_text(path.length));
  }
  return verdict;
}

// A path of longitude and latitude in metres, where its ends are on the walls that they are on in degrees.
void project(ClaimedPath& claimed, Input& input, const Snap& snap) {
  const GeographicWorld& geographic = *input.notes.geographic;
  if (claimed.arcs) throw InputError({}, 0, "a path of arcs cannot be checked with --project");
  std::vector<Point> ends;
  if (!claimed.points.empty()) ends = {claimed.points.front(), claimed.points.back()};
  for (Point& p : claimed.points) {
    geographic.require_end(p, "the path's point");
    p = geographic.metres(p);
  }
  // What was printed of the points is rounded.
  const double measured = Length(claimed.points).value();
  if (claimed.length && std::abs(*claimed.length - measured) <= 4e-7 * static_cast<double>(claimed.points.size()))
    claimed.length.reset();
  const std::optional<Point> start = input.world.start(), goal = input.world.goal().point;
  input.world = snapped_world(geographic.in_metres(ends), snap).world.with_ends(start, goal);
}

void require_free_ends(const FreeSpace& space, const Shown& shown) {
  const World& world = space.world();
  if (world.start()) require_free(space, *world.start(), "start", shown);
  if (world.goal().point) require_free(space, *world.goal().point, "goal", shown);
}

int run(const CheckOptions& options, Run& run) {
  run.source(options.world.file);
  Input input = read_input(options.world, options.query, run);
  std::optional<ClaimedPath> claimed;
  if (!options.path.empty())
    claimed = read_path(read_bytes(options.path), options.path == "-" ? "<stdin>" : options.path);
  if (claimed && input.notes.geographic) project(*claimed, input, options.world.read.snap);
  const FreeSpace space = run.stage("space", [&] {
    // What a path that is to be judged lies on must not have bent away from it.
    return FreeSpace(input.world, options.query.robot,
                     claimed ? std::span<const Point>(claimed->points) : std::span<const Point>());
  });
  require_free_ends(space, Shown(input.notes));
  CheckReport report(input, space);
  run.so_far(report.json(), report.text());
  if (claimed) run.stage("verify", [&] { report.add_path(*claimed, judge(*claimed, space)); });
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
