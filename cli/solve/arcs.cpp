#include <taut/cli/solve/arcs.h>

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <utility>

#include <taut/cli/input.h>
#include <taut/cli/messages.h>
#include <taut/cli/progress.h>
#include <taut/cli/solve/certify.h>
#include <taut/cli/solve/point_ends.h>
#include <taut/cli/world/snap_ends.h>
#include <taut/geometry/rounding.h>
#include <taut/io/pictures/arc_svg.h>
#include <taut/io/results/arc_json.h>
#include <taut/io/results/barrier_words.h>
#include <taut/search/query_ends.h>
#include <taut/search/verify_arcs.h>

namespace taut::cli {

namespace {

void require_places(const ArcAnswer& answer, const FreeSpace& space) {
  const DiscStatus status = answer.result.status;
  if (status != DiscStatus::start_blocked && status != DiscStatus::goal_blocked) return;
  const DiscPlaces places(space, answer.radius);
  require_free(places, answer.start, "start");
  require_free(places, answer.goal, "goal");
  throw std::logic_error("an end is no place for the disc, and yet it is");
}

class ArcSolver {
 public:
  ArcSolver(const SolveOptions& options, Run& run) : options_(options), run_(run) {}

  int solve() {
    run_.promise(options_.svg);
    promise(run_, options_.files);
    run_.promise(options_.certificate);
    const Input input = read_input(options_.world, options_.query, run_, {options_.query.robot.radius()});
    read_ends(input);
    const FreeSpace space = run_.stage("space", [&] { return triangulated(FreeSpace(input.world)); });
    if (rounding_bound(space) > 0) answer_.within = rounding_bound(space);
    const TangentGraph graph =
        run_.stage("roadmap", [&] { return TangentGraph(space, answer_.radius, shown_progress(options_.common)); });
    answer_.result = run_.stage("search", [&] { return arc_search(graph, answer_.start, answer_.goal); });
    require_places(answer_, space);
    const Gates gates = run_.stage("gates", [&] { return Gates(space); });
    found() ? finish(gates) : prove_none(gates);
    if (!options_.certificate.empty() && outcome_ != Outcome::unproven) certify(input.world);
    return end(input, space, graph);
  }

 private:
  bool found() const { return answer_.result.status == DiscStatus::found; }

  void read_ends(const Input& input) {
    const auto [start, goal] = point_ends(input, "--arcs");
    answer_.start = start;
    answer_.goal = goal;
    answer_.radius = options_.query.robot.radius();
    run_.so_far(arc_json(answer_));
  }

  void finish(const Gates& gates) {
    if (!options_.no_verify) {
      const ArcVerdict verdict =
          run_.stage("verify", [&] { return verify_arcs(answer_.result.path, gates, answer_.start, answer_.goal); });
      if (!verdict.valid) throw std::logic_error("the path found does not pass its own check: " + verdict.reason);
      answer_.verified = true;
    }
    answer_.pinch = narrowest_gate(gates, answer_.result.path);
  }

  /// The walls and gates that leave no way; where none do, nothing is proven.
  void prove_none(const Gates& gates) {
    const DiscPassage passage = disc_passage(gates, answer_.start, answer_.goal, answer_.radius);
    outcome_ = Outcome::unproven;
    reason_ = "no path found, but no walls and gaps that prove that there is none";
    if (passage.status == DiscStatus::found || passage.barrier.empty()) return;
    outcome_ = Outcome::none;
    answer_.barrier = barrier_of(gates, passage.barrier);
    reason_ = blocked_text(gates, passage, answer_.barrier, answer_.start, answer_.goal, answer_.radius);
  }

  // An answer without the proof that was asked for is unproven.
  void certify(const World& world) {
    certified_ = found()
                     ? certified(answer_.result.path, world, !options_.no_verify, run_)
                     : certified_narrow(world, answer_.start, answer_.goal, answer_.radius, !options_.no_verify, run_);
    if (!certified_.text.empty()) return;
    outcome_ = Outcome::unproven;
    reason_ = certified_.words;
  }

  std::string line() const {
    if (outcome_ == Outcome::none) return "no path: " + reason_;
    if (outcome_ == Outcome::unproven) return reason_;
    const ArcPath& path = answer_.result.path;
    const auto arcs = std::ranges::count_if(path.bends, [](const ArcBend& bend) { return bend.turn != 0; });
    return fmt::format("length {:.6f}, {}, {}", path.value(), count_text(static_cast<std::size_t>(arcs), "arc"),
                       cpu_text(run_.seconds()));
  }

  PathToWrite written_path() const {
    const ArcPath& path = answer_.result.path;
    const double tolerance = path.bends.empty() ? 0 : answer_.radius / 1000;
    return {.name = "arcs",
            .points = sampled(path, answer_.radius / 1000),
            .tolerance = tolerance,
            .arcs = pieces(path),
            .length = path.value()};
  }

  int end(const Input& input, const FreeSpace& space, const TangentGraph& graph) {
    Answer answer;
    answer.outcome = outcome_;
    answer.reason = reason_;
    answer.result = arc_json(answer_);
    answer.line = input.name + ": " + line() + "\n";
    if (options_.path && found()) answer.listing = path_listing(written_path());
    if (!certified_.text.empty()) answer.files.push_back({options_.certificate, certified_.text});
    if (found()) add_path_files(answer.files, options_.files, {written_path()});
    answer.stats = {{"roadmap", fmt::format("{} corners, {} tangent points, {} tangents, {} arcs", graph.corner_count(),
                                            graph.point_count(), graph.leg_count(), graph.arc_count())},
                    {"search", fmt::format("{} expanded", answer_.result.expanded)}};
    if (!options_.svg.empty())
      answer.files.push_back({options_.svg, arc_svg(answer_, space, title_of(input.name), input.moves)});
    return run_.end(std::move(answer));
  }

  const SolveOptions& options_;
  Run& run_;
  ArcAnswer answer_;
  Outcome outcome_ = Outcome::found;
  std::string reason_;
  Certified certified_;
};

}  // namespace

int solve_with_arcs(const SolveOptions& options, Run& run) { return ArcSolver(options, run).solve(); }

}  // namespace taut::cli
