// A way through the cells of a grid maze.
#pragma once

#include <taut/geometry/world.h>
#include <taut/roadmaps/cell_graph.h>
#include <taut/search/graph_search.h>

namespace taut {

/// The shortest way on the cell graph from `from` to the goal, joined as CellGraph::joined_to says; straight when both
/// lie in one cell and see each other. A room is entered across one of its sides from the centre of the cell before it,
/// at a right angle. It is optimal among these ways, not in the plane; `none` says that the graph has no way, which
/// proves nothing about the plane (FreeSpace::separation does). Throws InputError when `from` or the goal is no place
/// for the robot.
GraphSearchResult cell_search(const CellGraph& graph, Point from, const Goal& to, GraphMethod method = {},
                              const SearchLimits& limits = {});

/// The query that cell_search asks of graph.roadmap(), for other searches.
/// From within the goal room it is one leg of length 0.
GraphQuery cell_query(const CellGraph& graph, Point from, const Goal& to);

}  // namespace taut
