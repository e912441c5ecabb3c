// taut solve: the shortest path, or the walls that leave none.
#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include <taut/cli/command.h>
#include <taut/cli/command_line.h>
#include <taut/cli/input.h>
#include <taut/cli/messages.h>
#include <taut/cli/progress.h>
#include <taut/cli/run.h>
#include <taut/cli/solve/alternatives.h>
#include <taut/cli/solve/anytime.h>
#include <taut/cli/solve/arcs.h>
#include <taut/cli/solve/certify.h>
#include <taut/cli/solve/clearance.h>
#include <taut/cli/solve/keep.h>
#include <taut/cli/solve/solve_options.h>
#include <taut/cli/solve/solve_report.h>
#include <taut/cli/solve/tradeoff.h>
#include <taut/cli/world/geographic.h>
#include <taut/cli/world/snap_ends.h>
#include <taut/geometry/errors.h>
#include <taut/geometry/rounding.h>
#include <taut/io/pictures/chords.h>
#include <taut/io/pictures/contours.h>
#include <taut/io/pictures/svg.h>
#include <taut/io/results/barrier_words.h>
#include <taut/io/results/result_json.h>
#include <taut/io/results/words.h>
#include <taut/io/saved/planned_roadmap.h>
#include <taut/search/disc_passage.h>
#include <taut/search/funnel.h>
#include <taut/search/no_path.h>
#include <taut/search/verify.h>

namespace taut::cli {

namespace {

class Solver {
 public:
  Solver(const SolveOptions& options, Run& run) : options_(options), run_(run) {}

  int solve() {
    run_.promise(options_.svg);
    promise(run_, options_.files);
    run_.promise(options_.save);
    run_.promise(options_.certificate);
    answer_.source = options_.world.file == "-" ? "<stdin>" : options_.world.file;
    result_.status = SearchStatus::stopped;
    result_.robot = options_.query.robot;
    keep();
    const Input input = read_input(options_.world, options_.query, run_);
    shown_ = Shown(input.notes);
    read_ends(input);
    const FreeSpace space = run_.stage("space", [&] {
      FreeSpace made(input.world, options_.query.robot);
      return wants_graph() || options_.kind ? triangulated(std::move(made)) : made;
    });
    result_.displacement = space.displacement();
    if (path_bound(space) > 0) result_.within = path_bound(space);
    require_free(space, *result_.start, "start", shown_);
    if (result_.goal.point) require_free(space, *result_.goal.point, "goal", shown_);
    answer_.planned = run_.stage("roadmap", [&] { return build_or_load(space); });
    progress_over();
    result_.roadmap = answer_.kind->name;
    result_.prm = answer_.planned.prm;
    keep();
    result_.optimal = answer_.kind->optimal;
    options_.anytime.wanted ? search_anytime() : search(space);
    if (result_.status == SearchStatus::none) prove_none(space, input);
    if (result_.status == SearchStatus::found && !options_.no_verify) verify_answer(space);
    if (!options_.certificate.empty()) certify(space);
    return end(space, input);
  }

 private:
  void keep() { run_.so_far(plan_json()); }

  Json plan_json() const {
    if (!shown_) return result_json(result_);
    const PlanResult result = shown_(result_);
    Json json = result_json(result);
    json["projection"] = shown_.json(result.path.points, result.path.length.value());
    return json;
  }

  void read_ends(const Input& input) {
    require_ends(input);
    answer_.moves = input.moves;
    result_.start = input.world.start();
    result_.goal = input.world.goal();
    result_.uncertainty = input.world.uncertainty();
    for (const Wall& wall : input.world.walls())
      result_.wall_thickness = std::max(result_.wall_thickness, wall.thickness);
    keep();
  }

  bool wants_graph() const {
    return !options_.save.empty() || !options_.load.empty() || options_.anytime.wanted || options_.method_given();
  }

