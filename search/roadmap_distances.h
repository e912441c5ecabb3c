// How far every vertex of a Roadmap is from the nearest of several places, in doubles.
#pragma once

#include <span>
#include <vector>

#include <taut/roadmaps/roadmap.h>

namespace taut {

/// A vertex that is `length` >= 0 from a place.
struct RoadmapSource {
  Roadmap::Vertex vertex = 0;
  double length = 0;
};

struct RoadmapDistances {
  std::vector<double> length;         ///< of each vertex; infinite where no source is connected with it
  std::vector<Roadmap::Vertex> next;  ///< of each vertex, towards the place; kNone of a source, and where there is none
};

/// Dijkstra from all sources at once (boost::dijkstra_shortest_paths_no_init). A length is the sum of its legs
/// (std::hypot), added up from the source on, so it is off by at most an ulp a leg, and so is the choice of the way.
/// For exact ones see GraphShortestPaths. O((V + E) log V).
RoadmapDistances roadmap_distances(const Roadmap& roadmap, std::span<const RoadmapSource> sources);

}  // namespace taut
