#include <taut/cli/solve/prm_options.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <taut/cli/options.h>
#include <taut/io/results/words.h>

namespace taut::cli {

namespace {

const std::vector<Choice> kSamplers{
    {"uniform", "anywhere"},
    {"lattice", "the cell centres of a grid maze, else whole numbers"},
    {"gaussian", "near what is in the way"},
    {"bridge", "between two things in the way: passages"},
    {"medial-axis", "anywhere, then pushed to the middle between walls"},
    {"corners", "every other one near a corner that a path can bend around"},
    {"sobol", "anywhere, spread evenly (default)"},
};

const std::vector<Choice> kRules{
    {"nearest:K", "each and its K nearest"},
    {"visible:K", "each and the K nearest that it sees (default, K = 8)"},
    {"forest:K", "as nearest:K, but only what does not hang together yet"},
    {"radius:R", "each and all within R"},
    {"prm-star", "nearest, with K growing as the logarithm of their number"},
};

PrmSampler sampler_of(const std::string& text) {
  const auto at = std::ranges::find(kSamplers, std::string_view(text), &Choice::first);
  if (at == kSamplers.end()) throw not_one_of(text, kSamplers);
  return static_cast<PrmSampler>(at - kSamplers.begin());  // in the order of the enumeration
}

[[noreturn]] void refuse_connection(const std::string& text) {
  throw UsageError("--connection: '" + text +
                   "' is not nearest:K, visible:K, forest:K (K from 1 to 1000), radius:R (R > 0) or prm-star");
}

PrmConnection connection_of(const std::string& text) {
  using Rule = PrmConnection::Rule;
  if (text == "prm-star") return {Rule::star};
  const std::size_t colon = text.find(':');
  if (colon == std::string::npos) refuse_connection(text);
  const std::string rule = text.substr(0, colon);
  double number = 0;
  try {
    number = number_of(text.substr(colon + 1));
  } catch (const UsageError&) {
    refuse_connection(text);
  }
  if (rule == "radius" && number > 0) return {Rule::radius, 8, number};
  const bool is_known = rule == "nearest" || rule == "visible" || rule == "forest";
  if (!is_known || number != std::floor(number) || number < 1 || number > 1000) refuse_connection(text);
  return {rule == "nearest"   ? Rule::nearest
          : rule == "visible" ? Rule::visible
                              : Rule::forest,
          static_cast<std::size_t>(number)};
}

double clearance_of(const std::string& text) {
  const double clearance = number_of(text, "--prm-clearance");
  if (clearance < 0) throw UsageError("--prm-clearance: '" + text + "' is not a distance of 0 or more");
  return clearance;
}

}  // namespace

std::string first_option(const PrmRequest& request) {
  return request.sampler      ? "--sampler"
         : request.connection ? "--connection"
         : request.clearance  ? "--prm-clearance"
         : request.samples    ? "--samples"
         : request.lazy       ? (*request.lazy ? "--lazy" : "--eager")
         : request.exactly    ? "--exactly"
                              : "";
}

void add_prm_options(CommandLine& app, PrmRequest& request, bool with_query) {
  static constexpr const char* kGroup = "Probabilistic roadmaps (prm, prm-lattice)";
  app.add_option_function(
         "--sampler", [&request](const std::string& text) { request.sampler = sampler_of(text); },
         "Where milestones come from, see below")
      .type_name("NAME")
      .group(kGroup);
  app.add_option_function(
         "--connection", [&request](const std::string& text) { request.connection = connection_of(text); },
         "Which milestones are joined when a path can go straight, see below")
      .type_name("RULE")
      .group(kGroup);
  app.add_option_function(
         "--prm-clearance", [&request](const std::string& text) { request.clearance = clearance_of(text); },
         "How far milestones and edges stay away from walls (default: 0)")
      .type_name("C")
      .group(kGroup);
  app.add_option_function(
         "--samples", [&request](const std::string& text) { request.samples = count_of(text); },
         "How many samples are drawn at most until start and goal are joined; with no start and goal exactly so many")
      .type_name("N")
      .range(1, 100'000'000)
      .group(kGroup);
  app.explain("Samplers of --sampler", kSamplers);
  app.explain("Rules of --connection", kRules);
  if (!with_query) return;
  app.add_flag_callback(
         "--lazy", [&request] { request.lazy = true; }, "Test an edge only when a candidate path uses it")
      .group(kGroup);
  app.add_flag_callback(
         "--eager", [&request] { request.lazy = false; }, "Test all edges at once (default)")
      .group(kGroup)
      .excludes("--lazy");
  app.add_flag("--exactly", request.exactly, "Draw all of --samples, though start and goal are joined earlier")
      .group(kGroup);
}

void require_prm_options_fit(const PrmRequest& request, const RoadmapKind& kind) {
  if (first_option(request).empty()) return;
  if (request.exactly && !request.samples) throw UsageError("--exactly needs --samples: how many?");
  if (!kind.is_prm)
    throw UsageError(fmt::format("{} makes no sense with the roadmap {}: it is for prm and prm-lattice",
                                 first_option(request), kind.name));
  if (request.sampler && std::string(kind.name) == "prm-lattice" && request.sampler != PrmSampler::lattice)
    throw UsageError("--sampler makes no sense with the roadmap prm-lattice: its vertices are a lattice");
  if (request.lazy.value_or(false) && request.connection &&
      (request.connection->rule == PrmConnection::Rule::visible ||
       request.connection->rule == PrmConnection::Rule::forest))
    throw UsageError(
        "--lazy makes no sense with --connection visible:K or forest:K, which have to test edges as they go");
}

std::string connectivity_text(const PrmConnectivity& c) {
  return fmt::format("{} samples, {} vertices, {} edges of {} tested, {}, {} vertices at the start, {} at the goal",
                     c.counts.drawn, c.counts.kept, c.counts.edges, c.counts.edges_tested,
                     count_text(c.counts.components, "component"), c.start_part, c.goal_part);
}

}  // namespace taut::cli
