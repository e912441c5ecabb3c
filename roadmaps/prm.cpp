#include <taut/roadmaps/prm.h>

#include <taut/roadmaps/prm_growth.h>

namespace taut {

Roadmap prm(const FreeSpace& space, const PrmOptions& options, PrmCounts* counts) {
  PrmGrowth growth(space, options);
  growth.add(options.samples.value_or(growth.default_count()));
  if (counts != nullptr) *counts = growth.counts();
  return growth.roadmap();
}

std::vector<Roadmap::Vertex> nearest_visible(const FreeSpace& space, const Roadmap& roadmap, Point p, std::size_t count,
                                             double clearance) {
  PrmNearest index;
  index.add(roadmap.points());
  return nearest_visible(PrmClear(space, clearance), index, roadmap.points(), p, count);
}

}  // namespace taut
