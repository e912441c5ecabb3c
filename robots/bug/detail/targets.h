// What Tangent Bug can go for from where it stands, and which of it promises most.
#pragma once

#include <optional>

#include <taut/robots/bug/detail/view.h>

namespace taut::bug::detail {

/// The end of the part of a contour in view, to one side.
struct ViewEnd {
  Sight::Step::Kind kind = Sight::Step::Kind::vertex;
  ExactPoint target{Point{}};  ///< the end itself, or the corner that hides what follows
};

/// A corner in view, and the way to it.
struct Corner {
  Point at;
  Walk walk;
};

/// Targets v are compared by what they promise: |xv| + d(v), x being the stand and d the distance to the goal. Exact;
/// ties go to `preferred`, the side on which a target lies or to which a contour is followed. Keeps references.
class Targets {
 public:
  Targets(const ContourPlaces& places, const Stand& stand, const Spot& goal, Turn preferred)
      : places_(places), stand_(stand), goal_(goal), preferred_(preferred) {}

  /// The sign of the difference of what two targets promise: negative when p promises the shorter way.
  int compare(const ExactPoint& p, const ExactPoint& q) const;

  /// The best corner in view with d(v)^2 below the limit to which the robot can go straight.
  std::optional<Corner> best_corner(const Sight& sight, const Rational& limit) const;

  /// Of the part of a contour in view that holds `hit`, the end to that side.
  ViewEnd end(const Sight& sight, const ContourPlace& hit, Turn turn) const;

  /// The way along the contour towards the better end; at a tie where it falls steeper towards the goal.
  Turn better(const ContourPlace& hit, const ViewEnd& left, const ViewEnd& right) const;

 private:
  Rational distance(const ExactPoint& p) const { return squared_distance(p, goal_.exact); }
  Point vertex(std::uint32_t v) const { return places_.tri().points[v]; }
  bool is_preferred(Point v) const;
  /// Negative when the contour falls steeper towards the goal to the left of `hit`.
  int compare_slopes(const ContourPlace& hit) const;

  const ContourPlaces& places_;
  const Stand& stand_;
  const Spot& goal_;
  Turn preferred_;
};

}  // namespace taut::bug::detail
