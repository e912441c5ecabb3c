// Roadmaps as the command line names them.
#pragma once

#include <string>

#include <taut/cli/command_line.h>
#include <taut/search/roadmap_kinds.h>

namespace taut::cli {

/// `option` NAME, one of the kinds, each explained below the options in --help; anything else is a UsageError. `kind`
/// keeps its value when the option is not given. `standard` says which that is.
void add_roadmap_kind(CommandLine& app, const std::string& option, const RoadmapKind*& kind, const std::string& group,
                      const std::string& standard = "visibility");

/// Throws UsageError when roadmaps of that kind cannot be kept in files: what they hold besides legs is not in them.
void require_savable(const RoadmapKind& kind);

/// `reduced visibility graph`, `2 vertices`, `1 edge`; of a PRM `500 samples drawn, 430 kept` instead of vertices; of a
/// diagram also its arcs and how exact its vertices are.
std::vector<std::string> roadmap_facts(const RoadmapKind& kind, const PlannedRoadmap& planned);

}  // namespace taut::cli
