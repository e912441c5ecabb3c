#include <taut/cli/command_line.h>
#include <taut/cli/solve/clearance.h>
#include <taut/geometry/corridor_width.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include <taut/cli/exit_code.h>
#include <taut/cli/input.h>
#include <taut/cli/output.h>
#include <taut/cli/report.h>
#include <taut/cli/solve/clearance_report.h>
#include <taut/cli/timing.h>
#include <taut/io/pictures/svg.h>
#include <taut/search/no_path.h>
#include <taut/search/query_ends.h>
#include <taut/search/verify.h>
#include <taut/search/voronoi_search.h>

namespace taut::cli {

namespace {

constexpr double kSampling = 1e-4;  // of a corridor: how far legs leave their arc when the path is checked or printed

using Kind = ClearanceQuery::Kind;

class ClearanceSolver {
 public:
  explicit ClearanceSolver(const ClearanceRequest& request) : request_(request) {}

  int run() {
    require_writable(request_.output.svg);
    require_writable(request_.output.json);
    answer_.source = request_.world.file == "-" ? "<stdin>" : request_.world.file;
    answer_.query = request_.what;
    prepare_last_words();
    StageSeconds& seconds = answer_.seconds;
    const Input input = timed("read", seconds.read, [&] { return read_input(request_.world, request_.query); });
    require_ends(input);
    const FreeSpace space = timed("space", seconds.space, [&] { return FreeSpace(input.world); });
    read_ends(space, input);
    const FreeSpace walled(walled_world(input.world, all_ends()));
    build(walled);
    if (!goals_.empty()) search();
    if (answer_.status == SearchStatus::found && request_.verify) verify_answer(space, walled);
    seconds.total = total_.seconds();
    begin_stage("write");
    write(space, walled);
    if (request_.output.stats) stats(input);
    return answer_.status == SearchStatus::found ? kFound : answer_.status == SearchStatus::none ? kNone : kStopped;
  }

 private:
  void prepare_last_words() const {
    if (request_.output.json.empty()) return;
    PlanResult stopped;
    stopped.version = TAUT_VERSION;
    stopped.source = answer_.source;
    stopped.status = SearchStatus::stopped;
    stopped.roadmap = "voronoi";
    stopped.optimal = false;
    stopped.start = answer_.start;
    on_stop([stopped, total = total_, file = request_.output.json](const Stop& why) mutable {
      stopped.reason = why.reason;
      stopped.stage = why.stage;
      stopped.seconds.total = total.seconds();
      write_file(file, result_json(stopped));
    });
  }

  void read_ends(const FreeSpace& space, const Input& input) {
    answer_.start = input.world.start();
    require_free(space, *answer_.start, "start");
    if (input.world.goal().point) require_free(space, *input.world.goal().point, "goal");
    goals_ = goal_points(space, input.world.goal());
    if (goals_.empty())
      throw InputError(input.name, 0, "the middles of its goal room are no free places; give --to X,Y");
    prepare_last_words();
  }

  std::vector<Point> all_ends() const {
    std::vector<Point> ends = goals_;
    ends.push_back(*answer_.start);
    return ends;
  }

  void build(const FreeSpace& walled) {
    map_ = timed("roadmap", answer_.seconds.roadmap, [&] { return std::make_unique<const VoronoiRoadmap>(walled); });
    gates_ = timed("gates", gate_seconds_, [&] { return std::make_unique<const Gates>(walled); });
    answer_.places = {map_->vertices().size(), map_->edges().size()};
    answer_.max_error = map_->max_error();
  }

  /// Of a room, the point to which the largest disc gets; the first of several.
  Point best_goal() const {
    Point best = goals_.front();
    double radius = -1;
    for (const Point goal : goals_)
      if (const auto widest = widest_passage(*gates_, *answer_.start, goal); widest && widest->radius > radius) {
        radius = widest->radius;
        best = goal;
      }
    return best;
  }

  void search() {
    answer_.goal = best_goal();
    const ClearanceSearch query(*map_, *answer_.start, *answer_.goal);
    answer_.found = timed("search", answer_.seconds.search, [&] { return ways(query); });
    answer_.status = answer_.found.empty() ? SearchStatus::none : SearchStatus::found;
    if (answer_.found.empty())
      prove_none();
    else if (request_.what.kind == Kind::widest)
      name_limit();
  }

  std::vector<ClearanceTrade> ways(const ClearanceSearch& query) const {
    if (request_.what.kind == Kind::tradeoff) return query.tradeoff();
    auto way = request_.what.kind == Kind::widest ? query.widest() : query.shortest(request_.what.clearance);
    if (!way) return {};
    return {{way->pinch.clearance, std::move(*way)}};
  }

  /// The gates prove it; where not even a point gets through, the walls.
  void prove_none() {
    const double r = request_.what.kind == Kind::at_least ? request_.what.clearance : 0;
    if (r == 0) {
      const auto walls = NoPath(map_->space()).walls(*answer_.start, {answer_.goal, {}});
      if (!walls || walls->empty()) return leave_unproven();
      answer_.barrier.walls = joined_walls(*walls, map_->space().world().box());
      answer_.reason = separation_text(answer_.barrier);
      return;
    }
    const DiscPassage passage = disc_passage(*gates_, *answer_.start, *answer_.goal, r);
    if (passage.status == PassageStatus::reachable) return differ();
    answer_.barrier = barrier_of(*gates_, passage.barrier);
    answer_.reason = blocked_text(*gates_, passage, answer_.barrier, *answer_.start, *answer_.goal, r);
  }

  void leave_unproven() {
    answer_.status = SearchStatus::stopped;
    answer_.stage = "search";
    answer_.reason = "no way in the diagram, which does not prove that there is none";
  }

