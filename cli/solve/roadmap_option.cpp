#include <taut/cli/solve/roadmap_option.h>

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include <taut/cli/options.h>
#include <taut/io/results/words.h>

namespace taut::cli {

namespace {

constexpr std::string_view kOldFixed = "prm-homework";

std::vector<Choice> choices() {
  std::vector<Choice> choices;
  for (const RoadmapKind& kind : roadmap_kinds()) choices.emplace_back(kind.name, kind.what);
  return choices;
}

const RoadmapKind* kind_of(const std::string& text) {
  if (text == kOldFixed) throw UsageError("'" + text + "' is called prm-fixed now");
  const RoadmapKind* named = roadmap_kind(text);
  if (!named) throw not_one_of(text, choices());
  return named;
}

void add_diagram(std::vector<std::string>& facts, const VoronoiRoadmap& map) {
  const auto arcs = std::ranges::count(map.edges(), VoronoiEdge::Kind::parabola, &VoronoiEdge::kind);
  facts.push_back(count_text(map.vertices().size(), "vertex", "vertices"));
  facts.push_back(count_text(map.edges().size(), "edge"));
  facts.push_back(count_text(static_cast<std::size_t>(arcs), "arc"));
  facts.push_back(fmt::format("vertices within {:.2g}", map.max_error()));
}

}  // namespace

void add_roadmap_kind(CommandLine& app, const std::string& option, const RoadmapKind*& kind, const std::string& group,
                      const std::string& standard) {
  app.add_option_function(
         option, [&kind](const std::string& text) { kind = kind_of(text); },
         "Which roadmap, see below (default: " + standard + ")")
      .type_name("NAME")
      .group(group);
  app.explain("Roadmaps of " + option, choices());
}

void require_savable(const RoadmapKind& kind) {
  if (kind.keeping == RoadmapKind::Keeping::none)
    throw UsageError(std::string("--save: a roadmap of the kind '") + kind.name +
                     "' cannot be kept in a file; it is built anew each time");
}

std::vector<std::string> roadmap_facts(const RoadmapKind& kind, const PlannedRoadmap& planned) {
  std::vector<std::string> facts{kind.title};
  if (planned.diagram) {
    add_diagram(facts, *planned.diagram);
    return facts;
  }
  if (planned.counts)
    facts.push_back(
        fmt::format("{} drawn, {} kept", count_text(planned.counts->drawn, "sample"), planned.counts->kept));
  else
    facts.push_back(count_text(planned.roadmap->vertex_count(), "vertex", "vertices"));
  facts.push_back(count_text(planned.roadmap->edge_count(), "edge"));
  return facts;
}

}  // namespace taut::cli
