#include <taut/cli/bug/journey.h>

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include <taut/cli/input.h>
#include <taut/cli/messages.h>
#include <taut/cli/world/snap_ends.h>
#include <taut/geometry/errors.h>
#include <taut/io/results/bug_json.h>
#include <taut/search/no_path.h>
#include <taut/search/polyanya.h>
#include <taut/search/verify.h>
#include <taut/search/voronoi_search.h>

namespace taut::cli {

using bug::Algorithm;
using bug::Journey;

namespace {

Point goal_of(const FreeSpace& space, const Input& input) {
  const std::vector<Point> goals = goal_points(space, input.world.goal());
  if (goals.empty()) throw InputError(input.name, 0, "the middles of its goal room are no free places; give --to X,Y");
  return goals.front();
}

std::optional<Length> shortest_length(const FreeSpace& space, Point from, Point to) {
  const GraphSearchResult result = shortest_path(Polyanya(space), from, {to, {}});
  return result.status == SearchStatus::found ? std::optional(result.path.length) : std::nullopt;
}

void check(const BugWorld& world, const Journey& journey) {
  const Point end = journey.reached ? world.goal : journey.path.points.back();
  const Verdict verdict = verify(journey.path, world.space, world.start, {end, {}});
  if (!verdict.valid) throw std::logic_error("the path walked does not pass its own check: " + verdict.reason);
  if (journey.path.length.interval().lo > journey.bound.hi + journey.rounding * 1.001)
    throw std::logic_error("the path walked is longer than its bound");
  if (journey.reached != world.shortest.has_value())
    throw std::logic_error(journey.reached ? "the goal was reached, though there is no path"
                                           : "there is a path, though the goal was not reached");
}

}  // namespace

BugWorld read_bug_world(const WorldOptions& world, const QueryOptions& query, Run& run) {
  const Input input = read_input(world, query, run);
  require_ends(input);
  const FreeSpace space = run.stage("space", [&] { return triangulated(FreeSpace(input.world, query.robot)); });
  const Point start = *input.world.start(), goal = goal_of(space, input);
  return run.stage("shortest", [&]() -> BugWorld {
    const std::optional<Length> shortest = shortest_length(space, start, goal);
    const bool is_shut = !shortest && NoPath(space).walls(start, {goal, {}}).has_value();
    return {input.name, space, start, goal, shortest, is_shut, input.moves};
  });
}

Journey checked_journey(const BugWorld& world, const bug::Options& options, Run& run) {
  Journey journey = run.stage("search", [&] { return bug::travel(world.space, world.start, world.goal, options); });
  run.stage("verify", [&] { check(world, journey); });
  return journey;
}

Outcome outcome_of(const BugWorld& world) {
  return world.shortest ? Outcome::found : world.is_shut ? Outcome::none : Outcome::unproven;
}

std::string reason_of(const BugWorld& world) {
  if (world.shortest) return "";
  return world.is_shut ? "walls separate start and goal" : "the goal was not reached, which proves nothing";
}

double bug_range_of(const std::string& text) {
  if (text == "inf") return std::numeric_limits<double>::infinity();
  const double range = number_of(text, "--range");
  if (range < 0) throw UsageError("--range: '" + text + "' is not a range of 0 or more, or inf");
  return range;
}

std::string range_text(double range) { return std::isinf(range) ? "inf" : number_text(range); }

void add_turn_option(CommandLine& app, bug::Options& options) {
  app.add_option_function(
         "--turn",
         [&options](const std::string& text) {
           if (text != "left" && text != "right") throw UsageError("'" + text + "' is not left or right");
           options.turn = text == "left" ? bug::Turn::left : bug::Turn::right;
         },
         "Where to turn at an obstacle (tangent: when both sides promise the same): left (default) or right")
      .type_name("SIDE")
      .group("Query");
}

void explain_bugs(CommandLine& app) {
  app.explain("Algorithms",
              {{"bug1", "by touch: around the whole contour, then back to its place nearest the goal"},
               {"bug2", "by touch: along the contour until it is on the straight line again"},
               {"tangent", "by sight: around what it sees in its way, by the corner that promises most"}});
}

std::vector<std::string> bug_facts(const BugWorld& world, const bug::Options& options, const Journey& journey,
                                   bool all) {
  const bool is_tangent = options.algorithm == Algorithm::tangent;
  std::vector<std::string> facts{options.algorithm == Algorithm::bug1   ? "bug 1"
                                 : options.algorithm == Algorithm::bug2 ? "bug 2"
                                                                        : "tangent bug"};
  if (is_tangent) facts.push_back("range " + range_text(options.range));
  const std::string length = length_text(journey.path.length);
  facts.push_back(journey.reached ? "length " + length
                  : world.is_shut ? "no path, proven after a walk of " + length
                                  : "not reached after a walk of " + length + ", which proves nothing");
  if (const auto ratio = ratio_of(journey, world.shortest))
    facts.push_back(fmt::format("{:.3f} times the shortest {}", *ratio, length_text(*world.shortest)));
  facts.push_back(fmt::format("bound {:.6f}", journey.bound.hi));
  if (!all) return facts;
  facts.push_back(count_text(journey.hits.size(), "hit point"));
  if (is_tangent) facts.push_back(count_text(journey.minima.size(), "contour followed", "contours followed"));
  facts.push_back(count_text(journey.leaves.size(), "leave point"));
  return facts;
}

}  // namespace taut::cli
