// taut solve: the shortest path, or the walls that leave none.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <taut/cli/arcs.h>
#include <taut/cli/clearance.h>
#include <taut/cli/command.h>
#include <taut/cli/exit_code.h>
#include <taut/cli/input.h>
#include <taut/cli/messages.h>
#include <taut/cli/output.h>
#include <taut/cli/report.h>
#include <taut/cli/roadmap_kinds.h>
#include <taut/cli/timing.h>
#include <taut/io/result_json.h>
#include <taut/io/svg.h>
#include <taut/search/funnel.h>
#include <taut/search/query_ends.h>
#include <taut/search/verify.h>

namespace taut::cli {

namespace {

constexpr std::size_t kWallsNamed = 4;
constexpr std::size_t kEdgesInBackground = 20'000;  // more would hide the path; `taut roadmap --svg` shows them

// Six decimals, where they say something.
std::string length_text(const Length& length) {
  const double value = length.value();
  return value == 0 || (value >= 1e-3 && value < 1e12) ? length.decimals(6) : fmt::format("{:.9g}", value);
}

struct SolveOptions {
  WorldOptions world;
  QueryOptions query;
  OutputOptions output;
  CommonOptions common;
  GraphAlgorithm algorithm = GraphAlgorithm::astar;
  ClearanceQuery clearance;
  bool no_verify = false;
  bool path = false;
  bool shorten = false;
  PrmRequest prm;
  bool arcs = false;
  const RoadmapKind* kind = nullptr;  // when it is given
  std::string save;
  std::string load;

