// For which radii a tangent is free. Private.
#pragma once

#include <vector>

#include <taut/roadmaps/all_radii.h>
#include <taut/roadmaps/exact/tangent_parts.h>

namespace taut::detail {

/// A segment as doubles, and the length of it that a disc's way may come near.
struct PlainSegment {
  Point a, b;
};

/// Follows the tangents of one pair of corners through all radii.
///
/// A tangent moves with a parameter: the radius, when it keeps its direction, else the angle that it has turned by. The
/// distance between it and a wall, less the radius, changes by at most a known multiple of the parameter; so a value in
/// the middle of a range that exceeds this for half of it (and what doubles may be off) decides all of the range. What
/// is not decided is cut in two, until it is small. Legs that keep their direction sweep more and more as they move, so
/// that a single bisection finds where they end.
class LegRadii {
 public:
  /// For circles from `least` to `most`. `scale`: no coordinate is larger, and no distance in the world.
  LegRadii(const TangentGround& ground, double scale, double least) : ground_(ground), scale_(scale), least_(least) {}

  /// Ascending; empty when the tangent is free for none of them.
  std::vector<RadiusSpan> spans(const TangentName& name, double most);

 private:
  struct Leg {
    Point from, to;
    double radius;
  };
  struct Own {
    Point direction;  ///< of a wall that ends in a centre, of length 1
    int side;
    double slack;
  };

  bool set_up(const TangentName& name, double most);
  bool find_own(const TangentSite& site, int side, bool second);
  bool find_walls();
  bool concerns(const Segment& wall, bool& blocks) const;
  void follow_steady();
  void follow_turning();
  void divide(double from, double to, std::size_t first_own, std::size_t first_wall);
  void emit(double from, double to, bool certain);
  Point direction(double x) const;
  Leg at(double x) const;
  double radius(double x) const;
  static double gap(const Leg& leg, const PlainSegment& wall);

  const TangentGround& ground_;
  double scale_, least_;

  const TangentSite* a_ = nullptr;
  const TangentSite* b_ = nullptr;
  int s_ = 0, t_ = 0;
  Point d_;  // from a to b, of length 1
  double length_ = 0, most_ = 0, slack_ = 0;
  bool turns_ = false;
  double hand_ = 0, arm_ = 0;  // of a turning leg: which way, and its radius where it has turned by 90 degrees
  bool asks_ = false;          // openings are near
  std::size_t parts_ = 0;
  std::vector<Own> own_;             // a stack: of the range at hand behind
  std::vector<PlainSegment> walls_;  // likewise
  std::vector<RadiusSpan> spans_;
};

}  // namespace taut::detail
