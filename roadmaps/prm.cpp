#include <taut/roadmaps/prm.h>

#include <taut/roadmaps/prm_growth.h>

namespace taut {

Roadmap prm(const FreeSpace& space, const PrmOptions& options, PrmCounts* counts) {
  detail::PrmGrowth growth(space, options);
  growth.add(options.samples.value_or(growth.default_count()));
  if (counts != nullptr) *counts = growth.counts();
  return growth.roadmap();
}

std::vector<Roadmap::Vertex> nearest_visible(const FreeSpace& space, const Roadmap& roadmap, Point p, std::size_t count,
                                             double clearance) {
  detail::PrmNearest index;
  index.add(roadmap.points());
  return detail::nearest_visible(detail::PrmClear(space, clearance), index, roadmap.points(), p, count);
}

}  // namespace taut