  PlannedRoadmap build_or_load(const FreeSpace& space) {
    if (options_.load.empty()) {
      answer_.kind = options_.kind ? options_.kind : roadmap_kind(wants_graph() ? "visibility" : "polyanya");
      return answer_.kind->build(space, {options_.common.seed, result_.start, result_.goal, options_.prm,
                                         options_.common.limits.seconds.has_value(), shown_progress(options_.common)});
    }
    LoadedRoadmap loaded =
        load_roadmap(read_bytes(options_.load), options_.load == "-" ? "<stdin>" : options_.load, space);
    if (options_.kind && options_.kind != loaded.kind)
      throw InputError(
          options_.load, 0,
          fmt::format("is a saved roadmap of the kind '{}', not '{}'", loaded.kind->name, options_.kind->name));
    answer_.kind = loaded.kind;
    return std::move(loaded.planned);
  }

  void search(const FreeSpace& space) {
    GraphSearchResult found =
        run_.stage("search", [&] { return answer_.planned.search(*result_.start, result_.goal, options_.method()); });
    result_.status = found.status;
    result_.path = std::move(found.path);
    result_.expanded = found.expanded;
    if (result_.status == SearchStatus::stopped) leave_unproven();
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
    const double budget = most ? seconds_for_search(*most, run_.seconds().wall) : 1e300;
    const bool told = options_.common.stats || (is_progress_shown() && !options_.common.quiet);
    take(run_.stage("search", [&] {
      return anytime_path(answer_.planned.roadmap, answer_.planned.query(*result_.start, result_.goal),
                          options_.anytime.first_epsilon(), budget, [&](const AnytimeAnswer& so_far) {
                            if (told) note(improvement_text(so_far.improvements.back()));
                            take(so_far);
                            keep();
                          });
    }));
    if (result_.status != SearchStatus::stopped) return;
    answer_.outcome = Outcome::stopped;
    answer_.reason = fmt::format("--max-seconds {}", *most);
  }

  void take(const AnytimeAnswer& found) {
    result_.status = found.result.status;
    result_.path = found.result.path;
    result_.expanded = found.result.expanded;
    result_.improvements = found.improvements;
    if (result_.status != SearchStatus::found) return;
    result_.bound = found.bound;
    result_.optimal = answer_.kind->optimal && found.optimal;
  }

  // That a search found nothing is no proof; the walls are.
  void prove_none(const FreeSpace& space, const Input& input) {
    const bool disc = options_.query.robot.kind() == Footprint::Kind::disc;
    const auto walls = NoPath(space).walls(*result_.start, result_.goal);
    if (!walls && disc && prove_by_gates(input)) return;
    if (!walls) return leave_unproven();
    answer_.outcome = Outcome::none;
    if (disc) result_.within.reset();  // proven of the disc itself
    result_.separation = joined_walls(*walls, space.world().box());
    answer_.reason = walls->empty()                ? "no place of the goal is free"
                     : !result_.separation.empty() ? walls_text(shown_(result_.separation))
                                                   : "";
    if (disc) name_gates(input);
  }

  // A disc a hair too wide for a gap: what the polygons around and inside it cannot tell, the gates can.
  bool prove_by_gates(const Input& input) {
    if (!result_.goal.point) return false;
    const double radius = options_.query.robot.radius();
    const Gates gates{triangulated(FreeSpace(input.world))};
    const DiscPassage passage = disc_passage(gates, *result_.start, *result_.goal.point, radius);
    if (passage.status != DiscStatus::none || passage.barrier.empty()) return false;
    const Barrier barrier = barrier_of(gates, passage.barrier);
    answer_.outcome = Outcome::none;
    answer_.reason = barrier_text(shown_(barrier), radius);
    answer_.narrow = barrier.gate_segments();
    result_.status = SearchStatus::none;
    result_.separation = barrier.walls;
    result_.within.reset();
    if (rounding_bound(gates.space()) > 0) result_.within = rounding_bound(gates.space());
    return true;
  }

  void leave_unproven() {
    result_.status = SearchStatus::stopped;
    answer_.outcome = Outcome::unproven;
    answer_.reason = unproven_text(answer_, options_.query.robot);
  }

