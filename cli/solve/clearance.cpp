#include <taut/cli/solve/clearance.h>

#include <fmt/format.h>

#include <optional>
#include <utility>

#include <taut/cli/input.h>
#include <taut/cli/messages.h>
#include <taut/cli/progress.h>
#include <taut/cli/solve/certify.h>
#include <taut/cli/solve/point_ends.h>
#include <taut/cli/world/snap_ends.h>
#include <taut/geometry/walled_world.h>
#include <taut/io/pictures/clearance_svg.h>
#include <taut/io/results/barrier_words.h>
#include <taut/io/results/clearance_json.h>
#include <taut/search/query_ends.h>

namespace taut::cli {

namespace {

using Kind = ClearanceQuery::Kind;

constexpr const char* kAlong = "along the Voronoi diagram";

std::string at_least_text(const ClearanceAnswer& answer, const FreeSpace& walled) {
  const ClearancePath& way = answer.found.front().path;
  return fmt::format("length {} {} (the shortest there, not in the plane) with clearance >= {}; {}",
                     plain_length(way.length), kAlong, number_text(answer.query.clearance),
                     pinch_text(way.pinch, walled));
}

std::string widest_text(const ClearanceAnswer& answer, const FreeSpace& walled) {
  const ClearancePath& way = answer.found.front().path;
  return fmt::format("the largest disc that gets through has radius {}; {}; its way has length {} {}",
                     number_text(way.pinch.clearance), pinch_text(way.pinch, walled, answer.width.value_or("")),
                     plain_length(way.length), kAlong);
}

class ClearanceSolver {
 public:
  ClearanceSolver(const SolveOptions& options, Run& run) : options_(options), run_(run) {}

  int solve() {
    run_.promise(options_.svg);
    run_.promise(options_.certificate);
    promise(run_, options_.files);
    const double clearance = options_.clearance->clearance;  // 0 unless asked for
    const Input input = read_input(options_.world, options_.query, run_, {clearance, true});
    require_ends(input);
    const FreeSpace space = run_.stage("space", [&] { return triangulated(FreeSpace(input.world)); });
    read_ends(space, input);
    const FreeSpace walled =
        run_.stage("space", [&] { return triangulated(FreeSpace(walled_world(input.world, all_ends()))); });
    VoronoiRoadmap map =
        run_.stage("roadmap", [&] { return VoronoiRoadmap(walled, 1, shown_progress(options_.common)); });
    Gates gates = run_.stage("gates", [&] { return Gates(walled); });
    const ClearancePlanner planner(space, std::move(map), std::move(gates), start_, goals_);
    search(planner);
    if (answer_.status == SearchStatus::found && !options_.no_verify)
      run_.stage("verify", [&] { planner.verify(answer_); });
    return end(input, space, planner);
  }

 private:
  void read_ends(const FreeSpace& space, const Input& input) {
    start_ = *input.world.start();
    goals_ = free_goals(space, input);
  }

  std::vector<Point> all_ends() const {
    std::vector<Point> ends = goals_;
    ends.push_back(start_);
    return ends;
  }

  void search(const ClearancePlanner& planner) {
    answer_ = run_.stage("search", [&] { return planner.answer(*options_.clearance); });
  }

  Outcome outcome() const {
    return answer_.status == SearchStatus::found  ? Outcome::found
           : answer_.status == SearchStatus::none ? Outcome::none
                                                  : Outcome::unproven;
  }

  std::string line(const std::string& reason, const FreeSpace& walled) const {
    if (outcome() == Outcome::unproven) return reason;
    if (outcome() == Outcome::none) return none_text(answer_.query) + ": " + reason;
    return (answer_.query.kind == Kind::widest ? widest_text(answer_, walled) : at_least_text(answer_, walled)) + ", " +
           cpu_text(run_.seconds());
  }

  std::vector<std::pair<std::string, std::string>> stats(const Input& input, const ClearancePlanner& planner) const {
    return {
        {"read", count_text(input.world.walls().size(), "wall")},
        {"roadmap", fmt::format("{}, {}, vertices within {:.2g}", count_text(answer_.places[0], "vertex", "vertices"),
                                count_text(answer_.places[1], "edge"), answer_.max_error)},
        {"gates", count_text(planner.gates().gates().size(), "gate")},
        {"verify", answer_.verified ? "walls and gates agree" : "not done"}};
  }

  std::vector<PathToWrite> written_paths(const ClearancePlanner& planner) const {
    std::vector<PathToWrite> paths;
    for (const ClearanceTrade& way : answer_.found)
      paths.push_back({.name = "voronoi, radius up to " + number_text(way.clearance),
                       .points = planner.points_of(way.path),
                       .tolerance = planner.tolerance(),
                       .length = way.path.length});
    return paths;
  }

  // An answer without the proof that was asked for is unproven.
  void certify(Answer& answer, const ClearancePlanner& planner) {
    if (options_.certificate.empty() || answer.outcome == Outcome::unproven) return;
    Certified proof{"", "no certificate: there is no path, which `taut solve --certificate` proves without --widest",
                    0};
    if (answer.outcome == Outcome::found) proof = certified(answer_, planner.gates(), !options_.no_verify, run_);
    if (!proof.text.empty()) return answer.files.push_back({options_.certificate, std::move(proof.text)});
    answer.outcome = Outcome::unproven;
    answer.reason = proof.words;
  }

  int end(const Input& input, const FreeSpace& space, const ClearancePlanner& planner) {
    Answer answer;
    answer.outcome = outcome();
    answer.reason = clearance_reason(answer_, planner.gates());
    certify(answer, planner);
    if (run_.wants_json()) answer.result = clearance_json(answer_, planner.walled());
    answer.line = input.name + ": " + line(answer.reason, planner.walled()) + "\n";
    if (answer.outcome == Outcome::unproven) answer.line = input.name + ": " + answer.reason + "\n";
    if (options_.path && outcome() == Outcome::found) answer.listing = path_listing(written_paths(planner).front());
    if (outcome() == Outcome::found) add_path_files(answer.files, options_.files, written_paths(planner));
    answer.stats = stats(input, planner);
    if (!options_.svg.empty())
      answer.files.push_back(
          {options_.svg, clearance_svg(answer_, space, planner.map(), title_of(input.name), input.moves)});
    return run_.end(std::move(answer));
  }

  const SolveOptions& options_;
  Run& run_;
  Point start_;
  std::vector<Point> goals_;
  ClearanceAnswer answer_;
};

}  // namespace

int solve_with_clearance(const SolveOptions& options, Run& run) { return ClearanceSolver(options, run).solve(); }

}  // namespace taut::cli
