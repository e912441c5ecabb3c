#include <taut/cli/solve/solve_report.h>

#include <fmt/format.h>

#include <taut/cli/messages.h>
#include <taut/cli/report.h>

namespace taut::cli {

namespace {

constexpr std::size_t kWallsNamed = 4;
constexpr std::size_t kEdgesInBackground = 20'000;  // more would hide the path; `taut roadmap --svg` shows them

/// `manhattan says 9.5 at (1, 2), where 7.1 is left`
std::string overestimate_text(const GraphOverestimate& over, GraphHeuristic heuristic) {
  return fmt::format("{} says {:.6g} at ({}, {}), where {:.6g} is left", name(heuristic), over.estimate, over.at.x,
                     over.at.y, over.cost);
}

/// What is known of a path besides its length; empty when it is the shortest in the plane.
std::string claim(const PlanResult& result, const RoadmapKind& kind) {
  if (result.unpulled)
    return fmt::format(" (pulled taut from {} in the roadmap {}; not proven optimal)", length_text(*result.unpulled),
                       kind.name);
  if (!result.shortest_in_roadmap)
    return fmt::format(
        " ({} in the roadmap {}; not proven optimal{})", name(*result.method), kind.name,
        result.overestimate ? ": " + overestimate_text(*result.overestimate, result.method->heuristic) : "");
  if (kind.optimal) return "";
  if (result.bound > 1.0) return fmt::format(" (in the roadmap {})", kind.name);
  return fmt::format(" (shortest in the roadmap {}; not proven optimal)", kind.name);
}

std::vector<std::string> facts(const SolveAnswer& answer) {
  const PlanResult& result = answer.result;
  const RoadmapKind* kind = answer.kind;
  if (result.status == SearchStatus::none) return {"no path", seconds_text(result.seconds.total)};
  if (result.status == SearchStatus::stopped) return {result.reason, seconds_text(result.seconds.total)};
  const std::size_t points = result.path.points.size();
  std::vector<std::string> facts{"length " + length_text(result.path.length) + claim(result, *kind)};
  if (result.bound) facts.push_back("bound " + bound_text(*result.bound));
  facts.push_back(count_text(points > 2 ? points - 2 : 0, "corner"));
  facts.push_back(seconds_text(result.seconds.total));
  return facts;
}

}  // namespace

std::string solve_line(const SolveAnswer& answer) {
  const PlanResult& result = answer.result;
  if (result.status == SearchStatus::found) return fmt::format("{}", fmt::join(facts(answer), ", "));
  if (result.status == SearchStatus::stopped) return result.reason;
  if (!result.reason.empty()) return "no path: " + result.reason;
  if (result.separation.empty()) return "no path";
  return fmt::format("no path: {} start and goal: {}",
                     result.separation.size() == 1 ? "this wall separates"
                                                   : fmt::format("these {} walls separate", result.separation.size()),
                     segments_text(result.separation, kWallsNamed));
}

SvgPicture solve_picture(const SolveAnswer& answer) {
  const PlanResult& result = answer.result;
  SvgPicture picture;
  picture.title = title_of(result.source);
  picture.facts = facts(answer);
  if (answer.planned.diagram)
    picture.diagram = answer.planned.diagram.get();
  else if (answer.planned.roadmap->edge_count() <= kEdgesInBackground)
    picture.roadmap = answer.planned.roadmap.get();
  if (result.status == SearchStatus::found) picture.path = &answer.result.path;
  picture.separation = result.separation;
  picture.gates = answer.narrow;
  picture.start = result.start;
  picture.goal = result.goal;
  return picture;
}

void note_stages(const SolveAnswer& answer, const SolveOptions& options, const FreeSpace& space, const Input& input) {
  const PlanResult& result = answer.result;
  const RoadmapKind* kind = answer.kind;
  const FreeSpaceReport& report = space.report();
  const StageSeconds& s = result.seconds;
  note_stage("read", s.read,
             fmt::format("{}, {}", name(input.notes.format), count_text(input.world.walls().size(), "wall")));
  note_stage("free space", s.space,
             fmt::format("{} (union {:.4f} s, triangulation {:.4f} s), displacement {:.3g}",
                         count_text(space.triangulation().triangles.size(), "triangle"), report.seconds_union,
                         report.seconds_triangulation, report.displacement));
  note_stage("roadmap", s.roadmap,
             !kind->graph ? kind->title
                          : count_text(answer.planned.roadmap->vertex_count(), "vertex", "vertices") + ", " +
                                count_text(answer.planned.roadmap->edge_count(), "edge") + " (" +
                                (options.load.empty() ? kind->title : "loaded from " + options.load) + ")");
  if (answer.planned.prm) note(connectivity_text(*answer.planned.prm));
  note_stage("search", s.search,
             fmt::format("{} expanded ({})", result.expanded,
                         options.anytime.wanted ? "anytime"
                         : result.method        ? name(*result.method)
                                                : kind->name));
  note_stage("verify", s.verify,
             result.verified ? fmt::format("valid, clearance {:.6g}", result.clearance.value_or(0)) : "not done");
  note_stage("total", s.total, "peak memory " + peak_memory_text());
}

}  // namespace taut::cli
