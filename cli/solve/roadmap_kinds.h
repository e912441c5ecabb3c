// The roadmaps that --kind, --roadmap and `taut compare` know by name. A further one is one more row in
// roadmap_kinds.cpp.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include <taut/cli/command_line.h>
#include <taut/cli/solve/prm_options.h>
#include <taut/geometry/free_space.h>
#include <taut/roadmaps/roadmap.h>
#include <taut/roadmaps/voronoi.h>
#include <taut/search/graph_search.h>

namespace taut::cli {

/// A finished roadmap, and how it answers: from a start to a goal.
struct PlannedRoadmap {
  std::shared_ptr<const Roadmap> roadmap;  ///< empty where there is no graph
  std::function<GraphSearchResult(Point, const Goal&, GraphMethod)> search;
  std::function<GraphQuery(Point, const Goal&)> query{};  ///< what `search` asks; empty where that is no graph search
  std::string how{};                                      ///< the settings it was built with, for saved files
  std::shared_ptr<const VoronoiRoadmap> diagram{};        ///< when `roadmap` only stands for it
  std::optional<PrmConnectivity> prm{};                   ///< of a PRM that was grown for a query
};

/// What a builder may want to know besides the space.
struct BuildRequest {
  std::uint64_t seed = 1;
  /// The ends of the first query, for builders that grow until it is solved; may be absent
  std::optional<Point> from{};
  Goal to{};
  PrmRequest prm{};
  bool is_limited = false;  ///< there is --max-seconds
  std::function<bool(const PrmProgress&)> progress{};
};

struct RoadmapKind {
  /// In files, and how one that is loaded is judged.
  enum class Keeping {
    none,     ///< vertices and edges are not all there is to it
    rebuilt,  ///< it is what the world gives, nothing else: built anew and compared, vertex for vertex, edge for edge
    as_prm,   ///< any roadmap whose vertices are clear and whose edges are free (fault_of)
  };

  const char* name;   ///< on the command line and in files, one word
  const char* title;  ///< `reduced visibility graph`
  bool optimal;       ///< are its paths the shortest in the plane?
  bool random;        ///< does another seed give another roadmap?
  /// Throws InputError where the world does not suit it.
  std::function<PlannedRoadmap(const FreeSpace&, const BuildRequest&)> build;
  Keeping keeping = Keeping::none;
  bool is_prm = false;  ///< heeds BuildRequest::prm
  bool graph = true;    ///< does it make a graph at all, to be shown and saved?
};

/// Legs that stand for an arc leave it by at most this part of the mean width of a corridor.
inline constexpr double kArcTolerance = 1.0 / 512;

std::span<const RoadmapKind> roadmap_kinds();

/// `visibility, cells, ...`
std::string roadmap_kind_names();

/// nullptr when there is none of that name.
const RoadmapKind* roadmap_kind(const std::string& name);

/// --OPTION NAME, one of the kinds; anything else is a UsageError. `kind` keeps its value when the option is
/// not given. `standard` is the name of that one, for --help.
void add_roadmap_kind(CommandLine& app, const std::string& option, const RoadmapKind*& kind, const std::string& group,
                      const std::string& standard = "visibility");

/// Throws UsageError when roadmaps of that kind cannot be kept in files: what they hold besides legs is not
/// in them.
void require_savable(const RoadmapKind& kind);

/// The file of a roadmap of that kind (roadmap_file).
std::string saved_text(const RoadmapKind& kind, const PlannedRoadmap& planned, const FreeSpace& space);

/// Reads a file written from saved_text and says of which kind it is. Nothing in it is taken on trust (Keeping): what
/// is returned keeps the promises of its kind. Throws InputError that names the line.
PlannedRoadmap load_roadmap(const std::string& file, const FreeSpace& space, const RoadmapKind*& kind);

}  // namespace taut::cli
