#include <taut/cli/solve/anytime.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <taut/cli/options.h>
#include <taut/io/results/words.h>

namespace taut::cli {

namespace {

double epsilon_of(const std::string& text) {
  const double epsilon = number_of(text, "--epsilon");
  if (!(epsilon >= 1 && epsilon <= AnytimeSearch::kLargestEpsilon))
    throw UsageError("--epsilon: '" + text + "' is not a factor from 1 to 1000000");
  return epsilon;
}

}  // namespace

void add_anytime_options(CommandLine& app, AnytimeOptions& options) {
  app.add_flag("--anytime", options.wanted,
               "A path soon, then better ones, until it is the shortest or --max-seconds end; says how far from the "
               "shortest it can be at most (ARA*)")
      .group("Query");
  app.add_option_function(
         "--epsilon", [&options](const std::string& text) { options.epsilon = epsilon_of(text); },
         "With --anytime: the first path is at most so many times as long as the shortest (default: 3)")
      .type_name("E")
      .group("Query");
}

void require_anytime_fits(const AnytimeOptions& options, const RoadmapKind* kind, bool method_given) {
  if (options.epsilon && !options.wanted) throw UsageError("--epsilon makes no sense without --anytime");
  if (!options.wanted) return;
  if (method_given)
    throw UsageError("--anytime makes no sense with --algorithm or --heuristic: it has a search of its own");
  if (kind && (!kind->graph || kind == roadmap_kind("voronoi")))
    throw UsageError(
        fmt::format("--anytime makes no sense with the roadmap {}, which is no graph of "
                    "straight legs",
                    kind->name));
}

double seconds_for_search(double most, double spent) {
  const double left = std::max(0.0, most - spent);
  return left - std::min(left / 2, std::max(0.02, most / 10));
}

std::string improvement_text(const AnytimeImprovement& stage) {
  return fmt::format("epsilon {:.4g}: length {}, bound {}, {} expanded, {}", stage.epsilon, length_text(stage.length),
                     bound_text(stage.bound), stage.expanded, seconds_text(stage.seconds));
}

std::string bound_text(double bound) {
  if (!(bound < 1e9)) return "none";
  const double up = std::ceil((bound - 1) * 1e4);
  const auto text = [](double count) { return fmt::format("{:.6g}", 1 + count / 1e4); };
  return std::stod(text(up)) >= bound ? text(up) : text(up + 1);
}

}  // namespace taut::cli
