#include <taut/geometry/nearest_free.h>

#include <taut/geometry/exact/numbers.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <taut/geometry/exact/exact_point.h>
#include <taut/geometry/segment_distance.h>
#include <taut/geometry/written.h>

namespace taut {

namespace {

/// The constraint nearest to p of those that border an obstacle: who is inside one leaves it there.
std::uint32_t nearest_side(const FreeSpace& space, Point p) {
  const std::vector<Constraint>& pieces = space.constraints();
  std::uint32_t best = kNone;
  Interval least{0, HUGE_VAL};
  for (std::uint32_t i = 0; i < pieces.size(); ++i) {
    if (pieces[i].is_wall()) continue;
    const Segment side{pieces[i].a, pieces[i].b};
    const Interval distance = segment_distance_interval({p, p}, side);
    if (best != kNone && distance.lo >= least.hi) continue;
    if (best != kNone && distance.hi >= least.lo &&
        compare_segment_distances({p, p}, side, {p, p}, {pieces[best].a, pieces[best].b}) >= 0)
      continue;
    best = i;
    least = distance;
  }
  return best;
}

/// Places on a directed side, solid on its left, and the doubles beside it.
class SolidSide {
 public:
  SolidSide(const FreeSpace& space, const Constraint& piece)
      : space_(space),
        side_(piece.solid_left ? Segment{piece.a, piece.b} : Segment{piece.b, piece.a}),
        a_(side_.a),
        ux_(ExactPoint(side_.b).x - a_.x),
        uy_(ExactPoint(side_.b).y - a_.y),
        unit_(space.world().box()) {}

  /// What part of the side lies before the place nearest to p.
  Rational foot_of(Point p) const {
    const ExactPoint at(p);
    const Rational along = (at.x - a_.x) * ux_ + (at.y - a_.y) * uy_, length = ux_ * ux_ + uy_ * uy_;
    return along <= 0 ? Rational(0) : along >= length ? Rational(1) : Rational(along / length);
  }

  /// The free point beside the foot; where a narrow corner leaves no double there, on towards the nearer end.
  std::pair<Point, double> free_beside(const Rational& foot) const {
    const ExactPoint exact = at(foot);
    const int end = foot * 2 < 1 ? 0 : 1;
    Rational step = Rational(1) / (Integer(1) << 60);
    for (Rational t = foot; t > 0 && t < 1; t = end == 0 ? Rational(foot - step) : Rational(foot + step), step *= 2)
      if (const auto q = beside(t)) return {*q, displacement(exact, *q)};
    const Point corner = end == 0 ? side_.a : side_.b;
    return {corner, displacement(exact, corner)};
  }

 private:
  ExactPoint at(const Rational& t) const { return {a_.x + t * ux_, a_.y + t * uy_}; }

  std::optional<Point> beside(const Rational& t) const {
    const ExactPoint place = at(t);
    if (const auto q = exactly(place); q && is_free(*q)) return q;
    const Point q = round_outward(place, std::span(&side_, 1), unit_);
    return is_free(q) ? std::optional(q) : std::nullopt;
  }

  bool is_free(Point q) const { return space_.locate(q).kind != Location::Kind::outside; }

  const FreeSpace& space_;
  Segment side_;
  ExactPoint a_;
  Rational ux_, uy_;
  DecimalUnit unit_;
};

}  // namespace

std::optional<FreePlace> nearest_free(const FreeSpace& space, Point p) {
  if (space.locate(p).kind != Location::Kind::outside) return FreePlace{p, 0, 0, kNone};
  const std::uint32_t piece = nearest_side(space, p);
  if (piece == kNone) return std::nullopt;
  const SolidSide side(space, space.constraints()[piece]);
  const auto [place, rounding] = side.free_beside(side.foot_of(p));
  return FreePlace{place, segment_distance({p, p}, {place, place}), rounding, piece};
}

}  // namespace taut
