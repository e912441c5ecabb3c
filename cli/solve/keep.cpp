#include <taut/cli/solve/keep.h>

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

#include <taut/cli/input.h>
#include <taut/cli/messages.h>
#include <taut/cli/solve/point_ends.h>
#include <taut/cli/world/snap_ends.h>
#include <taut/geometry/rounding.h>
#include <taut/io/pictures/kept_svg.h>
#include <taut/io/results/barrier_words.h>
#include <taut/io/results/kept_json.h>
#include <taut/search/query_ends.h>

namespace taut::cli {

namespace {

class KeepSolver {
 public:
  KeepSolver(const SolveOptions& options, Run& run) : options_(options), run_(run) {}

  int solve() {
    run_.promise(options_.svg);
    promise(run_, options_.files);
    const Input input = read_input(options_.world, options_.query, run_);
    read_ends(input);
    const FreeSpace space = run_.stage("space", [&] { return triangulated(FreeSpace(input.world)); });
    require_free(space, answer_.start, "start");
    require_free(space, answer_.goal, "goal");
    if (rounding_bound(space) > 0) answer_.within = rounding_bound(space);
    const PassageIndex index = run_.stage("gates", [&] { return PassageIndex(space); });
    answer_.path = run_.stage("search", [&] { return kept_path(index, answer_.start, answer_.goal, *options_.keep); });
    found() ? verify(index) : prove_none(space, index.gates());
    return end(input, space);
  }

 private:
  bool found() const { return answer_.path.status == KeptPath::Status::found; }

  void read_ends(const Input& input) {
    const auto [start, goal] = point_ends(input, "--keep");
    answer_.start = start;
    answer_.goal = goal;
    answer_.path.clearance = *options_.keep;
    run_.so_far(kept_json(answer_));
  }

  void verify(const PassageIndex& index) {
    if (options_.no_verify) return;
    const std::string fault =
        run_.stage("verify", [&] { return kept_path_fault(answer_.path, index, answer_.start, answer_.goal); });
    if (!fault.empty()) throw std::logic_error("the path found does not pass its own check: " + fault);
    answer_.verified = true;
  }

  /// Of the disc's places nearest to the ends: what separates them.
  void prove_none(const FreeSpace& space, const Gates& gates) {
    const double c = *options_.keep;
    outcome_ = Outcome::unproven;
    reason_ = fmt::format("no place found that keeps {} and that both ends lead to", number_text(c));
    const DiscPlaces places(space, c);
    const auto s = places.nearest(answer_.start), g = places.nearest(answer_.goal);
    if (!s || !g) return;
    const DiscPassage passage = disc_passage(gates, s->point, g->point, c);
    if (passage.status == DiscStatus::found || passage.barrier.empty()) return;
    outcome_ = Outcome::none;
    answer_.barrier = barrier_of(gates, passage.barrier);
    reason_ = blocked_text(gates, passage, answer_.barrier, s->point, g->point, c);
  }

  std::string line() const {
    if (outcome_ == Outcome::none) return "no path: " + reason_;
    if (outcome_ == Outcome::unproven) return reason_;
    const KeptPath& path = answer_.path;
    std::string text =
        fmt::format("length {:.6f} with clearance {}", path.length.middle(), number_text(path.clearance));
    const auto near = [&](std::size_t from, std::size_t to, const char* end) {
      double length = 0;
      for (std::size_t i = from; i < to; ++i) length += path.parts[i].value();
      const ArcPath& part = path.parts[from == 0 ? 0 : to - 1];
      text += fmt::format(", but for {} at the {} (from {})", plain_length(length), end, number_text(part.radius));
    };
    if (path.first > 0) near(0, path.first, "start");
    if (path.last < path.parts.size()) near(path.last, path.parts.size(), "goal");
    return text + ", " + cpu_text(run_.seconds());
  }

  PathToWrite written_path() const {
    PathToWrite written{.name = "keep", .points = {answer_.start}, .length = answer_.path.length.middle()};
    for (const ArcPath& part : answer_.path.parts) {
      const std::vector<ArcPiece> all = pieces(part);
      written.arcs.insert(written.arcs.end(), all.begin(), all.end());
      if (!part.bends.empty()) written.tolerance = answer_.path.clearance / 1000;
      const std::vector<Point> points =
          part.bends.empty() ? std::vector<Point>{part.start, part.goal} : sampled(part, part.radius / 1000);
      written.points.insert(written.points.end(), points.begin() + 1, points.end());
    }
    return written;
  }

  int end(const Input& input, const FreeSpace& space) {
    Answer answer;
    answer.outcome = outcome_;
    answer.reason = reason_;
    answer.result = kept_json(answer_);
    answer.line = input.name + ": " + line() + "\n";
    if (options_.path && found()) answer.listing = path_listing(written_path());
    if (found()) add_path_files(answer.files, options_.files, {written_path()});
    if (!options_.svg.empty())
      answer.files.push_back({options_.svg, kept_svg(answer_, space, title_of(input.name), input.moves)});
    return run_.end(std::move(answer));
  }

  const SolveOptions& options_;
  Run& run_;
  KeptAnswer answer_;
  Outcome outcome_ = Outcome::found;
  std::string reason_;
};

}  // namespace

int solve_keeping(const SolveOptions& options, Run& run) { return KeepSolver(options, run).solve(); }

}  // namespace taut::cli
