// taut solve: the shortest path, or the walls that leave none.
#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include <taut/cli/command.h>
#include <taut/cli/command_line.h>
#include <taut/cli/exit_code.h>
#include <taut/cli/input.h>
#include <taut/cli/messages.h>
#include <taut/cli/output.h>
#include <taut/cli/report.h>
#include <taut/cli/solve/anytime.h>
#include <taut/cli/solve/arcs.h>
#include <taut/cli/solve/barrier.h>
#include <taut/cli/solve/clearance.h>
#include <taut/cli/solve/solve_options.h>
#include <taut/cli/solve/solve_report.h>
#include <taut/cli/timing.h>
#include <taut/io/pictures/svg.h>
#include <taut/io/results/result_json.h>
#include <taut/search/funnel.h>
#include <taut/search/no_path.h>
#include <taut/search/query_ends.h>
#include <taut/search/verify.h>

namespace taut::cli {

namespace {

class Solver {
 public:
  explicit Solver(const SolveOptions& options) : options_(options) {}

  int run() {
    require_writable(options_.output.svg);
    require_writable(options_.output.json);
    require_writable(options_.save);
    result_.version = TAUT_VERSION;
    result_.source = options_.world.file == "-" ? "<stdin>" : options_.world.file;
    result_.robot = options_.query.robot;
    prepare_last_words();
    const Input input = timed("read", result_.seconds.read, [&] { return read_input(options_.world, options_.query); });
    read_ends(input);
    const FreeSpace space =
        timed("space", result_.seconds.space, [&] { return FreeSpace(input.world, options_.query.robot); });
    result_.displacement = space.report().displacement;
    require_free(space, *result_.start, "start");
    if (result_.goal.point) require_free(space, *result_.goal.point, "goal");
    answer_.planned = timed("roadmap", result_.seconds.roadmap, [&] { return build_or_load(space); });
    end_progress();
    result_.roadmap = answer_.kind->name;
    result_.prm = answer_.planned.prm;
    result_.optimal = answer_.kind->optimal;
    options_.anytime.wanted ? search_anytime() : search(space);
    if (result_.status == SearchStatus::none) prove_none(space, input);
    if (result_.status == SearchStatus::found && !options_.no_verify) verify_answer(space);
    result_.seconds.total = total_.seconds();
    begin_stage("write");
    write(space);
    if (options_.output.stats) note_stages(answer_, options_, space, input);
    return result_.status == SearchStatus::found ? kFound : result_.status == SearchStatus::none ? kNone : kStopped;
  }

 private:
  // What a stopped run still writes: a copy of what is known so far.
  void prepare_last_words() const {
    if (options_.output.json.empty()) return;
    PlanResult stopped;
    stopped.version = result_.version;
    stopped.source = result_.source;
    stopped.start = result_.start;
    stopped.goal = result_.goal;
    stopped.robot = result_.robot;
    stopped.wall_thickness = result_.wall_thickness;
    stopped.status = SearchStatus::stopped;
    on_stop([stopped, total = total_, file = options_.output.json](const Stop& why) mutable {
      stopped.reason = why.reason;
      stopped.stage = why.stage;
      stopped.seconds.total = total.seconds();
      write_file(file, result_json(stopped));
    });
  }

  void read_ends(const Input& input) {
    require_ends(input);
    result_.start = input.world.start();
    result_.goal = input.world.goal();
    for (const Wall& wall : input.world.walls())
      result_.wall_thickness = std::max(result_.wall_thickness, wall.thickness);
    prepare_last_words();
  }

  PlannedRoadmap build_or_load(const FreeSpace& space) {
    if (options_.load.empty()) {
      const bool graph = !options_.save.empty() || options_.anytime.wanted || options_.method_given();
      answer_.kind = options_.kind ? options_.kind : roadmap_kind(graph ? "visibility" : "polyanya");
      return answer_.kind->build(space,
                                 {options_.common.seed, result_.start, result_.goal, options_.prm,
                                  options_.common.limits.seconds.has_value(), prm_progress(options_.output.quiet)});
    }
    PlannedRoadmap loaded = load_roadmap(options_.load, space, answer_.kind);
    if (options_.kind && options_.kind != answer_.kind)
      throw InputError(
          options_.load, 0,
          fmt::format("is a saved roadmap of the kind '{}', not '{}'", answer_.kind->name, options_.kind->name));
    return loaded;
  }

  void search(const FreeSpace& space) {
    GraphSearchResult found = timed("search", result_.seconds.search, [&] {
      return answer_.planned.search(*result_.start, result_.goal, options_.method());
    });
    result_.status = found.status;
    result_.path = std::move(found.path);
    result_.expanded = found.expanded;
    if (answer_.planned.query) result_.method = options_.method();
    result_.shortest_in_roadmap = found.optimal;
    result_.optimal = answer_.kind->optimal && found.optimal;
    result_.overestimate = found.overestimate;
    if (!options_.shorten || result_.status != SearchStatus::found || result_.optimal) return;
    result_.unpulled = result_.path.length;
    result_.path = shortened(space, result_.path).value();
  }

