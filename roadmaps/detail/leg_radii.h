// For which radii a tangent is free. Private.
#pragma once

#include <vector>

#include <taut/roadmaps/all_radii.h>
#include <taut/roadmaps/exact/plain_leg.h>
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
  /// How far a leg has turned; of one that keeps its direction the radius, as sine.
  struct Turn {
    double cosine, sine;
  };
  struct Own {
    Point direction;  ///< of a wall that ends in a centre, of length 1
    int side;
    double slack;
  };

  bool set_up(const TangentName& name, double most);
  bool find_own(const TangentSite& site, int side, bool second);
  Box box(double from, double to, double most) const;
  void gather(double most);
  bool find_walls(double most);
  bool concerns(const Segment& wall, bool& blocks) const;
  void follow_steady();
  void follow_turning();
  /// What of own_ and walls_ is of the range at hand, and how often the first one has been halved.
  struct Stack {
    std::size_t first_own, first_wall, depth;
  };
  int state(double r) const;
  Turn half_turn(std::size_t depth);
  void divide(double from, double to, Turn middle, const Stack& stack);
  void emit(double from, double to, bool certain);
  std::vector<RadiusSpan> spans_found() const;
  PlainLeg at(Turn turn) const;
  double radius(double x) const;

  const TangentGround& ground_;
  double scale_, least_;

  const TangentSite* a_ = nullptr;
  const TangentSite* b_ = nullptr;
  int s_ = 0, t_ = 0;
  Point d_;  // from a to b, of length 1
  double length_ = 0, most_ = 0, slack_ = 0;
  bool turns_ = false;
  double hand_ = 0, arm_ = 0;  // of a turning leg: which way, and its radius where it has turned by 90 degrees
  double low_ = 0, high_ = 0;  // the angles that a turning leg turns by
  std::size_t parts_ = 0;
  std::vector<Own> own_;             // a stack: of the range at hand behind
  std::vector<PlainSegment> walls_;  // likewise
  std::vector<RadiusSpan> ranges_;   // of the parameter
  std::vector<Turn> halves_;
  const TangentSite *near_from_ = nullptr, *near_to_ = nullptr;  // the pair that near_ is of
  std::vector<Segment> near_;
  bool openings_ = false;  // near the pair
  bool asks_ = false;      // near the tangent
};

}  // namespace taut::detail
