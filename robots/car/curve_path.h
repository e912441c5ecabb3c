// Shortest paths of a car where there are no walls: Dubins (forward only) and Reeds-Shepp (either way).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <taut/robots/car/pose.h>

namespace taut::car {

/// A piece of constant steering. `length` is signed: negative is driven backward.
struct CurveSegment {
  enum class Kind : std::uint8_t { left, straight, right };
  Kind kind = Kind::straight;
  double length = 0;
  friend bool operator==(const CurveSegment&, const CurveSegment&) = default;
};

/// Arcs of one radius and straight pieces, one after the other.
class CurvePath {
 public:
  CurvePath(const Pose& from, double radius, std::vector<CurveSegment> segments);

  const Pose& from() const { return from_; }
  double radius() const { return radius_; }
  const std::vector<CurveSegment>& segments() const { return segments_; }
  double length() const { return length_; }

  /// `L`, `S`, `R` a segment, a `-` after those driven backward: `LR-L`.
  std::string word() const;

  /// The pose after that length of way, 0 <= along <= length(); beyond, the nearer end. Headings are not reduced.
  Pose pose_at(double along) const;
  Pose end() const { return pose_at(length_); }

  /// Poses from beginning to end, no two further apart than `spacing` > 0 along the way; each joint of segments among
  /// them.
  std::vector<Pose> sampled(double spacing) const;

 private:
  Pose from_;
  double radius_;
  std::vector<CurveSegment> segments_;
  double length_ = 0;
};

/// The shortest path of a car that only goes forward and turns with at least `radius` > 0. At most three segments.
///
/// Closed forms of the six words LSL RSR LSR RSL RLR LRL (Dubins 1957; formulas as in Shkel and Lumelsky,
/// "Classification of the Dubins set", 2001). It ends in `to` to about 1e-12 of the coordinates (1e-8 where its circles
/// just touch: a root of nearly nothing), headings equal up to whole turns. Of words equally long the first in that
/// order. It is NOT symmetric: the way back from `to` to `from` may be another and of another length. An arc within
/// 1e-10 below a full turn is taken as none: rounding makes it, not geometry.
CurvePath dubins_path(const Pose& from, const Pose& to, double radius);

/// The same for a car that may also go backward: never longer than Dubins' path, and as long as the one from `to` to
/// `from`. At most five segments.
///
/// All 48 words: CSC, CCC, CCCC, CCSC, CCSCC, each driven in either direction of time, mirrored, and (CCC, CCSC) in
/// reverse order (Reeds and Shepp, "Optimal paths for a car that goes both forwards and backwards", 1990, formulas 8.1
/// to 8.11). Each candidate is driven to its end; one that does not end in `to` is not taken.
CurvePath reeds_shepp_path(const Pose& from, const Pose& to, double radius);

}  // namespace taut::car
