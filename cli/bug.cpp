// taut bug: a robot that only feels its way, by Bug 1 or Bug 2, with the theoretical bound beside its length.
#include <fmt/format.h>
#include <CLI/Error.hpp>
#include <nlohmann/json.hpp>

#include <stdexcept>

#include <taut/cli/command.h>
#include <taut/cli/exit_code.h>
#include <taut/cli/input.h>
#include <taut/cli/output.h>
#include <taut/cli/report.h>
#include <taut/cli/timing.h>
#include <taut/io/detail/result_values.h>
#include <taut/io/svg.h>
#include <taut/robots/bug/bug.h>
#include <taut/search/verify.h>
#include <taut/search/voronoi_search.h>

namespace taut::cli {

namespace {

constexpr double kAnimationSeconds = 20;

struct BugOptions {
  WorldOptions world;
  QueryOptions query;
  OutputOptions output;
  CommonOptions common;
  bug::Options bug;
  std::string animation;
};

void add_options(CLI::App& app, BugOptions& options) {
  add_world_options(app, options.world);
  add_query_options(app, options.query);
  app.add_option_function<std::string>(
         "--algorithm",
         [&options](const std::string& text) {
           if (text != "1" && text != "2") throw CLI::ValidationError("--algorithm: '" + text + "' is not 1 or 2");
           options.bug.algorithm = text == "1" ? bug::Algorithm::bug1 : bug::Algorithm::bug2;
         },
         "1 or 2 (default)")
      ->type_name("NAME")
      ->group("Query");
  app.add_option_function<std::string>(
         "--turn",
         [&options](const std::string& text) {
           if (text != "left" && text != "right")
             throw CLI::ValidationError("--turn: '" + text + "' is not left or right");
           options.bug.turn = text == "left" ? bug::Turn::left : bug::Turn::right;
         },
         "Where to turn at an obstacle: left (default) or right")
      ->type_name("SIDE")
      ->group("Query");
  add_output_options(app, options.output);
  app.add_option("--animate", options.animation, "Write a picture in which the robot moves")
      ->type_name("FILE")
      ->group("Output");
  app.callback([&options] {
    if ((options.output.svg == "-") + (options.output.json == "-") + (options.animation == "-") > 1)
      throw CLI::ValidationError("only one of --svg, --animate and --json can have standard output");
  });
}

class BugRun {
 public:
  explicit BugRun(const BugOptions& options) : options_(options) {}

  int run() {
    require_writable(options_.output.svg);
    require_writable(options_.output.json);
    require_writable(options_.animation);
    begin_stage("read");
    const Input input = read_input(options_.world, options_.query);
    require_ends(input);
    begin_stage("space");
    const FreeSpace space(input.world, options_.query.robot);
    start_ = *input.world.start();
    goal_ = goal_of(space, input);
    begin_stage("search");
    journey_ = bug::travel(space, start_, goal_, options_.bug);
    begin_stage("verify");
    check(space);
    begin_stage("write");
    const std::string picture = options_.output.svg.empty() ? "" : drawing(space, input.name, 0);
    const std::string animation = options_.animation.empty() ? "" : drawing(space, input.name, kAnimationSeconds);
    const std::string json = options_.output.json.empty() ? "" : json_text(input.name);
    finish();
    write_file(options_.output.svg, picture);
    write_file(options_.animation, animation);
    write_file(options_.output.json, json);
    if (!options_.output.quiet && !options_.output.stdout_taken() && options_.animation != "-")
      print(fmt::format("{}: {}, {}\n", input.name, fmt::join(facts(), ", "), seconds_text(total_.seconds())));
    return journey_.reached ? kFound : kNone;
  }

 private:
  /// Of a goal room, the middle of its first box that is free.
  static Point goal_of(const FreeSpace& space, const Input& input) {
    const std::vector<Point> goals = goal_points(space, input.world.goal());
    if (goals.empty())
      throw InputError(input.name, 0, "the middles of its goal room are no free places; give --to X,Y");
    return goals.front();
  }

  void check(const FreeSpace& space) const {
    const Point end = journey_.path.points.back();
    const Verdict verdict = verify(journey_.path, space, start_, {journey_.reached ? goal_ : end, {}});
    if (!verdict.valid) throw std::logic_error("the path walked does not pass its own check: " + verdict.reason);
    if (journey_.path.length.interval().lo > journey_.bound.hi + journey_.rounding * 1.001)
      throw std::logic_error("the path walked is longer than its bound");
  }

  std::string algorithm() const { return options_.bug.algorithm == bug::Algorithm::bug1 ? "1" : "2"; }

  std::vector<std::string> facts() const {
    const std::string length = journey_.path.length.decimals(6);
    return {"bug " + algorithm(), journey_.reached ? "length " + length : "no path, proven after a walk of " + length,
            fmt::format("bound {:.6f}", journey_.bound.hi), count_text(journey_.hits.size(), "hit point"),
            count_text(journey_.leaves.size(), "leave point")};
  }

  std::string drawing(const FreeSpace& space, const std::string& source, double seconds) const {
    SvgPicture picture;
    picture.title = title_of(source);
    picture.facts = facts();
    picture.path = &journey_.path;
    picture.start = start_;
    picture.goal.point = goal_;
    picture.guides = {{start_, goal_}};
    picture.seconds = seconds;
    const auto add = [&picture](const std::vector<bug::Contact>& contacts, char letter) {
      for (std::size_t i = 0; i < contacts.size(); ++i)
        picture.labels.push_back({contacts[i].at, fmt::format("{}{}", letter, i + 1)});
    };
    add(journey_.hits, 'H');
    add(journey_.leaves, 'L');
    return svg(space, picture);
  }

  static nlohmann::ordered_json json_of(const std::vector<bug::Contact>& contacts) {
    auto array = nlohmann::ordered_json::array();
    for (const bug::Contact& c : contacts)
      array.push_back({{"point", detail::json_of(c.at)}, {"distance", c.distance}, {"obstacle", c.obstacle}});
    return array;
  }

  std::string json_text(const std::string& source) const {
    nlohmann::ordered_json json{{"program", "taut"},
                                {"version", TAUT_VERSION},
                                {"source", source},
                                {"status", journey_.reached ? "found" : "none"},
                                {"algorithm", algorithm()},
                                {"turn", options_.bug.turn == bug::Turn::left ? "left" : "right"},
                                {"start", detail::json_of(start_)},
                                {"goal", {{"point", detail::json_of(goal_)}}},
                                {"length", journey_.path.length.value()},
                                {"bound", journey_.bound.hi},
                                {"rounding", journey_.rounding},
                                {"hits", json_of(journey_.hits)},
                                {"leaves", json_of(journey_.leaves)}};
    json["obstacles"] = nlohmann::ordered_json::array();
    for (const bug::Obstacle& o : journey_.obstacles) {
      nlohmann::ordered_json obstacle{{"perimeter", o.perimeter.hi}, {"hits", o.hits}};
      if (options_.bug.algorithm == bug::Algorithm::bug2) obstacle["entries"] = o.entries;
      json["obstacles"].push_back(obstacle);
    }
    json["path"] = detail::json_of(journey_.path.points);
    return detail::json_text(json);
  }

  const BugOptions& options_;
  Point start_, goal_;
  bug::Journey journey_;
  Stopwatch total_;
};

int run(const BugOptions& options) { return BugRun(options).run(); }

}  // namespace

Command bug_command(CLI::App& app) {
  return command<BugOptions>(
      app, "bug", "Feel the way to the goal by touch alone (Bug 1, Bug 2), with its length bound", add_options, run);
}

}  // namespace taut::cli
