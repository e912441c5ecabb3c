#include <taut/cli/solve/solve_report.h>

#include <fmt/format.h>

#include <taut/cli/messages.h>
#include <taut/cli/solve/prm_options.h>
#include <taut/cli/solve/roadmap_option.h>
#include <taut/geometry/cell_plan.h>
#include <taut/search/corner_count.h>

namespace taut::cli {

namespace {

constexpr std::size_t kWallsNamed = 4;
constexpr std::size_t kEdgesInBackground = 20'000;  // more would hide the path; `taut roadmap --svg` shows them

/// `manhattan says 9.5 at (1, 2), where 7.1 is left`
std::string overestimate_text(const GraphOverestimate& over, GraphHeuristic heuristic) {
  return fmt::format("{} says {:.6g} at {}, where {:.6g} is left", name(heuristic), over.estimate, point_text(over.at),
                     over.cost);
}

/// What is known of a path besides its length; empty when it is the shortest in the plane.
std::string claim_of(const SolveAnswer& answer) {
  const PlanResult& result = answer.result;
  if (result.unpulled)
    return fmt::format(" (pulled taut from {} in the roadmap {}; not proven optimal)", length_text(*result.unpulled),
                       answer.kind->name);
  if (!result.shortest_in_roadmap)
    return fmt::format(
        " ({} in the roadmap {}; not proven optimal{})", name(*result.method), answer.kind->name,
        result.overestimate ? ": " + overestimate_text(*result.overestimate, result.method->heuristic) : "");
  if (answer.kind->optimal) return {};
  if (result.bound > 1.0) return fmt::format(" (in the roadmap {})", answer.kind->name);
  return fmt::format(" (shortest in the roadmap {}; not proven optimal)", answer.kind->name);
}

std::vector<std::string> facts(const SolveAnswer& answer) {
  const PlanResult& result = answer.result;
  if (answer.outcome == Outcome::none) return {"no path"};
  if (answer.outcome != Outcome::found) return {answer.reason};
  std::vector<std::string> facts{"length " + length_text(result.path.length) + claim_of(answer)};
  if (result.bound) facts.push_back("bound " + bound_text(*result.bound));
  facts.push_back(count_text(corner_count(result.path.points, result.uncertainty), "corner"));
  return facts;
}

std::string search_name(const SolveAnswer& answer, const SolveOptions& options) {
  if (options.anytime.wanted) return "anytime";
  return answer.result.method ? name(*answer.result.method) : answer.kind->name;
}

std::string space_stat(const FreeSpace& space) {
  if (!space.is_triangulated()) return fmt::format("{} x {} cells", space.cells()->columns(), space.cells()->rows());
  const FreeSpaceReport& report = space.report();
  return fmt::format("{} (union {:.4f} s, triangulation {:.4f} s wall), displacement {:.3g}",
                     count_text(space.triangulation().triangles.size(), "triangle"), report.seconds_union,
                     report.seconds_triangulation, report.displacement);
}

std::string roadmap_stat(const SolveAnswer& answer, const SolveOptions& options) {
  if (!answer.kind->graph) return answer.kind->title;
  if (answer.planned.prm) return answer.kind->title + (", " + connectivity_text(*answer.planned.prm));
  const std::string text = fmt::format("{}", fmt::join(roadmap_facts(*answer.kind, answer.planned), ", "));
  return options.load.empty() ? text : text + ", loaded from " + options.load;
}

}  // namespace

std::string walls_text(const std::vector<Segment>& separation) {
  return fmt::format(
      "{} start and goal: {}",
      separation.size() == 1 ? "this wall separates" : fmt::format("these {} walls separate", separation.size()),
      segments_text(separation, kWallsNamed));
}

std::string unproven_text(const SolveAnswer& answer, const Footprint& robot) {
  const std::optional<double>& within = answer.result.within;
  std::string reason =
      fmt::format("no path in the roadmap {}, which does not prove that there is none", answer.kind->name);
  if (answer.kind->optimal && within)
    reason = fmt::format(
        "no path, but an end is so near a wall ({:.3g}) that rounded crossings may have put it on its other side",
        *within);
  if (answer.kind->optimal && robot.kind() == Footprint::Kind::disc)
    reason =
        "no path for the polygon around the disc, which does not prove that there is none for the disc; "
        "--arcs plans for the disc itself";
  if (const auto& prm = answer.planned.prm)
    reason += fmt::format(" ({} samples, {} vertices at the start, {} at the goal)", prm->counts.drawn, prm->start_part,
                          prm->goal_part);
  return reason;
}

std::string solve_line(const SolveAnswer& answer, const Seconds& total) {
  if (answer.outcome == Outcome::none)
    return answer.source + ": no path" + (answer.reason.empty() ? "" : ": " + answer.reason) + "\n";
  if (answer.outcome != Outcome::found) return answer.source + ": " + answer.reason + "\n";
  return fmt::format("{}: {}, {}\n", answer.source, fmt::join(facts(answer), ", "), cpu_text(total));
}

SvgPicture solve_picture(const SolveAnswer& answer) {
  const PlanResult& result = answer.result;
  SvgPicture picture;
  picture.title = title_of(answer.source);
  picture.facts = facts(answer);
  if (answer.planned.counts)
    picture.facts.push_back(
        fmt::format("{} samples drawn, {} kept", answer.planned.counts->drawn, answer.planned.counts->kept));
  if (answer.planned.diagram)
    picture.diagram = answer.planned.diagram.get();
  else if (answer.planned.roadmap->edge_count() <= kEdgesInBackground)
    picture.roadmap = answer.planned.roadmap.get();
  picture.milestones = answer.kind->samples;
  if (answer.outcome == Outcome::found) picture.path = &answer.result.path;
  picture.separation = result.separation;
  picture.gates = answer.narrow;
  picture.start = result.start;
  picture.moves = answer.moves;
  picture.goal = result.goal;
  return picture;
}

std::vector<std::pair<std::string, std::string>> solve_stats(const SolveAnswer& answer, const SolveOptions& options,
                                                             const FreeSpace& space, const Input& input) {
  const PlanResult& result = answer.result;
  return {
      {"read", fmt::format("{}, {}", name(input.notes.format), count_text(input.world.walls().size(), "wall"))},
      {"space", space_stat(space)},
      {"roadmap", roadmap_stat(answer, options)},
      {"search", fmt::format("{} expanded ({})", result.expanded, search_name(answer, options))},
      {"verify", result.verified ? fmt::format("valid, clearance {:.6g}", result.clearance.value_or(0)) : "not done"}};
}

}  // namespace taut::cli
