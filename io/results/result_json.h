// What a planner answered, as JSON.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <taut/geometry/footprint.h>
#include <taut/geometry/world.h>
#include <taut/io/results/json.h>
#include <taut/search/anytime_search.h>
#include <taut/search/graph_search.h>
#include <taut/search/path.h>
#include <taut/search/prm_planner.h>

namespace taut {

/// Everything there is to say about one query. Nothing in `path`, `separation` and `clearance` unless it applies.
struct PlanResult {
  SearchStatus status = SearchStatus::none;  ///< stopped: nothing is known, or no path and no proof
  Path path;
  std::vector<Segment> separation;  ///< when none: the walls in between, in order around the one or the other
  std::optional<double> clearance;  ///< when verified
  bool verified = false;
  std::optional<Point> start;
  Goal goal;
  Footprint robot;
  std::string roadmap = "visibility";  ///< its kind
  std::optional<double> within;        ///< rounding_bound, where crossings were rounded
  bool optimal = true;                 ///< does this roadmap hold the shortest path in the plane?
  double wall_thickness = 0;           ///< the largest of the world
  double displacement = 0;             ///< FreeSpaceReport
  double uncertainty = 0;              ///< of the world
  std::size_t expanded = 0;
  std::optional<GraphMethod> method;              ///< of a search in a graph of straight legs
  bool shortest_in_roadmap = true;                ///< is the path found the shortest there, proven?
  std::optional<GraphOverestimate> overestimate;  ///< why A* may have missed that
  std::optional<Length> unpulled;                 ///< the length before the path was pulled taut, if it was
  std::optional<PrmConnectivity> prm;             ///< of a PRM that was grown for the query
  std::optional<double> bound;                    ///< of an anytime search that found a path
  std::vector<AnytimeImprovement> improvements;
};

/// One JSON object. Keys are stable: none will be renamed or change its meaning within a major version, new ones may
/// come. Keys, in this order:
///
/// when found, also of the best path when an anytime search was stopped:
///  length          number, within one ulp of the exact length
///  length_text     the exact length, correctly rounded to 15 decimals
///  length_interval [lo, hi], doubles that enclose the exact length
///  optimal         true when this is the shortest path in the plane, false when only in the roadmap or not proven
///  within          in its place where crossings of walls had to be rounded and it would be true: no path that stays
///                  this far from obstacles is shorter, and this one goes through none deeper than that
///  points          [[x, y], ...] from start to goal
///  corners         how often the path bends (corner_count, with the world's uncertainty), whatever points it is made
///                  of
///  clearance       least distance of the path to an obstacle, 0 when it touches one; null when it was not verified or
///                  there is no obstacle
///  verified        true when the independent check accepted the path
/// when none:
///  separation      [[[x1, y1], [x2, y2]], ...] the walls between start and goal, in order around one of them
///  within          where crossings of walls had to be rounded: there is no path that stays this far from obstacles
/// always:
///  start           [x, y]; null when not known yet
///  goal            {"point": [x, y]}, {"room": [[xmin, ymin, xmax, ymax], ...]} or null
///  robot           {"kind": "point" | "disc" | "polygon", "radius": r (disc and square only)}
///  roadmap         the kind of roadmap it was found in: "visibility", "cells", ...
///  wall_thickness  the largest thickness of a wall
///  displacement    how far rounding moved any constructed point at most
///  expanded        vertices the search took from its queue for good
///  algorithm       of a search in a graph: "astar", "dijkstra", "bfs", "dfs", "greedy"
///  heuristic       with "astar" and "greedy": "euclidean", "manhattan", ...
///  overestimate    of A* whose heuristic is not admissible: {"at": [x, y], "estimate", "cost"}, a place where it says
///                  more than is left; the path found is then not called optimal
///  length_in_roadmap  of the path in the roadmap, when it was pulled taut after that (--shorten)
///  prm             of a probabilistic roadmap: {"samples", "vertices", "edges", "edges_tested", "components",
///                  "start_part", "goal_part"}; the parts are the vertices that hang together with an end
///  bound           of an anytime search that found a path: it is at most this many times as long as the shortest
///                  in the roadmap; 1 when it is proven to be that; null when nothing is known
///  improvements    [{"epsilon", "bound", "length", "expanded", "seconds"}, ...] with `bound`: the stages finished
Json result_json(const PlanResult& result);

}  // namespace taut
