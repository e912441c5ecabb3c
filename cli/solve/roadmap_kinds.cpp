#include <taut/cli/command_line.h>
#include <taut/cli/solve/roadmap_kinds.h>
#include <taut/geometry/corridor_width.h>

#include <utility>

#include <taut/io/saved/roadmap_file.h>
#include <taut/io/worlds/read_world.h>
#include <taut/roadmaps/cell_graph.h>
#include <taut/roadmaps/roadmap_check.h>
#include <taut/roadmaps/visibility_graph.h>
#include <taut/roadmaps/voronoi_legs.h>
#include <taut/search/cell_search.h>
#include <taut/search/polyanya.h>
#include <taut/search/prm_planner.h>
#include <taut/search/shortest_path.h>
#include <taut/search/voronoi_search.h>

namespace taut::cli {

namespace {

/// `search` is shortest_path, cell_search, ...: what asks this graph.
template <typename Graph, typename Search, typename Query>
PlannedRoadmap planned(std::shared_ptr<const Graph> graph, Search search, Query query) {
  return {std::shared_ptr<const Roadmap>(graph, &graph->roadmap()),
          [graph, search](Point from, const Goal& to, GraphMethod method) { return search(*graph, from, to, method); },
          [graph, query](Point from, const Goal& to) { return query(*graph, from, to); }};
}

GraphSearchResult search_visibility(const VisibilityGraph& graph, Point from, const Goal& to, GraphMethod method) {
  return shortest_path(graph, from, to, method);
}

GraphSearchResult search_cells(const CellGraph& graph, Point from, const Goal& to, GraphMethod method) {
  return cell_search(graph, from, to, method);
}

RoadmapKind visibility(const char* name, const char* title, VisibilityKind kind) {
  return {name,
          title,
          true,
          false,
          [kind](const FreeSpace& space, const BuildRequest&) {
            return planned(std::make_shared<const VisibilityGraph>(space, kind), search_visibility, visibility_query);
          },
          RoadmapKind::Keeping::rebuilt};
}

RoadmapKind cells(const char* name, const char* title, CellNeighbours neighbours) {
  return {name,
          title,
          false,
          false,
          [neighbours](const FreeSpace& space, const BuildRequest&) {
            return planned(std::make_shared<const CellGraph>(space, neighbours), search_cells, cell_query);
          },
          RoadmapKind::Keeping::rebuilt};
}

PlannedRoadmap planned_prm(const FreeSpace& space, std::shared_ptr<const Roadmap> roadmap, double clearance) {
  return {roadmap,
          [space, roadmap, clearance](Point from, const Goal& to, GraphMethod method) {
            return graph_search(*roadmap, prm_query(space, *roadmap, from, to, clearance), method);
          },
          [space, roadmap, clearance](Point from, const Goal& to) {
            return prm_query(space, *roadmap, from, to, clearance);
          }};
}

std::shared_ptr<const Roadmap> prm_alone(const FreeSpace& space, const PrmOptions& options) {
  return std::make_shared<const Roadmap>(prm(space, options));
}

/// A PRM that grows until it joins the ends, when they are known.
RoadmapKind growing_prm(const char* name, const char* title, PrmSampler sampler, bool random) {
  return {name,
          title,
          false,
          random,
          [sampler](const FreeSpace& space, const BuildRequest& request) {
            PrmPlan plan = plan_of(request.prm, sampler, request.seed, request.is_limited);
            plan.progress = request.progress;
            const double clearance = plan.roadmap.clearance;
            if (!request.from) return planned_prm(space, prm_alone(space, plan.roadmap), clearance);
            PrmResult result = prm_path(space, *request.from, request.to, plan);
            const PrmConnectivity connectivity = result.connectivity();
            auto planned = planned_prm(space, std::make_shared<const Roadmap>(std::move(result.roadmap)), clearance);
            planned.prm = connectivity;
            return planned;
          },
          RoadmapKind::Keeping::as_prm,
          true};
}

/// The student exercise as written: 500 uniform samples at least 0.1 from every wall, each joined to its 8 nearest.
RoadmapKind homework_prm() {
  return {"prm-homework", "PRM of the homework: 500 samples, clearance 0.1, 8 nearest", false, true,
          [](const FreeSpace& space, const BuildRequest& request) {
            PrmOptions options;
            options.samples = 500;
            options.seed = request.seed;
            options.clearance = 0.1;
            return planned_prm(space, std::make_shared<const Roadmap>(prm(space, options)), options.clearance);
          }};
}

RoadmapKind voronoi() {
  return {"voronoi", "segment Voronoi diagram", false, false, [](const FreeSpace& space, const BuildRequest&) {
            const double tolerance = corridor_width(space) * kArcTolerance;
            const auto map = std::make_shared<const VoronoiRoadmap>(space);
            PlannedRoadmap planned{std::make_shared<const Roadmap>(voronoi_legs(*map, tolerance)),
                                   [map, tolerance](Point from, const Goal& to, GraphMethod) {
                                     return voronoi_search(*map, from, to, tolerance);
                                   }};
            planned.diagram = map;
            return planned;
          }};
}

void refuse(const std::string& file, const SavedRoadmap& saved, const std::optional<RoadmapFault>& fault) {
  if (fault) throw InputError(file, saved.line_of(fault->vertex, fault->is_row), fault->text);
}

/// A search on the navigation mesh; there is no graph.
RoadmapKind polyanya() {
  return {"polyanya",
          "navigation mesh",
          true,
          false,
          [](const FreeSpace& space, const BuildRequest& request) {
            const auto search = std::make_shared<PolyanyaSearch>(
                Polyanya(space, request.from ? navmesh_between(space, *request.from, request.to) : navmesh(space)));
            return PlannedRoadmap{std::make_shared<const Roadmap>(), [search](Point from, const Goal& to, GraphMethod) {
                                    search->find(from, to);
                                    return search->result();
                                  }};
          },
          RoadmapKind::Keeping::none,
          false,
          false};
}

}  // namespace

std::span<const RoadmapKind> roadmap_kinds() {
  static const RoadmapKind kinds[] = {
      polyanya(),
      visibility("visibility", "reduced visibility graph", VisibilityKind::reduced),
      visibility("full", "full visibility graph", VisibilityKind::full),
      cells("cells", "cells with 4 neighbours", CellNeighbours::four),
      cells("cells8", "cells with 8 neighbours", CellNeighbours::eight),
      growing_prm("prm", "probabilistic roadmap", PrmSampler::uniform, true),
      growing_prm("prm-lattice", "probabilistic roadmap on a lattice", PrmSampler::lattice, false),
      homework_prm(),
      voronoi(),
  };
  return kinds;
}

std::string roadmap_kind_names() {
  std::string names;
  for (const RoadmapKind& kind : roadmap_kinds()) names.append(names.empty() ? "" : ", ").append(kind.name);
  return names;
}

const RoadmapKind* roadmap_kind(const std::string& name) {
  for (const RoadmapKind& kind : roadmap_kinds())
    if (name == kind.name) return &kind;
  return nullptr;
}

void add_roadmap_kind(CommandLine& app, const std::string& option, const RoadmapKind*& kind, const std::string& group,
                      const std::string& standard) {
  const auto take = [&kind, option](const std::string& text) {
    const RoadmapKind* named = roadmap_kind(text);
    if (!named) throw UsageError(option + ": '" + text + "' is not one of " + roadmap_kind_names());
    kind = named;
  };
  app.add_option_function(option, take, roadmap_kind_names() + " (default: " + standard + ")")
      .type_name("NAME")
      .group(group);
}

void require_savable(const RoadmapKind& kind) {
  if (kind.keeping == RoadmapKind::Keeping::none)
    throw UsageError(std::string("--save: a roadmap of the kind '") + kind.name +
                     "' cannot be kept in a file; it is built anew each time");
}

std::string saved_text(const RoadmapKind& kind, const PlannedRoadmap& planned, const FreeSpace& space) {
  return roadmap_file({kind.name, planned.how, {}, *planned.roadmap}, space);
}

PlannedRoadmap load_roadmap(const std::string& file, const FreeSpace& space, const RoadmapKind*& kind) {
  SavedRoadmap saved = read_roadmap_file(read_bytes(file), file, space);
  kind = roadmap_kind(saved.kind);
  if (!kind || kind->keeping == RoadmapKind::Keeping::none)
    throw InputError(file, 0,
                     "is a saved roadmap of the kind '" + saved.kind + "', which cannot be loaded; known are " +
                         roadmap_kind_names());
  PlannedRoadmap planned;
  if (kind->keeping == RoadmapKind::Keeping::rebuilt) {
    planned = kind->build(space, {});
    refuse(file, saved, difference(saved.roadmap, *planned.roadmap));
  } else {
    refuse(file, saved, fault_of(saved.roadmap, space));
    planned = planned_prm(space, std::make_shared<const Roadmap>(std::move(saved.roadmap)), 0);
  }
  planned.how = std::move(saved.how);
  return planned;
}

}  // namespace taut::cli
