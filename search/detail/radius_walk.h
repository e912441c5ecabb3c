// The directed graph of a disc of any radius, made as far as a search comes. Private.
#pragma once

#include <cstdint>
#include <vector>

#include <taut/roadmaps/exact/all_radii_parts.h>
#include <taut/search/detail/arc_ends.h>

namespace taut::detail {

/// ArcWalk of AllRadii::at_radius(r), but tangent points have other numbers: a corner's are made, numbered and put in
/// order when the first leg to it is walked.
class RadiusWalk {
 public:
  /// Precondition: parts.covers(r). `parts` outlive it.
  RadiusWalk(const AllRadiiParts& parts, double r);

  std::size_t nodes() const { return 2 * points_.size(); }  ///< so far
  double radius() const { return r_; }
  const TangentPoint& point(std::uint32_t p) const { return points_[p]; }
  std::uint32_t site_of(std::uint32_t p) const { return site_of_[p]; }
  const TangentSite& site(std::uint32_t i) const { return parts_.ground->sites[i]; }

  ArcEnds join(Point s, Point g) {
    return join_ends({*parts_.ground, r_,
                      [this](std::uint32_t i) {
                        const auto [first, end] = made(i);
                        return ArcGraph::Points{first, std::span(points_).subspan(first, end - first)};
                      }},
                     s, g);
  }

  template <class Visit>
  void onward(std::uint32_t n, Visit&& visit) {
    const std::uint32_t p = n / 2, i = site_of_[p];
    const bool round = site(i).round;
    const int side = round ? (n % 2 == 1 ? 1 : -1) : 0;
    for (std::uint32_t k = first_leg_[p]; k < first_leg_[p + 1]; ++k)
      // Others may be made meanwhile.
      if (const Leg leg = legs_[k]; leg.from_side == side) {
        made(leg.to);
        visit(arc_node(point_of_[leg.end], leg.to_side), leg.length);
      }
    if (!round || (side < 0 && p == sites_[i].first)) return;
    const std::uint32_t arc = side > 0 ? p : p - 1;
    if (arc_is_free_[arc])
      visit(arc_node(side > 0 ? p + 1 : p - 1, side), Interval(r_) * angle_between(points_[arc], points_[arc + 1]));
  }

 private:
  struct Made {
    std::uint32_t first = kNone, end = kNone;  // points
  };
  struct Leg {
    std::uint32_t to, end;  // the site, and the end there
    int from_side, to_side;
    Interval length;
  };

  const Made& made(std::uint32_t i);
  void find_ends(std::uint32_t i);
  bool has(std::uint32_t leg);

  const AllRadiiParts& parts_;
  double r_;
  std::vector<Made> sites_;
  std::vector<TangentPoint> points_;
  std::vector<std::uint32_t> site_of_, first_leg_{0};
  std::vector<std::uint8_t> arc_is_free_;
  std::vector<Leg> legs_;
  std::vector<std::uint32_t> point_of_;  // by end
  std::vector<std::int8_t> has_;         // by leg: -1 not asked yet
  // Of the site at hand:
  std::vector<TangentPoint> ends_;
  std::vector<Leg> ways_;
  std::vector<std::uint32_t> own_;
  SiteOrder order_;
  CircleObstacles obstacles_;
};

}  // namespace taut::detail
