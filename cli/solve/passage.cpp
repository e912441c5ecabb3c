// taut passage: can a disc get from start to goal, and how large may it be? By the gates, without building a path.
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <optional>
#include <utility>

#include <taut/cli/command.h>
#include <taut/cli/command_line.h>
#include <taut/cli/exit_code.h>
#include <taut/cli/input.h>
#include <taut/cli/messages.h>
#include <taut/cli/output.h>
#include <taut/cli/report.h>
#include <taut/cli/solve/barrier.h>
#include <taut/cli/solve/clearance_report.h>
#include <taut/cli/timing.h>
#include <taut/io/pictures/svg.h>
#include <taut/io/results/detail/result_values.h>
#include <taut/search/no_path.h>
#include <taut/search/query_ends.h>
#include <taut/search/voronoi_search.h>

namespace taut::cli {

namespace {

struct PassageOptions {
  WorldOptions world;
  QueryOptions query;
  OutputOptions output;
  CommonOptions common;
};

void add_options(CommandLine& app, PassageOptions& options) {
  add_world_options(app, options.world);
  add_query_options(app, options.query);
  add_output_options(app, options.output);
  app.callback([&options] {
    if (options.query.robot.kind() == Footprint::Kind::polygon)
      throw UsageError("--robot: passages are for discs; `taut solve --robot square:R` knows squares");
    if (options.output.svg == "-" && options.output.json == "-")
      throw UsageError("only one of --svg and --json can have standard output");
  });
}

class Answerer {
 public:
  explicit Answerer(const PassageOptions& options) : options_(options) {}

  int run() {
    require_writable(options_.output.svg);
    require_writable(options_.output.json);
    const Input input = timed("read", seconds_.read, [&] { return read_input(options_.world, options_.query); });
    require_ends(input);
    const FreeSpace space = timed("space", seconds_.space, [&] { return FreeSpace(input.world); });
    read_ends(space, input);
    gates_.emplace(timed("gates", seconds_.roadmap, [&] { return Gates(space); }));
    timed("search", seconds_.search, [&] { return ask(); });
    seconds_.total = total_.seconds();
    begin_stage("write");
    const std::string picture = options_.output.svg.empty() ? "" : drawing(space, input.name);
    const std::string json = options_.output.json.empty() ? "" : json_text(input.name);
    finish();
    write_file(options_.output.svg, picture);
    write_file(options_.output.json, json);
    if (!options_.output.quiet && !options_.output.stdout_taken()) print(input.name + ": " + line() + "\n");
    if (options_.output.stats)
      note(fmt::format("read {:.4f} s, free space {:.4f} s, gates {:.4f} s ({}), search {:.4f} s, peak memory {}",
                       seconds_.read, seconds_.space, seconds_.roadmap, gates_->gates().size(), seconds_.search,
                       peak_memory_text()));
    return gets_through() ? kFound : is_proven() ? kNone : kStopped;
  }

 private:
  void read_ends(const FreeSpace& space, const Input& input) {
    start_ = *input.world.start();
    require_free(space, start_, "start");
    if (input.world.goal().point) require_free(space, *input.world.goal().point, "goal");
    goals_ = goal_points(space, input.world.goal());
    if (goals_.empty())
      throw InputError(input.name, 0, "the middles of its goal room are no free places; give --to X,Y");
    goal_ = goals_.front();
  }

  /// Of a room, the point to which the largest disc gets; the first of several.
  bool ask() {
    for (const Point goal : goals_)
      if (auto widest = widest_passage(*gates_, start_, goal);
          widest && (!widest_ || widest->radius > widest_->radius)) {
        widest_ = std::move(widest);
        goal_ = goal;
      }
    if (asks_for_radius()) {
      passage_ = disc_passage(*gates_, start_, goal_, options_.query.robot.radius());
      barrier_ = barrier_of(*gates_, passage_->barrier);
    } else if (widest_) {
      barrier_ = barrier_of(*gates_, widest_->barrier);
    } else {
      const auto walls = NoPath(gates_->space()).walls(start_, {goal_, {}});
      if (walls) barrier_.walls = joined_walls(*walls, gates_->space().world().box());
    }
    return true;
  }

  /// A disc that does not get through has a chain of walls and gates in its way.
  bool is_proven() const { return gets_through() || !barrier_.walls.empty() || !barrier_.gates.empty(); }

  bool asks_for_radius() const { return options_.query.robot.kind() == Footprint::Kind::disc; }
  bool gets_through() const { return passage_ ? passage_->status == PassageStatus::reachable : widest_.has_value(); }

