#include <taut/cli/command_line.h>
#include <taut/cli/solve/prm_options.h>

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include <taut/cli/messages.h>
#include <taut/cli/options.h>
#include <taut/cli/report.h>
#include <taut/cli/solve/roadmap_kinds.h>

namespace taut::cli {

namespace {

constexpr double kSecondsWhenNothingIsSaid = 60, kSecondsBeforeProgress = 0.3;

PrmSampler sampler_of(const std::string& text) {
  static constexpr std::pair<const char*, PrmSampler> kNames[] = {
      {"uniform", PrmSampler::uniform}, {"lattice", PrmSampler::lattice},    {"gaussian", PrmSampler::gaussian},
      {"bridge", PrmSampler::bridge},   {"medial-axis", PrmSampler::medial}, {"corners", PrmSampler::corners}};
  for (const auto& [name, sampler] : kNames)
    if (text == name) return sampler;
  throw UsageError("--sampler: '" + text + "' is not one of uniform, lattice, gaussian, bridge, medial-axis, corners");
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

std::string PrmRequest::first() const {
  return sampler      ? "--sampler"
         : connection ? "--connection"
         : clearance  ? "--prm-clearance"
         : samples    ? "--samples"
         : lazy       ? "--lazy"
         : eager      ? "--eager"
                      : "";
}

void add_prm_options(CommandLine& app, PrmRequest& request, bool with_query) {
  static constexpr const char* kGroup = "Probabilistic roadmaps (prm, prm-lattice)";
  app.add_option_function(
         "--sampler", [&request](const std::string& text) { request.sampler = sampler_of(text); },
         "Where vertices come from: uniform, lattice, gaussian, bridge, medial-axis, corners")
      .type_name("NAME")
      .group(kGroup);
  app.add_option_function(
         "--connection", [&request](const std::string& text) { request.connection = connection_of(text); },
         "Which vertices are joined when a path can go straight: nearest:K, visible:K (default, K = 8), forest:K, "
         "radius:R, "
         "prm-star")
      .type_name("RULE")
      .group(kGroup);
  app.add_option_function(
         "--prm-clearance", [&request](const std::string& text) { request.clearance = clearance_of(text); },
         "How far vertices and edges stay away from walls (default: 0)")
      .type_name("C")
      .group(kGroup);
  app.add_option_function(
         "--samples", [&request](const std::string& text) { request.samples = count_of(text); },
         "How many samples are drawn at most until start and goal are joined; with no start and goal exactly so many")
      .type_name("N")
      .range(1, 100'000'000)
      .group(kGroup);
  if (!with_query) return;
  app.add_flag("--lazy", request.lazy, "Test an edge only when a candidate path uses it").group(kGroup);
  app.add_flag("--eager", request.eager, "Test all edges at once (default)").group(kGroup).excludes("--lazy");
}

void require_prm_options_fit(const PrmRequest& request, const RoadmapKind& kind) {
  if (request.first().empty()) return;
  if (!kind.is_prm)
    throw UsageError(fmt::format("{} makes no sense with the roadmap {}: it is for prm and prm-lattice",
                                 request.first(), kind.name));
  if (request.sampler && std::string(kind.name) == "prm-lattice" && request.sampler != PrmSampler::lattice)
    throw UsageError("--sampler makes no sense with the roadmap prm-lattice: its vertices are a lattice");
  if (request.lazy && request.connection &&
      (request.connection->rule == PrmConnection::Rule::visible ||
       request.connection->rule == PrmConnection::Rule::forest))
    throw UsageError(
        "--lazy makes no sense with --connection visible:K or forest:K, which have to test edges as they go");
}

PrmPlan plan_of(const PrmRequest& request, PrmSampler sampler, std::uint64_t seed, bool is_limited) {
  PrmPlan plan;
  plan.roadmap.sampler = request.sampler.value_or(sampler);
  plan.roadmap.samples = request.samples;
  plan.roadmap.seed = seed;
  plan.roadmap.clearance = request.clearance.value_or(0);
  plan.roadmap.connection.rule = request.lazy ? PrmConnection::Rule::nearest : PrmConnection::Rule::visible;
  if (request.connection) plan.roadmap.connection = *request.connection;
  plan.lazy = request.lazy;
  if (!is_limited && !request.samples) plan.seconds = kSecondsWhenNothingIsSaid;
  return plan;
}

std::function<bool(const PrmProgress&)> prm_progress(bool quiet) {
  if (quiet || !is_progress_shown()) return {};
  return [](const PrmProgress& p) {
    if (p.seconds > kSecondsBeforeProgress)
      progress(fmt::format("{} samples, {} edges, {} components, {}", p.counts.drawn, p.counts.edges,
                           p.counts.components, seconds_text(p.seconds)));
    return true;
  };
}

std::string connectivity_text(const PrmConnectivity& c) {
  return fmt::format("{} samples, {} vertices, {} edges of {} tested, {}, {} vertices at the start, {} at the goal",
                     c.counts.drawn, c.counts.kept, c.counts.edges, c.counts.edges_tested,
                     count_text(c.counts.components, "component"), c.start_part, c.goal_part);
}

}  // namespace taut::cli