  void differ() {
    answer_.status = SearchStatus::stopped;
    answer_.stage = "verify";
    answer_.reason =
        fmt::format("the diagram, exact to {:.2g}, and the gates disagree by less than that", map_->max_error());
  }

  void name_limit() {
    answer_.limit = widest_passage(*gates_, *answer_.start, *answer_.goal);
    if (!answer_.limit || answer_.limit->limit != WidestPassage::Limit::gate) return;
    answer_.barrier = barrier_of(*gates_, answer_.limit->barrier);
    answer_.width = gates_->width_text(answer_.limit->gate);
  }

  /// Every path against the walls, its width against the gates, and that nothing wider was missed.
  void verify_answer(const FreeSpace& space, const FreeSpace& walled) {
    answer_.verified = timed("verify", answer_.seconds.verify, [&] {
      return std::all_of(answer_.found.begin(), answer_.found.end(),
                         [&](const ClearanceTrade& t) { return is_followed(t.path, space, walled); }) &&
             gates_agree();
    });
    if (!answer_.verified) differ();
  }

  bool is_followed(const ClearancePath& way, const FreeSpace& space, const FreeSpace& walled) const {
    const std::vector<Point> points = points_of(way);
    const Path path{points, Length(points)};
    const double slack = tolerance(walled) + 4 * map_->max_error() + 1e-12 * way.length;
    if (way.pinch.clearance <= slack) return true;  // rounded, it may cross the wall that it touches
    const Goal goal{answer_.goal, {}};
    const Verdict inside = verify(path, space, *answer_.start, goal), wide = verify(path, walled, *answer_.start, goal);
    return inside.valid && wide.valid && wide.clearance >= way.pinch.clearance - slack;
  }

  bool gates_agree() const {
    const double r = answer_.found.back().clearance;
    if (request_.what.kind == Kind::at_least)
      return request_.what.clearance == 0 ||
             disc_passage(*gates_, *answer_.start, *answer_.goal, request_.what.clearance).status ==
                 PassageStatus::reachable;
    const auto widest = widest_passage(*gates_, *answer_.start, *answer_.goal);
    // The one is rounded to nearest, the other down.
    return widest && widest->radius <= r && r <= std::nextafter(widest->radius, HUGE_VAL);
  }

  double tolerance(const FreeSpace& space) const { return kSampling * corridor_width(space); }

  std::vector<Point> points_of(const ClearancePath& way) const {
    if (way.curves.empty()) return {*answer_.start};
    return sampled(way.curves, tolerance(map_->space()));
  }

  void write(const FreeSpace& space, const FreeSpace& walled) {
    const OutputOptions& output = request_.output;
    const std::string picture = output.svg.empty() ? "" : clearance_svg(answer_, space, *map_);
    const std::string json = output.json.empty() ? "" : clearance_json(answer_, walled);
    finish();
    write_file(output.svg, picture);
    write_file(output.json, json);
    if (!output.quiet && !output.stdout_taken()) print(clearance_text(answer_, walled));
    if (request_.path && answer_.status == SearchStatus::found)
      print(points_text(points_of(answer_.found.front().path)));
  }

  void stats(const Input& input) const {
    const StageSeconds& s = answer_.seconds;
    note_stage("read", s.read, count_text(input.world.walls().size(), "wall"));
    note_stage("free space", s.space, "");
    note_stage("diagram", s.roadmap,
               fmt::format("{}, {}, vertices within {:.2g}", count_text(answer_.places[0], "vertex", "vertices"),
                           count_text(answer_.places[1], "edge"), answer_.max_error));
    note_stage("gates", gate_seconds_, count_text(gates_->gates().size(), "gate"));
    note_stage("search", s.search, "");
    note_stage("verify", s.verify, answer_.verified ? "walls and gates agree" : "not done");
    note_stage("total", s.total, "peak memory " + peak_memory_text());
  }

  const ClearanceRequest& request_;
  ClearanceAnswer answer_;
  std::vector<Point> goals_;
  std::unique_ptr<const VoronoiRoadmap> map_;
  std::unique_ptr<const Gates> gates_;
  double gate_seconds_ = 0;
  Stopwatch total_;
};

}  // namespace

void add_clearance_options(CommandLine& app, ClearanceQuery& query) {
  const auto choose = [&query](Kind kind) {
    if (query.kind != Kind::none) throw UsageError("only one of --clearance, --widest and --tradeoff");
    query.kind = kind;
  };
  app.add_option_function(
         "--clearance",
         [&query, choose](const std::string& text) {
           choose(Kind::at_least);
           query.clearance = number_of(text, "--clearance");
           if (query.clearance < 0) throw UsageError("--clearance: '" + text + "' is negative");
         },
         "The shortest way along the Voronoi diagram that keeps this far from walls and from the limits of the world")
      .type_name("C")
      .group("Clearance");
  const auto flag = [&](const char* name, Kind kind, const char* what) {
    app.add_flag_callback(
           name, [choose, kind] { choose(kind); }, what)
        .group("Clearance");
  };
  flag("--widest", Kind::widest, "The largest disc that gets through, its way, and the two walls that pinch it");
  flag("--tradeoff", Kind::tradeoff, "All best ways between the shortest along the diagram and the widest");
}

void require_suitable(const ClearanceRequest& request) {
  if (request.query.robot.kind() != Footprint::Kind::point)
    throw UsageError(
        "--robot does not go with --clearance, --widest and --tradeoff; a disc of radius R is --clearance R");
  if (request.path && request.what.kind == Kind::tradeoff)
    throw UsageError("--path prints one path, --tradeoff has several; --json - writes them all");
}

int solve_with_clearance(const ClearanceRequest& request) { return ClearanceSolver(request).run(); }

}  // namespace taut::cli