  void search_anytime() {
    const std::optional<double> most = options_.common.limits.seconds;
    const double budget = most ? seconds_for_search(*most, total_.seconds()) : 1e300;
    const bool told = options_.output.stats || (is_progress_shown() && !options_.output.quiet);
    AnytimeAnswer found = timed("search", result_.seconds.search, [&] {
      return solve_anytime(answer_.planned, *result_.start, result_.goal, options_.anytime, budget, told);
    });
    result_.status = found.result.status;
    result_.path = std::move(found.result.path);
    result_.expanded = found.result.expanded;
    result_.improvements = std::move(found.improvements);
    if (result_.status == SearchStatus::found) {
      result_.bound = found.bound;
      result_.optimal = answer_.kind->optimal && found.optimal;
    }
    if (result_.status != SearchStatus::stopped) return;
    result_.stage = "search";
    result_.reason = fmt::format("--max-seconds {}", *most);
  }

  // That a search found nothing is no proof; the walls are.
  void prove_none(const FreeSpace& space, const Input& input) {
    const auto walls = NoPath(space).walls(*result_.start, result_.goal);
    if (!walls) return leave_unproven();
    result_.separation = joined_walls(*walls, space.world().box());
    if (walls->empty()) result_.reason = "no place of the goal is free";
    if (options_.query.robot.kind() == Footprint::Kind::disc) name_gates(input);
  }

  void leave_unproven() {
    result_.status = SearchStatus::stopped;
    result_.stage = "search";
    result_.reason =
        fmt::format("no path in the roadmap {}, which does not prove that there is none", answer_.kind->name);
    if (answer_.kind->optimal && options_.query.robot.kind() == Footprint::Kind::disc)
      result_.reason = "no path for the polygon around the disc, which does not prove that there is none for the disc";
    if (answer_.planned.prm)
      result_.reason +=
          fmt::format(" ({} samples, {} vertices at the start, {} at the goal)", answer_.planned.prm->counts.drawn,
                      answer_.planned.prm->start_part, answer_.planned.prm->goal_part);
  }

  void verify_answer(const FreeSpace& space) {
    const Verdict verdict = timed("verify", result_.seconds.verify,
                                  [&] { return verify(result_.path, space, *result_.start, result_.goal); });
    if (!verdict.valid) throw std::logic_error("the path found does not pass its own check: " + verdict.reason);
    result_.verified = true;
    result_.clearance = verdict.clearance;
  }

  // The edges of where its centre can be say little to people.
  void name_gates(const Input& input) {
    auto found = disc_barrier(input.world, *result_.start, goals(), options_.query.robot.radius());
    if (!found) return;
    result_.reason = std::move(found->text);
    answer_.narrow = found->barrier.gate_segments();
  }

  // Of a room, its middles stand for it: none of it can be reached.
  std::vector<Point> goals() const {
    std::vector<Point> goals;
    if (result_.goal.point) goals.push_back(*result_.goal.point);
    for (const Box& b : result_.goal.room)
      goals.push_back({b.min.x + (b.max.x - b.min.x) / 2, b.min.y + (b.max.y - b.min.y) / 2});
    return goals;
  }

  void write(const FreeSpace& space) {
    const std::string picture = options_.output.svg.empty() ? "" : svg(space, solve_picture(answer_));
    const std::string json = options_.output.json.empty() ? "" : result_json(result_);
    const std::string saved = options_.save.empty() ? "" : saved_text(*answer_.kind, answer_.planned, space);
    finish();
    write_file(options_.save, saved);
    write_file(options_.output.svg, picture);
    write_file(options_.output.json, json);
    if (!options_.output.quiet && !options_.stdout_taken()) print(result_.source + ": " + solve_line(answer_) + "\n");
    if (options_.path) print(points_text(result_.path.points));
  }

  const SolveOptions& options_;
  SolveAnswer answer_;
  PlanResult& result_ = answer_.result;
  Stopwatch total_;
};

int run(const SolveOptions& options) {
  if (options.clearance.kind != ClearanceQuery::Kind::none) return solve_with_clearance(options.clearance_request());
  if (options.arcs)
    return solve_with_arcs(options.world, options.query, options.output, !options.no_verify, options.path);
  return Solver(options).run();
}

}  // namespace

Command solve_command(CommandLine& app) {
  return command<SolveOptions>(app, "solve", "Find the shortest path from start to goal, or the walls that leave none",
                               add_solve_options, run);
}

}  // namespace taut::cli