  ClearanceRequest clearance_request() const { return {world, query, output, clearance, !no_verify, path}; }
  bool stdout_taken() const { return output.stdout_taken() || save == "-"; }
};

// Options that exclude each other. Throws CLI::ValidationError.
void require_consistent(const SolveOptions& options) {
  if (options.clearance.kind != ClearanceQuery::Kind::none) {
    if ((options.kind && options.kind != roadmap_kind("voronoi")) || !options.save.empty() || !options.load.empty() ||
        options.shorten)
      throw CLI::ValidationError(
          "--clearance, --widest and --tradeoff go along the Voronoi diagram, not another roadmap");
    require_suitable(options.clearance_request());
  }
  if (options.kind && !options.kind->graph && !options.save.empty())
    throw CLI::ValidationError(fmt::format("--roadmap {} makes no graph that --save could keep", options.kind->name));
  if (options.kind && !options.save.empty()) require_savable(*options.kind);
  const RoadmapKind& kind = options.kind ? *options.kind : *roadmap_kind("visibility");
  if (!options.load.empty() && !options.prm.first().empty())
    throw CLI::ValidationError(options.prm.first() + " makes no sense with --load: that roadmap is built already");
  require_prm_options_fit(options.prm, kind);
  if (options.shorten && kind.optimal && options.load.empty())
    throw CLI::ValidationError(
        fmt::format("--shorten makes no sense with the roadmap {}: its paths are the shortest", kind.name));
  if (options.shorten && options.prm.clearance.value_or(0) > 0)
    throw CLI::ValidationError("--shorten makes no sense with --prm-clearance: a taut path touches corners");
  if ((options.output.svg == "-") + (options.output.json == "-") + (options.save == "-") > 1)
    throw CLI::ValidationError("only one of --svg, --json and --save can have standard output");
  if (options.arcs && (options.kind || !options.save.empty() || !options.load.empty() || options.shorten ||
                       options.clearance.kind != ClearanceQuery::Kind::none))
    throw CLI::ValidationError("--arcs has a roadmap of its own: not with --roadmap, --save, --load or --clearance");
  if (options.arcs && options.query.robot.kind() != Footprint::Kind::disc)
    throw CLI::ValidationError("--arcs needs --robot disc:R");
  if (options.load == "-" && options.world.file == "-")
    throw CLI::ValidationError("FILE and --load cannot both come from standard input");
  if (options.kind && !options.kind->graph && options.algorithm == GraphAlgorithm::dijkstra)
    throw CLI::ValidationError(fmt::format("--roadmap {} makes no graph for --algorithm dijkstra", options.kind->name));
}

void add_options(CLI::App& app, SolveOptions& options) {
  add_world_options(app, options.world);
  add_query_options(app, options.query);
  app.add_option_function<std::string>(
         "--algorithm",
         [&options](const std::string& text) {
           if (text != "astar" && text != "dijkstra")
             throw CLI::ValidationError("--algorithm: '" + text + "' is not astar or dijkstra");
           options.algorithm = text == "astar" ? GraphAlgorithm::astar : GraphAlgorithm::dijkstra;
         },
         "astar (default) or dijkstra; the path is the same length")
      ->type_name("NAME")
      ->group("Query");
  add_roadmap_kind(app, "--roadmap", options.kind, "Roadmap",
                   "polyanya; visibility with --algorithm dijkstra, --save or --load");
  app.add_option("--save", options.save, "Keep the roadmap for --load; - is standard output")
      ->type_name("FILE")
      ->group("Roadmap");
  app.add_option("--load", options.load, "Take the roadmap from here instead of building it; - is standard input")
      ->type_name("FILE")
      ->group("Roadmap");
  app.add_flag("--shorten", options.shorten,
               "Pull the path found in the roadmap taut: the shortest of its homotopy class")
      ->group("Roadmap");
  add_prm_options(app, options.prm, true);
  app.add_flag("--arcs", options.arcs,
               "With --robot disc:R: the disc itself, not a polygon around it; the path bends in arcs")
      ->group("Query");
  app.add_flag("--no-verify", options.no_verify, "Do not check the answer independently")->group("Query");
  app.add_flag("--path", options.path, "Print the points of the path, one `x y` a line")->group("Output");
  add_clearance_options(app, options.clearance);
  add_output_options(app, options.output);
  app.callback([&options] { require_consistent(options); });
}

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
    planned_ = timed("roadmap", result_.seconds.roadmap, [&] { return build_or_load(space); });
    end_progress();
    result_.roadmap = kind_->name;
    result_.prm = planned_.prm;
    result_.optimal = kind_->optimal;
    search(space);
    if (result_.status == SearchStatus::none) prove_none(space);
    if (result_.status == SearchStatus::found && !options_.no_verify) verify_answer(space);
    result_.seconds.total = total_.seconds();
    begin_stage("write");
    write(space);
    if (options_.output.stats) stats(space, input);
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
      const bool graph = !options_.save.empty() || options_.algorithm == GraphAlgorithm::dijkstra;
      kind_ = options_.kind ? options_.kind : roadmap_kind(graph ? "visibility" : "polyanya");
      return kind_->build(space, {options_.common.seed, result_.start, result_.goal, options_.prm,
                                  options_.common.limits.seconds.has_value(), prm_progress(options_.output.quiet)});
    }
    PlannedRoadmap loaded = load_roadmap(options_.load, space, kind_);
    if (options_.kind && options_.kind != kind_)
      throw InputError(options_.load, 0,
                       fmt::format("is a saved roadmap of the kind '{}', not '{}'", kind_->name, options_.kind->name));
    return loaded;
  }

  void search(const FreeSpace& space) {
    GraphSearchResult found = timed("search", result_.seconds.search,
                                    [&] { return planned_.search(*result_.start, result_.goal, options_.algorithm); });
    result_.status = found.status;
    result_.path = std::move(found.path);
    result_.expanded = found.expanded;
    if (!options_.shorten || result_.status != SearchStatus::found || kind_->optimal) return;
    result_.unpulled = result_.path.length;
    result_.path = shortened(space, result_.path).value();
  }

  // A roadmap that is not all there is says nothing about the plane: there the walls have to.
  void prove_none(const FreeSpace& space) {
    result_.separation = separation(space);
    if (kind_->optimal || !result_.separation.empty()) return;
    result_.status = SearchStatus::stopped;
    result_.stage = "search";
    result_.reason = fmt::format("no path in the roadmap {}, which does not prove that there is none", kind_->name);
    if (planned_.prm)
      result_.reason += fmt::format(" ({} samples, {} vertices at the start, {} at the goal)",
                                    planned_.prm->counts.drawn, planned_.prm->start_part, planned_.prm->goal_part);
  }

  void verify_answer(const FreeSpace& space) {
    const Verdict verdict = timed("verify", result_.seconds.verify,
                                  [&] { return verify(result_.path, space, *result_.start, result_.goal); });
    if (!verdict.valid) throw std::logic_error("the path found does not pass its own check: " + verdict.reason);
    result_.verified = true;
    result_.clearance = verdict.clearance;
  }

  // Of a room, its middles stand for it: none of it can be reached.
  std::vector<Segment> separation(const FreeSpace& space) const {
    std::vector<Point> goals;
    if (result_.goal.point) goals.push_back(*result_.goal.point);
    for (const Box& b : result_.goal.room)
      goals.push_back({b.min.x + (b.max.x - b.min.x) / 2, b.min.y + (b.max.y - b.min.y) / 2});
    for (const Point& goal : goals) {
      if (space.locate(goal).kind == Location::Kind::outside) continue;
      const std::vector<Segment> walls = joined_walls(space.separation(*result_.start, goal), space.world().box());
      if (!walls.empty()) return walls;
    }
    return {};
  }

  void write(const FreeSpace& space) {
    const std::string picture = options_.output.svg.empty() ? "" : svg(space, picture_now());
    const std::string json = options_.output.json.empty() ? "" : result_json(result_);
    const std::string saved = options_.save.empty() ? "" : saved_text(*kind_, planned_, space);
    finish();
    write_file(options_.save, saved);
    write_file(options_.output.svg, picture);
    write_file(options_.output.json, json);
    if (!options_.output.quiet && !options_.stdout_taken()) print(result_.source + ": " + line() + "\n");
    if (options_.path) print(points());
  }

  SvgPicture picture_now() const {
    SvgPicture picture;
    picture.title = title_of(result_.source);
    picture.facts = facts();
    if (planned_.diagram)
      picture.diagram = planned_.diagram.get();
    else if (planned_.roadmap->edge_count() <= kEdgesInBackground)
      picture.roadmap = planned_.roadmap.get();
    if (result_.status == SearchStatus::found) picture.path = &result_.path;
    picture.separation = result_.separation;
    picture.start = result_.start;
    picture.goal = result_.goal;
    return picture;
  }

  std::vector<std::string> facts() const {
    if (result_.status == SearchStatus::none) return {"no path", seconds_text(result_.seconds.total)};
    if (result_.status == SearchStatus::stopped) return {result_.reason, seconds_text(result_.seconds.total)};
    const std::size_t points = result_.path.points.size();
    const std::string claim = kind_->optimal ? ""
                              : result_.unpulled
                                  ? fmt::format(" (pulled taut from {} in the roadmap {}; not proven optimal)",
                                                length_text(*result_.unpulled), kind_->name)
                                  : fmt::format(" (shortest in the roadmap {}; not proven optimal)", kind_->name);
    return {"length " + length_text(result_.path.length) + claim, count_text(points > 2 ? points - 2 : 0, "corner"),
            seconds_text(result_.seconds.total)};
  }

  std::string line() const {
    if (result_.status == SearchStatus::found) return fmt::format("{}", fmt::join(facts(), ", "));
    if (result_.status == SearchStatus::stopped) return result_.reason;
    if (result_.separation.empty()) return "no path";
    return fmt::format("no path: {} start and goal: {}",
                       result_.separation.size() == 1
                           ? "this wall separates"
                           : fmt::format("these {} walls separate", result_.separation.size()),
                       segments_text(result_.separation, kWallsNamed));
  }

  std::string points() const {
    std::string out;
    for (const Point& p : result_.path.points) out += number_text(p.x) + " " + number_text(p.y) + "\n";
    return out;
  }

  void stats(const FreeSpace& space, const Input& input) const {
    const FreeSpaceReport& report = space.report();
    const StageSeconds& s = result_.seconds;
    const auto row = [](const char* stage, double seconds, const std::string& what) {
      note(fmt::format("{:<12}{:>9.4f} s   {}", stage, seconds, what));
    };
    row("read", s.read,
        fmt::format("{}, {}", name(input.notes.format), count_text(input.world.walls().size(), "wall")));
    row("free space", s.space,
        fmt::format("{} (union {:.4f} s, triangulation {:.4f} s), displacement {:.3g}",
                    count_text(space.triangulation().triangles.size(), "triangle"), report.seconds_union,
                    report.seconds_triangulation, report.displacement));
    row("roadmap", s.roadmap,
        !kind_->graph ? kind_->title
                      : count_text(planned_.roadmap->vertex_count(), "vertex", "vertices") + ", " +
                            count_text(planned_.roadmap->edge_count(), "edge") + " (" +
                            (options_.load.empty() ? kind_->title : "loaded from " + options_.load) + ")");
    if (planned_.prm) note(connectivity_text(*planned_.prm));
    row("search", s.search,
        fmt::format("{} expanded ({})", result_.expanded,
                    !kind_->graph                                 ? kind_->name
                    : options_.algorithm == GraphAlgorithm::astar ? "astar"
                                                                  : "dijkstra"));
    row("verify", s.verify,
        result_.verified ? fmt::format("valid, clearance {:.6g}", result_.clearance.value_or(0)) : "not done");
    row("total", s.total, "peak memory " + peak_memory_text());
  }

  const SolveOptions& options_;
  const RoadmapKind* kind_ = roadmap_kind("visibility");
  PlannedRoadmap planned_;
  PlanResult result_;
  Stopwatch total_;
};

int run(const SolveOptions& options) {
  if (options.clearance.kind != ClearanceQuery::Kind::none) return solve_with_clearance(options.clearance_request());
  if (options.arcs)
    return solve_with_arcs(options.world, options.query, options.output, !options.no_verify, options.path);
  return Solver(options).run();
}

}  // namespace

Command solve_command(CLI::App& app) {
  return command<SolveOptions>(app, "solve", "Find the shortest path from start to goal, or the walls that leave none",
                               add_options, run);
}

}  // namespace taut::cli
