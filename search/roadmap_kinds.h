// The roadmaps that are known by name. A further one is one more row in roadmap_kinds.cpp.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include <taut/geometry/free_space.h>
#include <taut/geometry/progress.h>
#include <taut/roadmaps/roadmap.h>
#include <taut/roadmaps/visibility_rows.h>
#include <taut/roadmaps/voronoi.h>
#include <taut/search/graph_search.h>
#include <taut/search/prm_request.h>

namespace taut {

/// A finished roadmap, and how it answers: from a start to a goal.
struct PlannedRoadmap {
  std::shared_ptr<const Roadmap> roadmap;  ///< empty where there is no graph
  std::function<GraphSearchResult(Point, const Goal&, GraphMethod)> search;
  std::function<GraphQuery(Point, const Goal&)> query{};  ///< what `search` asks; empty where that is no graph search
  std::string how{};                                      ///< the settings it was built with, for saved files
  std::shared_ptr<const VoronoiRoadmap> diagram{};        ///< when `roadmap` only stands for it
  std::optional<PrmConnectivity> prm{};                   ///< of a PRM that was grown for a query
  std::optional<PrmCounts> counts{};                      ///< of any PRM that was not loaded
};

/// What a builder may want to know besides the space.
struct BuildRequest {
  std::uint64_t seed = 1;
  /// The ends of the first query, for builders that grow until it is solved; may be absent
  std::optional<Point> from{};
  Goal to{};
  PrmRequest prm{};
  bool is_limited = false;  ///< somebody else ends it in time: a PRM need not give up by itself
  TellProgress tell{};
  unsigned jobs = 1;  ///< threads that visibility graphs and diagrams may take
};

struct RoadmapKind {
  /// In files, and how one that is loaded is judged.
  enum class Keeping {
    none,     ///< vertices and edges are not all there is to it
    rebuilt,  ///< it is what the world gives, nothing else: built anew and compared, vertex for vertex, edge for edge
    as_prm,   ///< any roadmap whose vertices are clear and whose edges are free (verify_roadmap)
  };

  const char* name;   ///< on the command line and in files, one word
  const char* title;  ///< `reduced visibility graph`
  const char* what;   ///< a line for those who choose
  bool optimal;       ///< are its paths the shortest in the plane?
  bool random;        ///< does another seed give another roadmap?
  /// Throws InputError where the world does not suit it.
  std::function<PlannedRoadmap(const FreeSpace&, const BuildRequest&)> build;
  Keeping keeping = Keeping::none;
  bool is_prm = false;   ///< heeds BuildRequest::prm
  bool graph = true;     ///< does it make a graph at all, to be shown and saved?
  bool samples = false;  ///< are its vertices milestones, some of them perhaps joined to nothing?
  /// Its edges can be found one by one (VisibilityRows), without keeping them
  std::optional<VisibilityKind> rows{};
};

/// Legs that stand for an arc leave it by at most this part of the mean width of a corridor.
inline constexpr double kArcTolerance = 1.0 / 512;

std::span<const RoadmapKind> roadmap_kinds();

/// `visibility, cells, ...`
std::string roadmap_kind_names();

/// nullptr when there is none of that name.
const RoadmapKind* roadmap_kind(const std::string& name);

/// A PRM that came from elsewhere, say from a file, ready to be asked; ends are joined with that clearance.
PlannedRoadmap planned_prm(const FreeSpace& space, const std::shared_ptr<const Roadmap>& roadmap, double clearance = 0);

}  // namespace taut