  std::string limit_text() const {
    switch (widest_->limit) {
      case WidestPassage::Limit::gate: return gates_->name(widest_->gate);
      case WidestPassage::Limit::none: return "there is no wall at all";
      default: break;
    }
    const bool at_start = widest_->limit == WidestPassage::Limit::start;
    return fmt::format("the {} {} is that far from the wall {}", at_start ? "start" : "goal",
                       point_text(at_start ? start_ : goal_),
                       segment_text(wall_near(gates_->space(), widest_->constraint, at_start ? start_ : goal_)));
  }

  std::string widest_text() const {
    if (widest_->limit == WidestPassage::Limit::none) return "a disc of any radius gets through: " + limit_text();
    if (widest_->limit == WidestPassage::Limit::gate)
      return fmt::format("the largest disc that gets through has radius {}, diameter {}", number_text(widest_->radius),
                         limit_text());
    return fmt::format("the largest disc that gets through has radius {}: {}", number_text(widest_->radius),
                       limit_text());
  }

  std::string line() const {
    if (!is_proven()) return why_not();
    if (!asks_for_radius() && !widest_) return "no path: " + separation_text(barrier_);
    if (!passage_) return fmt::format("{}, {}", widest_text(), seconds_text(seconds_.total));
    const std::string radius = number_text(options_.query.robot.radius());
    if (gets_through())
      return fmt::format("a disc of radius {} gets through; {}, {}", radius, widest_text(),
                         seconds_text(seconds_.total));
    return fmt::format("no disc of radius {} gets through: {}", radius, why_not());
  }

  std::string why_not() const {
    if (!is_proven()) return "no passage was found, and no walls prove that there is none";
    return passage_ ? blocked_text(*gates_, *passage_, barrier_, start_, goal_, options_.query.robot.radius())
                    : separation_text(barrier_);
  }

  std::string drawing(const FreeSpace& space, const std::string& source) const {
    SvgPicture picture;
    picture.title = title_of(source);
    picture.start = start_;
    picture.goal.point = goal_;
    if (asks_for_radius() || !widest_)
      picture.facts = {asks_for_radius()
                           ? fmt::format("a disc of radius {} {}", number_text(options_.query.robot.radius()),
                                         gets_through() ? "gets through" : "does not get through")
                           : "no path"};
    if (widest_) picture.facts.push_back("largest radius " + number_text(widest_->radius));
    if (!barrier_.gates.empty())
      picture.facts.push_back(count_text(barrier_.gates.size(), "gate") + " in the barrier, the widest " +
                              barrier_.gates.front().width_text);
    picture.separation = barrier_.walls;
    picture.gates = barrier_.gate_segments();
    return svg(space, picture);
  }

  std::string json_text(const std::string& source) const {
    static constexpr const char* kLimits[] = {"gate", "start", "goal", "none"};
    nlohmann::ordered_json json{{"program", "taut"},
                                {"version", TAUT_VERSION},
                                {"source", source},
                                {"status", gets_through() ? "found"
                                           : is_proven()  ? "none"
                                                          : "stopped"},
                                {"start", detail::json_of(start_)},
                                {"goal", {{"point", detail::json_of(goal_)}}}};
    if (asks_for_radius()) json["radius"] = options_.query.robot.radius();
    json["largest"] = nullptr;
    if (widest_) {
      const bool bounded = std::isfinite(widest_->radius);
      json["largest"] = {{"radius", bounded ? nlohmann::ordered_json(widest_->radius) : nullptr},
                         {"limit", kLimits[static_cast<int>(widest_->limit)]},
                         {"reason", limit_text()}};
    }
    if (!gets_through()) json["reason"] = why_not();
    json["barrier"] = barrier_json(barrier_);
    json["gates"] = gates_->gates().size();
    json["seconds"] = {{"read", seconds_.read},
                       {"space", seconds_.space},
                       {"gates", seconds_.roadmap},
                       {"search", seconds_.search},
                       {"total", seconds_.total}};
    return detail::json_text(json);
  }

  const PassageOptions& options_;
  Point start_, goal_;
  std::vector<Point> goals_;
  std::optional<Gates> gates_;
  std::optional<WidestPassage> widest_;
  std::optional<DiscPassage> passage_;  ///< for the radius asked about
  Barrier barrier_;
  StageSeconds seconds_;
  Stopwatch total_;
};

int run(const PassageOptions& options) { return Answerer(options).run(); }

}  // namespace

Command passage_command(CommandLine& app) {
  return command<PassageOptions>(app, "passage",
                                 "Say whether --robot disc:R gets from start to goal, or how large a disc may be",
                                 add_options, run);
}

}  // namespace taut::cli
