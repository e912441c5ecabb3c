#include <taut/cli/solve/tradeoff.h>

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <utility>

#include <taut/cli/input.h>
#include <taut/cli/messages.h>
#include <taut/cli/solve/point_ends.h>
#include <taut/cli/world/snap_ends.h>
#include <taut/geometry/rounding.h>
#include <taut/io/pictures/tradeoff_svg.h>
#include <taut/io/results/barrier_words.h>
#include <taut/io/results/tradeoff_json.h>
#include <taut/search/query_ends.h>
#include <taut/search/verify_arcs.h>

namespace taut::cli {

namespace {

/// What has been found so far, for the thread that stops the program.
class Stretches {
 public:
  explicit Stretches(const Gates& gates) : gates_(gates) {}

  void add(const TradeoffStretch& stretch) {
    const std::lock_guard lock(mutex_);
    json_.push_back(stretch_json(stretch, found_.empty() ? 0 : found_.back().to, gates_));
    found_.push_back(stretch);
  }

  std::pair<Json, std::string> tell() {
    const std::unique_lock lock(mutex_, std::chrono::seconds(1));
    if (!lock.owns_lock()) return {};
    return {Json{{"query", "tradeoff"}, {"tradeoff", json_}, {"verified", false}},
            found_.empty() ? "" : tradeoff_table(found_, gates_)};
  }

 private:
  std::timed_mutex mutex_;
  Gates gates_;
  std::vector<TradeoffStretch> found_;
  Json json_ = Json::array();
};

class TradeoffSolver {
 public:
  TradeoffSolver(const SolveOptions& options, Run& run) : options_(options), run_(run) {}

  int solve() {
    run_.promise(options_.svg);
    run_.promise(options_.animation);
    promise(run_, options_.files);
    const Input input = read_input(options_.world, options_.query, run_);
    require_ends(input);
    const FreeSpace space = run_.stage("space", [&] { return triangulated(FreeSpace(input.world)); });
    const PassageIndex index = run_.stage("gates", [&] { return PassageIndex(space); });
    read_ends(index, input);
    if (rounding_bound(space) > 0) answer_.within = rounding_bound(space);
    const AllRadii radii = run_.stage("roadmap", [&] { return AllRadii(space); });
    search(radii, index);
    if (found())
      verify(index);
    else
      prove_none(index, radii.least_radius());
    return end(input, index);
  }

 private:
  bool found() const { return answer_.found.status == DiscStatus::found; }

  void read_ends(const PassageIndex& index, const Input& input) {
    answer_.start = *input.world.start();
    const std::vector<Point> goals = free_goals(index.gates().space(), input);
    const auto room = [&](Point goal) {
      const auto widest = index.widest(answer_.start, goal);
      return widest ? widest->radius : -1;
    };
    answer_.goal = *std::ranges::max_element(goals, {}, room);
  }

  void search(const AllRadii& radii, const PassageIndex& index) {
    const auto so_far = std::make_shared<Stretches>(index.gates());
    run_.when_stopped([so_far] { return so_far->tell(); });
    answer_.found = run_.stage("search", [&] {
      return radius_tradeoff(radii, index, answer_.start, answer_.goal,
                             {.told = [&](const TradeoffStretch& stretch) { so_far->add(stretch); }});
    });
    if (!found()) return;
    const TradeoffStretch& last = answer_.found.stretches.back();
    answer_.limit = limit_text(index.gates(), *answer_.found.widest, last.start, last.goal);
  }

  void verify(const PassageIndex& index) {
    if (options_.no_verify) return;
    run_.stage("verify", [&] {
      for (const TradeoffStretch& stretch : answer_.found.stretches)
        for (const double r : {stretch.from, stretch.to}) {
          const ArcVerdict verdict = verify_arcs(stretch.path(r), index.gates(), stretch.start, stretch.goal);
          if (!verdict.valid) throw std::logic_error("a way found does not pass its own check: " + verdict.reason);
        }
    });
    answer_.verified = true;
  }

  void prove_none(const PassageIndex& index, double least) {
    const Gates& gates = index.gates();
    const DiscPassage passage = disc_passage(gates, answer_.start, answer_.goal, least);
    outcome_ = Outcome::unproven;
    reason_ = "no way found, but no walls and gaps that prove that there is none";
    if (passage.status == DiscStatus::found || passage.barrier.empty()) return;
    outcome_ = Outcome::none;
    answer_.barrier = barrier_of(gates, passage.barrier);
    reason_ = blocked_text(gates, passage, answer_.barrier, answer_.start, answer_.goal, least);
  }

  PathToWrite written_path(const TradeoffStretch& stretch) const {
    const ArcPath path = stretch.path(stretch.to);
    PathToWrite written{.name = "radius up to " + number_text(stretch.to),
                        .points = {answer_.start},
                        .tolerance = path.bends.empty() ? 0 : path.radius / 1000,
                        .arcs = {},
                        .length = stretch.at_to.middle()};
    const auto add = [&](const ArcPath& part) {
      if (part.start == part.goal) return;
      const std::vector<Point> points = sampled(part, path.radius / 1000);
      written.points.insert(written.points.end(), points.begin() + 1, points.end());
      const std::vector<ArcPiece> all = pieces(part);
      written.arcs.insert(written.arcs.end(), all.begin(), all.end());
    };
    add({path.radius, answer_.start, stretch.start, {}, {}});
    add(path);
    add({path.radius, stretch.goal, answer_.goal, {}, {}});
    return written;
  }

  std::vector<PathToWrite> written_paths() const {
    std::vector<PathToWrite> paths;
    for (const TradeoffStretch& stretch : answer_.found.stretches) paths.push_back(written_path(stretch));
    return paths;
  }

  void draw(Answer& answer, const Input& input, const PassageIndex& index) const {
    if (!found()) return;
    for (const auto& [file, moves] : {std::pair(&options_.svg, false), std::pair(&options_.animation, true)})
      if (!file->empty())
        answer.files.push_back({*file, tradeoff_svg(answer_, index.gates().space(), index.gates(), title_of(input.name),
                                                    input.moves, moves)});
  }

  int end(const Input& input, const PassageIndex& index) {
    Answer answer;
    answer.outcome = outcome_;
    answer.reason = reason_;
    if (run_.wants_json()) answer.result = tradeoff_json(answer_, index.gates());
    answer.line =
        found() ? tradeoff_table(answer_.found.stretches, index.gates()) + "no larger disc: " + answer_.limit + "\n"
                : input.name + ": " + (outcome_ == Outcome::none ? "no path: " : "") + reason_ + "\n";
    if (found()) add_path_files(answer.files, options_.files, written_paths());
    answer.stats = {{"search", fmt::format("{} graphs", answer_.found.graphs)}};
    draw(answer, input, index);
    return run_.end(std::move(answer));
  }

  const SolveOptions& options_;
  Run& run_;
  TradeoffAnswer answer_;
  Outcome outcome_ = Outcome::found;
  std::string reason_;
};

}  // namespace

int solve_tradeoff(const SolveOptions& options, Run& run) { return TradeoffSolver(options, run).solve(); }

}  // namespace taut::cli
