#include <taut/cli/bug/run.h>
#include <taut/cli/command_line.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <taut/cli/input.h>
#include <taut/cli/report.h>
#include <taut/cli/timing.h>
#include <taut/geometry/errors.h>
#include <taut/io/pictures/svg.h>
#include <taut/io/results/detail/result_values.h>
#include <taut/search/no_path.h>
#include <taut/search/polyanya.h>
#include <taut/search/verify.h>
#include <taut/search/voronoi_search.h>

namespace taut::cli {

using bug::Algorithm;
using bug::Journey;

namespace {

constexpr double kAnimationSeconds = 20;

Point goal_of(const FreeSpace& space, const Input& input) {
  const std::vector<Point> goals = goal_points(space, input.world.goal());
  if (goals.empty()) throw InputError(input.name, 0, "the middles of its goal room are no free places; give --to X,Y");
  return goals.front();
}

std::optional<Length> shortest_length(const FreeSpace& space, Point from, Point to) {
  const GraphSearchResult result = shortest_path(Polyanya(space), from, {to, {}});
  return result.status == SearchStatus::found ? std::optional(result.path.length) : std::nullopt;
}

nlohmann::ordered_json json_of(const std::vector<bug::Contact>& contacts) {
  auto array = nlohmann::ordered_json::array();
  for (const bug::Contact& c : contacts)
    array.push_back({{"point", detail::json_of(c.at)}, {"distance", c.distance}, {"obstacle", c.obstacle}});
  return array;
}

/// H1, M1, ... those of one place in one label.
std::vector<SvgLabel> labels_of(const Journey& journey) {
  std::vector<SvgLabel> labels;
  const auto add = [&labels](const std::vector<bug::Contact>& contacts, char letter) {
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      const std::string text = fmt::format("{}{}", letter, i + 1);
      const auto same =
          std::find_if(labels.begin(), labels.end(), [&](const SvgLabel& l) { return l.at == contacts[i].at; });
      if (same == labels.end())
        labels.push_back({contacts[i].at, text});
      else
        same->text += " " + text;
    }
  };
  add(journey.hits, 'H');
  add(journey.minima, 'M');
  add(journey.leaves, 'L');
  return labels;
}

/// When the robot is at each point of its path, as a part of the whole.
std::vector<double> times_of(const Path& path) {
  std::vector<double> times{0};
  for (std::size_t i = 1; i < path.points.size(); ++i)
    times.push_back(times.back() +
                    std::hypot(path.points[i].x - path.points[i - 1].x, path.points[i].y - path.points[i - 1].y));
  if (times.back() > 0)
    for (double whole = times.back(); double& t : times) t /= whole;
  return times;
}

}  // namespace

BugWorld read_bug_world(const WorldOptions& world, const QueryOptions& query) {
  begin_stage("read");
  const Input input = read_input(world, query);
  require_ends(input);
  begin_stage("space");
  const FreeSpace space(input.world, query.robot);
  const Point start = *input.world.start(), goal = goal_of(space, input);
  begin_stage("shortest");
  const std::optional<Length> shortest = shortest_length(space, start, goal);
  const bool is_shut = !shortest && NoPath(space).walls(start, {goal, {}}).has_value();
  return {input.name, space, start, goal, shortest, is_shut};
}

Journey checked_journey(const BugWorld& world, const bug::Options& options) {
  begin_stage("search");
  Journey journey = bug::travel(world.space, world.start, world.goal, options);
  begin_stage("verify");
  const Point end = journey.reached ? world.goal : journey.path.points.back();
  const Verdict verdict = verify(journey.path, world.space, world.start, {end, {}});
  if (!verdict.valid) throw std::logic_error("the path walked does not pass its own check: " + verdict.reason);
  if (journey.path.length.interval().lo > journey.bound.hi + journey.rounding * 1.001)
    throw std::logic_error("the path walked is longer than its bound");
  if (journey.reached != world.shortest.has_value())
    throw std::logic_error(journey.reached ? "the goal was reached, though there is no path"
                                           : "there is a path, though the goal was not reached");
  return journey;
}

std::string name_of(Algorithm algorithm) {
  return algorithm == Algorithm::bug1 ? "bug1" : algorithm == Algorithm::bug2 ? "bug2" : "tangent";
}

Algorithm bug_algorithm_of(const std::string& text) {
  if (text == "1" || text == "bug1") return Algorithm::bug1;
  if (text == "2" || text == "bug2") return Algorithm::bug2;
  if (text == "tangent") return Algorithm::tangent;
  throw UsageError("--algorithm: '" + text + "' is not bug1, bug2 or tangent");
}

