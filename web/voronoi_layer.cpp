// A file of its own: what it stands on is the heaviest of all.
#include <taut/roadmaps/voronoi.h>
#include <taut/web/detail/answers.h>

namespace taut::web {

Json voronoi_layer(const FreeSpace& space) {
  const VoronoiRoadmap diagram(space);
  Flat out;
  for (const VoronoiEdge& edge : diagram.edges()) {
    const Bezier curve = diagram.curve(edge);
    out << curve.from << curve.control << curve.to;
  }
  return {{"curves", out.json()}};
}

}  // namespace taut::web
