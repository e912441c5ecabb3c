#include <taut/search/arc_bounds.h>

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include <taut/geometry/expects.h>
#include <taut/search/detail/arc_hierarchy_query.h>
#include <taut/search/detail/arc_walk.h>

namespace taut {

namespace {

using detail::ArcEnds;
using detail::ArcExit;

constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// Ways in a graph whose arcs are as long as on circles of another radius.
class Weighted {
 public:
  Weighted(detail::ArcWalk& walk, double weight)
      : scale_(weight / walk.radius()), hierarchy_(detail::turnable(walk, scale_)), query_(hierarchy_) {}

  double least(const ArcEnds& ends) {
    double least = query_.find(doors(ends.entries, ends.from_start), doors(ends.exits, ends.to_goal)).length;
    for (const ArcEnds::Apart& way : ends.apart) {
      double legs = way.length.lo;
      if (way.start_leg != kNone)
        legs = ends.from_start[way.start_leg].length.lo + ends.to_goal[way.goal_leg].length.lo;
      least = std::min(least, scaled(way.length.lo, legs));
    }
    return least;
  }

 private:
  /// What is not legs is an arc.
  double scaled(double length, double legs) const { return legs + std::max(0.0, length - legs) * scale_; }

  std::vector<detail::ArcDoor> doors(const std::vector<ArcExit>& all,
                                     const std::vector<detail::ArcEndLeg>& legs) const {
    std::vector<detail::ArcDoor> result;
    for (const ArcExit& door : all) result.push_back({door.node, scaled(door.length.lo, legs[door.leg].length.lo)});
    return result;
  }

  double scale_;
  detail::ArcHierarchy hierarchy_;
  detail::ArcHierarchyQuery query_;
};

}  // namespace

struct ArcBounds::Impl {
  Impl(TangentGraph of, double most_radius)
      : tangents(std::move(of)),
        most(most_radius),
        walk(tangents.parts()),
        low(walk, tangents.radius()),
        high(walk, most),
        rounding(static_cast<double>(walk.nodes() + 16) * 0x1p-50) {}

  double least(double r, Point s, Point g) {
    if (s == g) return 0;
    const TangentWalls& walls = tangents.parts().walls();
    for (const Point p : {s, g})
      if (walls.space().locate(p).kind == Location::Kind::outside || walls.too_near(p, tangents.radius()) != kNone)
        return kInfinite;
    const ArcEnds ends = walk.join(s, g);
    const double first = low.least(ends), last = high.least(ends);
    if (first == kInfinite) return kInfinite;
    const double share = (r - tangents.radius()) / (most - tangents.radius());
    return (first + share * (last - first)) * (1 - rounding);
  }

  TangentGraph tangents;
  double most;
  detail::ArcWalk walk;
  Weighted low, high;
  double rounding;  // of a length, as a share
};

ArcBounds::ArcBounds(TangentGraph graph, double most) {
  TAUT_EXPECTS(most > graph.radius());
  impl_ = std::make_unique<Impl>(std::move(graph), most);
}
ArcBounds::~ArcBounds() = default;
ArcBounds::ArcBounds(ArcBounds&&) noexcept = default;
ArcBounds& ArcBounds::operator=(ArcBounds&&) noexcept = default;

double ArcBounds::least_radius() const { return impl_->tangents.radius(); }
double ArcBounds::most_radius() const { return impl_->most; }

double ArcBounds::length_at_least(double r, Point s, Point g) {
  TAUT_EXPECTS(r >= least_radius() && r <= most_radius());
  return impl_->least(r, s, g);
}

}  // namespace taut