double bug_range_of(const std::string& text) {
  if (text == "inf") return std::numeric_limits<double>::infinity();
  const double range = number_of(text, "--range");
  if (range < 0) throw UsageError("--range: '" + text + "' is not a range of 0 or more, or inf");
  return range;
}

bug::Turn bug_turn_of(const std::string& text) {
  if (text != "left" && text != "right") throw UsageError("--turn: '" + text + "' is not left or right");
  return text == "left" ? bug::Turn::left : bug::Turn::right;
}

std::string range_text(double range) { return std::isinf(range) ? "inf" : number_text(range); }

std::optional<double> ratio_of(const BugWorld& world, const Journey& journey) {
  if (!journey.reached || world.shortest->value() == 0) return std::nullopt;
  return journey.path.length.value() / world.shortest->value();
}

std::vector<std::string> bug_facts(const BugWorld& world, const bug::Options& options, const Journey& journey) {
  const bool is_tangent = options.algorithm == Algorithm::tangent;
  std::vector<std::string> facts{is_tangent ? "tangent bug" : "bug " + name_of(options.algorithm).substr(3)};
  if (is_tangent) facts.push_back("range " + range_text(options.range));
  const std::string length = length_text(journey.path.length);
  facts.push_back(journey.reached ? "length " + length
                  : world.is_shut ? "no path, proven after a walk of " + length
                                  : "not reached after a walk of " + length + ", which proves nothing");
  if (const auto ratio = ratio_of(world, journey))
    facts.push_back(fmt::format("{:.3f} times the shortest {}", *ratio, length_text(*world.shortest)));
  facts.push_back(fmt::format("bound {:.6f}", journey.bound.hi));
  facts.push_back(count_text(journey.hits.size(), "hit point"));
  if (is_tangent) facts.push_back(count_text(journey.minima.size(), "contour followed", "contours followed"));
  facts.push_back(count_text(journey.leaves.size(), "leave point"));
  return facts;
}

std::string bug_svg(const BugWorld& world, const bug::Options& options, const Journey& journey, bool animated) {
  SvgPicture picture;
  picture.title = title_of(world.name);
  // The labels show the contacts.
  picture.facts = bug_facts(world, options, journey);
  picture.facts.erase(std::find_if(picture.facts.begin(), picture.facts.end(),
                                   [](const std::string& f) { return f.starts_with("bound"); }) +
                          1,
                      picture.facts.end());
  picture.path = &journey.path;
  picture.start = world.start;
  picture.goal.point = world.goal;
  if (options.algorithm != Algorithm::tangent) picture.guides = {{world.start, world.goal}};
  picture.seconds = animated ? kAnimationSeconds : 0;
  picture.labels = labels_of(journey);
  const std::vector<double> times = times_of(journey.path);
  for (const bug::View& view : journey.views) picture.views.push_back({view.ring, times[view.point]});
  return svg(world.space, picture);
}

std::string bug_json(const BugWorld& world, const bug::Options& options, const Journey& journey) {
  const bool is_tangent = options.algorithm == Algorithm::tangent;
  nlohmann::ordered_json json{{"program", "taut"},
                              {"version", TAUT_VERSION},
                              {"source", world.name},
                              {"status", journey.reached ? "found"
                                         : world.is_shut ? "none"
                                                         : "stopped"},
                              {"algorithm", name_of(options.algorithm)},
                              {"turn", options.turn == bug::Turn::left ? "left" : "right"}};
  if (is_tangent && std::isinf(options.range)) json["range"] = "inf";
  if (is_tangent && !std::isinf(options.range)) json["range"] = options.range;
  json["start"] = detail::json_of(world.start);
  json["goal"] = {{"point", detail::json_of(world.goal)}};
  json["length"] = journey.path.length.value();
  if (world.shortest) json["shortest"] = world.shortest->value();
  if (const auto ratio = ratio_of(world, journey)) json["ratio"] = *ratio;
  json["bound"] = journey.bound.hi;
  json["rounding"] = journey.rounding;
  json["hits"] = json_of(journey.hits);
  if (is_tangent) json["minima"] = json_of(journey.minima);
  json["leaves"] = json_of(journey.leaves);
  json["obstacles"] = nlohmann::ordered_json::array();
  for (const bug::Obstacle& o : journey.obstacles) {
    nlohmann::ordered_json obstacle{{"perimeter", o.perimeter.hi}, {"hits", o.hits}};
    if (options.algorithm == Algorithm::bug2) obstacle["entries"] = o.entries;
    if (is_tangent) obstacle["legs"] = o.legs;
    json["obstacles"].push_back(obstacle);
  }
  json["path"] = detail::json_of(journey.path.points);
  return detail::json_text(json);
}

}  // namespace taut::cli
