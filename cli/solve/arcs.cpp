#include <taut/cli/solve/arcs.h>

#include <fmt/format.h>

#include <optional>
#include <stdexcept>

#include <taut/cli/exit_code.h>
#include <taut/cli/input.h>
#include <taut/cli/messages.h>
#include <taut/cli/output.h>
#include <taut/cli/report.h>
#include <taut/cli/timing.h>
#include <taut/io/pictures/svg.h>
#include <taut/io/results/arc_json.h>
#include <taut/search/disc_passage.h>
#include <taut/search/verify_arcs.h>

namespace taut::cli {

namespace {

std::size_t arcs_of(const ArcPath& path) {
  std::size_t count = 0;
  for (const ArcBend& bend : path.bends) count += bend.turn != 0;
  return count;
}

/// The walls and gates that leave no way, in words, their segments for the picture; nothing where none prove it.
std::optional<std::string> barrier_text(const Gates& gates, Point s, Point g, double r, std::vector<Segment>& drawn) {
  const DiscPassage passage = disc_passage(gates, s, g, r);
  if (passage.status == PassageStatus::reachable || passage.barrier.empty()) return std::nullopt;
  std::string narrow;
  for (const BarrierPiece& piece : passage.barrier) {
    if (piece.gate == taut::kNone) {
      const Constraint& wall = gates.space().constraints()[piece.constraint];
      drawn.push_back({wall.a, wall.b});
      continue;
    }
    drawn.push_back({gates.gates()[piece.gate].end, gates.gates()[piece.gate].foot});
    if (narrow.empty()) narrow = "; too narrow: " + gates.name(piece.gate);
  }
  return "no path: walls and gaps narrower than the disc separate start and goal" + narrow;
}

void require_place(const ArcSearchResult& result, const FreeSpace& space, const std::string& source, Point s, Point g) {
  if (result.status != ArcStatus::start_blocked && result.status != ArcStatus::goal_blocked) return;
  const bool start = result.status == ArcStatus::start_blocked;
  const std::string end = fmt::format("the {} {}", start ? "start" : "goal", point_text(start ? s : g));
  if (result.wall == taut::kNone) throw InputError(source, 0, end + " is outside the world or in an obstacle");
  const Constraint& wall = space.constraints()[result.wall];
  throw InputError(
      source, 0,
      fmt::format("{} is nearer than the disc's radius to the wall {}", end, segment_text({wall.a, wall.b})));
}

}  // namespace

int solve_with_arcs(const WorldOptions& world, const QueryOptions& query, const OutputOptions& output, bool verify,
                    bool points) {
  require_writable(output.svg);
  require_writable(output.json);
  const double r = query.robot.radius();
  const std::string source = world.file == "-" ? "<stdin>" : world.file;
  const Stopwatch total;
  double read = 0, build = 0, roadmap = 0, search = 0, check = 0;
  const Input input = timed("read", read, [&] { return read_input(world, query); });
  require_ends(input);
  if (!input.world.goal().point) throw InputError(source, 0, "the goal is a room; --arcs needs a goal point: --to X,Y");
  const Point s = *input.world.start(), g = *input.world.goal().point;
  const FreeSpace space = timed("space", build, [&] { return FreeSpace(input.world); });
  const TangentGraph graph = timed("roadmap", roadmap, [&] { return TangentGraph(space, r); });
  const ArcSearchResult result = timed("search", search, [&] { return arc_search(graph, s, g); });
  require_place(result, space, source, s, g);
  const bool found = result.status == ArcStatus::found;
  std::vector<Segment> separation;
  std::optional<std::string> none;
  if (!found) none = barrier_text(Gates(space), s, g, r, separation);
  std::string line = none.value_or("no path found, but no walls and gaps that prove that there is none");
  if (found && verify) {
    const ArcVerdict verdict = timed("verify", check, [&] { return verify_arcs(result.path, Gates(space), s, g); });
    if (!verdict.valid) throw std::logic_error("the path found does not pass its own check: " + verdict.reason);
  }
  const double seconds = total.seconds();
  std::vector<std::string> facts{none ? "no path" : "not proven", seconds_text(seconds)};
  if (found) {
    facts = {fmt::format("length {:.6f}", result.path.value()), count_text(arcs_of(result.path), "arc"),
             seconds_text(seconds)};
    line = fmt::format("{}", fmt::join(facts, ", "));
  }
  SvgPicture picture;
  picture.title = title_of(source);
  picture.facts = facts;
  if (found) picture.arcs = &result.path;
  picture.separation = separation;
  picture.start = s;
  picture.goal = input.world.goal();
  const std::string drawing = output.svg.empty() ? "" : svg(space, picture);
  const std::string json =
      output.json.empty() ? ""
                          : arc_json(result, space, s, g, r, found ? verify : none.has_value(), source, TAUT_VERSION);
  begin_stage("write");
  finish();
  write_file(output.svg, drawing);
  write_file(output.json, json);
  if (!output.quiet && !output.stdout_taken()) print(source + ": " + line + "\n");
  if (points && found) print(points_text(sampled(result.path, r / 1000)));
  if (output.stats)
    note(
        fmt::format("free space {:.4f} s, tangent graph {:.4f} s ({} corners, {} tangent points, {} tangents, {} "
                    "arcs), search {:.4f} s "
                    "({} expanded), verify {:.4f} s",
                    build, roadmap, graph.corner_count(), graph.point_count(), graph.leg_count(), graph.arc_count(),
                    search, result.expanded, check));
  return found ? kFound : none ? kNone : kStopped;
}

}  // namespace taut::cli
