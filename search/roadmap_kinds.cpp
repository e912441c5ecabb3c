#include <taut/search/roadmap_kinds.h>

#include <utility>

#include <taut/geometry/corridor_width.h>
#include <taut/geometry/walled_world.h>
#include <taut/roadmaps/cell_graph.h>
#include <taut/roadmaps/visibility_graph.h>
#include <taut/roadmaps/voronoi_legs.h>
#include <taut/search/cell_search.h>
#include <taut/search/polyanya.h>
#include <taut/search/prm_planner.h>
#include <taut/search/shortest_path.h>
#include <taut/search/verify.h>
#include <taut/search/voronoi_search.h>

namespace taut {

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

RoadmapKind visibility(const char* name, const char* title, const char* what, VisibilityKind kind) {
  return {name,
          title,
          what,
          true,
          false,
          [kind](const FreeSpace& space, const BuildRequest& request) {
            return planned(std::make_shared<const VisibilityGraph>(space, kind, request.jobs, request.tell),
                           search_visibility, visibility_query);
          },
          RoadmapKind::Keeping::rebuilt,
          false,
          true,
          false,
          kind};
}

/// The textbook's way to the full one: the reference that the fast one agrees with, edge for edge.
RoadmapKind brute_visibility() {
  return {"visibility-brute",
          "full visibility graph, each pair against each wall",
          "the full visibility graph from its definition, O(n^3): to see it agree with full, edge for edge",
          true,
          false,
          [](const FreeSpace& space, const BuildRequest&) {
            constexpr auto kFull = VisibilityKind::full;
            const auto graph =
                std::make_shared<const VisibilityGraph>(space, kFull, visibility_graph_brute_force(space, kFull));
            return planned(graph, search_visibility, visibility_query);
          },
          RoadmapKind::Keeping::rebuilt};
}

RoadmapKind cells(const char* name, const char* title, const char* what, CellNeighbours neighbours) {
  return {name,
          title,
          what,
          false,
          false,
          [neighbours](const FreeSpace& space, const BuildRequest&) {
            return planned(std::make_shared<const CellGraph>(space, neighbours), search_cells, cell_query);
          },
          RoadmapKind::Keeping::rebuilt};
}

/// One that is made at once, as it stands.
PlannedRoadmap prm_alone(const FreeSpace& space, const PrmOptions& options) {
  PrmCounts counts;
  auto roadmap = std::make_shared<const Roadmap>(prm(space, options, &counts));
  PlannedRoadmap planned = planned_prm(space, roadmap, options.clearance);
  planned.counts = counts;
  return planned;
}

/// A PRM that grows until it joins the ends, when they are known.
RoadmapKind growing_prm(const char* name, const char* title, const char* what, PrmSampler sampler, bool random) {
  return {name,
          title,
          what,
          false,
          random,
          [sampler](const FreeSpace& space, const BuildRequest& request) {
            PrmPlan plan = plan_of(request.prm, sampler, request.seed, request.is_limited);
            if (request.tell)
              plan.progress = [&](const PrmProgress& progress) {
                request.tell({"samples", progress.counts.drawn, 0});
                return true;
              };
            const double clearance = plan.roadmap.clearance;
            if (!request.from) return prm_alone(space, plan.roadmap);
            PrmResult result = prm_path(space, *request.from, request.to, plan);
            const PrmConnectivity connectivity = result.connectivity();
            auto planned = planned_prm(space, std::make_shared<const Roadmap>(std::move(result.roadmap)), clearance);
            planned.prm = connectivity;
            planned.counts = connectivity.counts;
            return planned;
          },
          RoadmapKind::Keeping::as_prm,
          true,
          true,
          true};
}

/// As many textbooks have it: a number of samples that is given beforehand, whatever comes of it.
RoadmapKind fixed_prm() {
  return {"prm-fixed",
          "PRM of 500 samples, clearance 0.1, 8 nearest",
          "500 uniform samples at least 0.1 from every wall, each joined to its 8 nearest; does not grow",
          false,
          true,
          [](const FreeSpace& space, const BuildRequest& request) {
            PrmOptions options;
            options.samples = 500;
            options.seed = request.seed;
            options.clearance = 0.1;
            return prm_alone(space, options);
          },
          RoadmapKind::Keeping::none,
          false,
          true,
          true};
}

PlannedRoadmap voronoi_of(const FreeSpace& space, double tolerance, unsigned jobs, const TellProgress& tell) {
  const auto map = std::make_shared<const VoronoiRoadmap>(space, jobs, tell);
  PlannedRoadmap planned{
      std::make_shared<const Roadmap>(voronoi_legs(*map, tolerance)),
      [map, tolerance](Point from, const Goal& to, GraphMethod) { return voronoi_search(*map, from, to, tolerance); }};
  planned.diagram = map;
  return planned;
}

/// Of a disc: the diagram of the walls themselves, as far as they leave it room, instead of that of all the sides of
/// the polygons around it. Where no way is found that the space agrees to, that one is asked after all.
PlannedRoadmap voronoi_of_disc(const FreeSpace& space, const BuildRequest& request, double tolerance) {
  std::vector<Point> ends = goal_points(space, request.to);
  ends.push_back(*request.from);
  const unsigned jobs = request.jobs;
  const double clearance = (1 + Footprint::kDiscExcess) * space.footprint().radius();
  const FreeSpace walled(walled_world(space.world(), ends));
  const auto map = std::make_shared<const VoronoiRoadmap>(walled, jobs, request.tell);
  PlannedRoadmap planned{std::make_shared<const Roadmap>(voronoi_legs(*map, tolerance, clearance)),
                         [=](Point from, const Goal& to, GraphMethod method) {
                           GraphSearchResult found = voronoi_search(*map, from, to, tolerance, clearance);
                           if (found.status == SearchStatus::found && verify(found.path, space, from, to).valid)
                             return found;
                           return voronoi_of(space, tolerance, jobs, {}).search(from, to, method);
                         }};
  planned.diagram = map;
  return planned;
}

RoadmapKind voronoi() {
  return {"voronoi",
          "segment Voronoi diagram",
          "the middles between walls: paths keep as far away as they can",
          false,
          false,
          [](const FreeSpace& space, const BuildRequest& request) {
            const double tolerance = corridor_width(space) * kArcTolerance;
            return space.footprint().kind() == Footprint::Kind::disc && request.from
                       ? voronoi_of_disc(space, request, tolerance)
                       : voronoi_of(space, tolerance, request.jobs, request.tell);
          }};
}

/// A search on the navigation mesh; there is no graph.
RoadmapKind polyanya() {
  return {"polyanya",
          "navigation mesh",
          "no graph: searches the convex polygons of free space; the shortest path",
          true,
          false,
          [](const FreeSpace& space, const BuildRequest& request) {
            const auto search = std::make_shared<PolyanyaSearch>(
                request.from ? Polyanya::between(space, *request.from, request.to) : Polyanya(space, navmesh(space)));
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
      visibility("visibility", "reduced visibility graph",
                 "corners a shortest path can bend around, and taut legs between them; the shortest path",
                 VisibilityKind::reduced),
      visibility("full", "full visibility graph", "all corners, and all pairs that see each other; the shortest path",
                 VisibilityKind::full),
      brute_visibility(),
      cells("cells", "cells with 4 neighbours", "the cells of a grid maze, joined to those beside them",
            CellNeighbours::four),
      cells("cells8", "cells with 8 neighbours", "likewise, and across corners", CellNeighbours::eight),
      growing_prm("prm", "probabilistic roadmap", "random samples, drawn until start and goal are joined",
                  PrmSampler::sobol, true),
      growing_prm("prm-lattice", "probabilistic roadmap on a lattice",
                  "likewise, samples on a lattice that becomes finer", PrmSampler::lattice, false),
      fixed_prm(),
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

PlannedRoadmap planned_prm(const FreeSpace& space, const std::shared_ptr<const Roadmap>& roadmap, double clearance) {
  return {roadmap,
          [space, roadmap, clearance](Point from, const Goal& to, GraphMethod method) {
            return graph_search(*roadmap, prm_query(space, *roadmap, from, to, clearance), method);
          },
          [space, roadmap, clearance](Point from, const Goal& to) {
            return prm_query(space, *roadmap, from, to, clearance);
          }};
}

}  // namespace taut
