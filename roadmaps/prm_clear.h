// Is a point, or a leg, far enough from every obstacle?
#pragma once

#include <optional>

#include <taut/geometry/box_index.h>
#include <taut/geometry/free_space.h>

namespace taut {

/// The exact tests behind PrmOptions, guarantee 1: distances are compared with the clearance as exact numbers.
class PrmClear {
 public:
  PrmClear(const FreeSpace& space, double clearance);

  const FreeSpace& space() const { return space_; }
  bool point(Point p) const { return place(p).has_value(); }
  /// Where it is, when it is clear.
  std::optional<Location> place(Point p) const;
  bool leg(Point p, Point q) const;
  /// The same for two points that are not outside, of which one has been located.
  bool leg(Point p, const Location& at, Point q) const { return sees(p, at, q) && keeps_distance({p, q}); }
  /// FreeSpace::sees() for such points.
  bool sees(Point p, const Location& at, Point q) const;

  /// Calls visit(i) for a superset of the constraints that are nearer to the box than `by`.
  template <class Visit>
  void near(const Box& box, double by, Visit&& visit) const {
    index_.meeting(widened(box, by), visit);
  }

 private:
  bool is_untouched(const Location& at) const;
  bool keeps_distance(const Segment& s) const;

  FreeSpace space_;
  double clearance_;
  Segment from_, to_;  // two points, as segments, that are `clearance` apart
  BoxIndex index_;
};

}  // namespace taut