  void verify_answer(const FreeSpace& space) {
    const Verdict verdict =
        run_.stage("verify", [&] { return verify_along(result_.path, space, *result_.start, result_.goal); });
    if (!verdict.valid) throw std::logic_error("the path found does not pass its own check: " + verdict.reason);
    result_.verified = true;
    result_.clearance = verdict.clearance;
  }

  Certified proof_of(const FreeSpace& space) {
    if (options_.query.robot.kind() != Footprint::Kind::disc)
      return certified(space, result_, !options_.no_verify, run_);
    if (answer_.outcome == Outcome::found || !result_.goal.point)
      return {"", "no certificate: of a disc only that there is no way between two points, and of --widest", 0};
    return certified_narrow(space.world(), *result_.start, *result_.goal.point, options_.query.robot.radius(),
                            !options_.no_verify, run_);
  }

  // An answer without the proof that was asked for is unproven.
  void certify(const FreeSpace& space) {
    if (answer_.outcome != Outcome::found && answer_.outcome != Outcome::none) return;
    certified_ = proof_of(space);
    if (!certified_.text.empty()) return;
    answer_.outcome = Outcome::unproven;
    answer_.reason = certified_.words;
  }

  // The edges of where its centre can be say little to people.
  void name_gates(const Input& input) {
    const auto barrier = disc_barrier(input.world, *result_.start, goals(), options_.query.robot.radius());
    if (!barrier) return;
    answer_.reason = barrier_text(shown_(*barrier), options_.query.robot.radius());
    answer_.narrow = barrier->gate_segments();
  }

  // Of a room, its middles stand for it: none of it can be reached.
  std::vector<Point> goals() const {
    std::vector<Point> goals;
    if (result_.goal.point) goals.push_back(*result_.goal.point);
    for (const Box& b : result_.goal.room)
      goals.push_back({b.min.x + (b.max.x - b.min.x) / 2, b.min.y + (b.max.y - b.min.y) / 2});
    return goals;
  }

  PathToWrite written_path() const {
    return {.name = result_.roadmap, .points = shown_(result_.path.points), .length = result_.path.length.value()};
  }

  std::string drawing(const FreeSpace& space) {
    SvgPicture picture = solve_picture(answer_);
    if (options_.contours > 0)
      picture.contours = run_.stage("contours", [&] { return contours(space, *result_.start, options_.contours); });
    if (!certified_.text.empty() && result_.optimal && result_.goal.point) add_chords(picture, space, result_.path);
    return svg(space, picture);
  }

  int end(const FreeSpace& space, const Input& input) {
    Answer answer;
    answer.outcome = answer_.outcome;
    answer.reason = answer_.reason;
    answer.line = solve_line(answer_, run_.seconds());
    if (run_.wants_json()) answer.result = plan_json();
    if (options_.path) answer.listing = points_text(shown_(result_.path.points));
    answer.stats = solve_stats(answer_, options_, space, input);
    if (!options_.save.empty())
      answer.files.push_back({options_.save, saved_text(*answer_.kind, answer_.planned, space)});
    if (!certified_.text.empty()) answer.files.push_back({options_.certificate, certified_.text});
    if (!options_.svg.empty()) answer.files.push_back({options_.svg, drawing(space)});
    if (result_.status == SearchStatus::found) add_path_files(answer.files, options_.files, {written_path()});
    return run_.end(std::move(answer));
  }

  const SolveOptions& options_;
  Run& run_;
  Shown shown_{ReadNotes{}};
  SolveAnswer answer_;
  Certified certified_;
  PlanResult& result_ = answer_.result;
};

int run(const SolveOptions& options, Run& run) {
  run.source(options.world.file);
  if (options.tradeoff()) return solve_tradeoff(options, run);
  if (options.clearance) return solve_with_clearance(options, run);
  if (options.ways_given()) return solve_alternatives(options, run);
  if (options.keep) return solve_keeping(options, run);
  if (options.arcs) return solve_with_arcs(options, run);
  return Solver(options, run).solve();
}

}  // namespace

Command solve_command(CommandLine& app) {
  return command<SolveOptions>(app, "solve", "Find the shortest path from start to goal, or the walls that leave none",
                               add_solve_options, run);
}

}  // namespace taut::cli
