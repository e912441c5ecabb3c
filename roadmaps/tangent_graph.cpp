#include <taut/roadmaps/tangent_graph.h>

#include <taut/geometry/expects.h>
#include <taut/roadmaps/exact/tangent_parts.h>

namespace taut {

TangentGraph::TangentGraph(const FreeSpace& space, double r, const TellProgress& tell) {
  TAUT_EXPECTS(space.footprint().kind() == Footprint::Kind::point);
  TAUT_EXPECTS(r > 0 && r <= World::kLargest);
  parts_ = std::make_shared<const TangentParts>(std::make_shared<const TangentGround>(space), r, tell);
}

const FreeSpace& TangentGraph::space() const { return parts_->walls().space(); }
double TangentGraph::radius() const { return parts_->r; }
std::size_t TangentGraph::corner_count() const { return parts_->sites().size(); }
std::size_t TangentGraph::leg_count() const { return parts_->legs.size() / 2; }
std::size_t TangentGraph::arc_count() const { return parts_->arcs; }
std::size_t TangentGraph::point_count() const { return parts_->points.size(); }

}  // namespace taut
