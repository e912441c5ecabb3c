// Roadmaps that are known by name, kept in files and loaded again.
#pragma once

#include <string>
#include <string_view>

#include <taut/search/roadmap_kinds.h>

namespace taut {

/// The file of a roadmap of that kind (roadmap_file). Precondition: the kind can be kept.
std::string saved_text(const RoadmapKind& kind, const PlannedRoadmap& planned, const FreeSpace& space);

struct LoadedRoadmap {
  const RoadmapKind* kind = nullptr;
  PlannedRoadmap planned;
};

/// Reads a file written from saved_text and says of which kind it is. Nothing in it is taken on trust (Keeping): what
/// is returned keeps the promises of its kind. `name` is the file's, for messages. Throws InputError that names the
/// line.
LoadedRoadmap load_roadmap(std::string_view bytes, const std::string& name, const FreeSpace& space);

}  // namespace taut
