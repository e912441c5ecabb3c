// Roadmaps for other programs. JSON for programs of one's own: roadmap_json.h.
#pragma once

#include <string>

#include <taut/roadmaps/roadmap.h>

namespace taut {

/// GraphML (written by Boost.Graph), for networkx, igraph, Gephi: an undirected graph, nodes n0, n1, ... with the
/// attributes `x` and `y`, edges with `length`; numbers read back as the same double. About 120 bytes an edge.
std::string roadmap_graphml(const Roadmap& roadmap);

/// GeoJSON, for maps: a FeatureCollection of a Point for each vertex, with the property `vertex`, then a LineString for
/// each edge, with `from`, `to` and `length`. Numbers read back as the same double.
std::string roadmap_geojson(const Roadmap& roadmap);

}  // namespace taut
