#include <taut/cli/solve/alternatives.h>

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

#include <taut/cli/input.h>
#include <taut/cli/messages.h>
#include <taut/cli/solve/point_ends.h>
#include <taut/cli/world/snap_ends.h>
#include <taut/geometry/rounding.h>
#include <taut/io/pictures/alternatives_svg.h>
#include <taut/io/results/alternatives_json.h>
#include <taut/io/results/barrier_words.h>
#include <taut/io/results/words.h>
#include <taut/search/no_path.h>
#include <taut/search/query_ends.h>
#include <taut/search/verify.h>

namespace taut::cli {

namespace {

class Alternating {
 public:
  Alternating(const SolveOptions& options, Run& run) : options_(options), run_(run) {}

  int solve() {
    run_.promise(options_.svg);
    promise(run_, options_.files);
    const Input input = read_input(options_.world, options_.query, run_);
    read_ends(input);
    const FreeSpace space = run_.stage("space", [&] { return triangulated(FreeSpace(input.world)); });
    require_free(space, answer_.start, "start");
    require_free(space, answer_.goal, "goal");
    if (rounding_bound(space) > 0) answer_.within = rounding_bound(space);
    const Gates gates = run_.stage("gates", [&] { return Gates(space); });
    run_.stage("search", [&] { search(gates); });
    verify_all(space);
    return end(input, space);
  }

 private:
  static constexpr std::size_t kMostExpanded = 5'000'000;

  void read_ends(const Input& input) {
    const auto [start, goal] = point_ends(input, "--alternatives");
    answer_.start = start;
    answer_.goal = goal;
    answer_.asked = options_.alternatives;
    answer_.wider = options_.wider;
    run_.so_far(alternatives_json(answer_));
  }

  void search(const Gates& gates) {
    if (!options_.wider) {
      answer_.found =
          alternatives(gates, answer_.start, answer_.goal, {.count = answer_.asked, .most_expanded = kMostExpanded});
      return;
    }
    answer_.found.ways = wider_ways(gates, answer_.start, answer_.goal);
    answer_.found.all = true;
    if (!answer_.found.ways.empty()) answer_.found.status = SearchStatus::found;
  }

  void verify_all(const FreeSpace& space) {
    if (options_.no_verify) return;
    run_.stage("verify", [&] {
      for (const Alternative& way : answer_.found.ways) {
        const Verdict verdict = verify(way.path, space, answer_.start, Goal{answer_.goal, {}});
        if (!verdict.valid) throw std::logic_error("a path found does not pass its own check: " + verdict.reason);
      }
    });
    answer_.verified = true;
  }

  std::vector<PathToWrite> written_paths() const {
    std::vector<PathToWrite> paths;
    for (const Alternative& way : answer_.found.ways)
      paths.push_back({.name = fmt::format("alternative {}", paths.size() + 1),
                       .points = way.path.points,
                       .length = way.path.length.value()});
    return paths;
  }

  Answer answer_of(const FreeSpace& space) const {
    Answer answer;
    answer.outcome = Outcome::found;
    if (answer_.found.status == SearchStatus::none) {
      const auto walls = NoPath(space).walls(answer_.start, Goal{answer_.goal, {}});
      answer.outcome = walls ? Outcome::none : Outcome::unproven;
      answer.reason = !walls           ? "no path found, and no walls that prove that there is none"
                      : walls->empty() ? "no place beside an end is free"
                                       : "no path: " + separation_text({joined_walls(*walls, space.world().box()), {}});
    } else if (answer_.found.status == SearchStatus::stopped) {
      answer.outcome = Outcome::stopped;
      answer.reason = fmt::format("too many ways: stopped after {} steps", kMostExpanded);
    }
    return answer;
  }

  std::string line(const Answer& answer) const {
    std::string out = answer_.found.ways.empty() ? "" : alternatives_table(answer_.found);
    if (answer_.found.all && answer_.found.ways.size() < answer_.asked && !answer_.found.ways.empty())
      out += "there are no more\n";
    return out + answer.reason + (answer.reason.empty() ? "" : "\n");
  }

  int end(const Input& input, const FreeSpace& space) {
    Answer answer = answer_of(space);
    answer.result = alternatives_json(answer_);
    answer.line = (answer.reason.empty() ? "" : input.name + ": ") + line(answer);
    if (!answer_.found.ways.empty()) add_path_files(answer.files, options_.files, written_paths());
    answer.stats = {{"search", fmt::format("{} expanded", answer_.found.expanded)}};
    if (!options_.svg.empty())
      answer.files.push_back({options_.svg, alternatives_svg(answer_, space, title_of(input.name), input.moves)});
    return run_.end(std::move(answer));
  }

  const SolveOptions& options_;
  Run& run_;
  AlternativesAnswer answer_;
};

}  // namespace

int solve_alternatives(const SolveOptions& options, Run& run) { return Alternating(options, run).solve(); }

}  // namespace taut::cli
