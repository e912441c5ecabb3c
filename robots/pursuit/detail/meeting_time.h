// When a robot that turned around one last bend meets a target on one leg of its way.
#pragma once

#include <optional>
#include <vector>

#include <taut/geometry/exact/exact_point.h>
#include <taut/geometry/exact/signed_roots.h>
#include <taut/geometry/interval.h>

namespace taut::pursuit::detail {

/// A target that moves evenly from `at` with (vx, vy), from time `begins` until `ends`.
struct TargetLeg {
  Segment line;
  Rational begins, ends;
  ExactPoint at;
  Rational vx = 0, vy = 0;
  bool endless = false;  ///< it stands, and `ends` means nothing

  ExactPoint place(const Rational& time) const {
    return {Rational(at.x + vx * (time - begins)), Rational(at.y + vy * (time - begins))};
  }
};

/// A place and the exact length of the way to it.
struct LastBend {
  ExactPoint at;
  std::vector<SignedRoot> way;
  Interval length;
};

/// The roots of late(t) = |way| + |target(t) - bend| - speed t, which is convex. All signs are exact.
class MeetingTime {
 public:
  MeetingTime(const LastBend& bend, const TargetLeg& leg, const Rational& speed);

  /// The first time from `from` until `until` with late <= 0, enclosed by neighbouring doubles, or by one where it is
  /// that; nothing when there is none. Precondition: from <= until, within the leg.
  std::optional<Interval> first(const Rational& from, const Rational& until) const;

  int late(const Rational& time) const;  ///< the sign
  /// How long a robot waits that hurries to where the target is at that time; to rounding.
  double wait(double time) const;

 private:
  std::optional<Interval> dip(const Rational& from, const Rational& until) const;
  int discriminant() const;
  int linear(const Rational& factor, const Rational& rest) const;
  int beyond_middle(const Rational& time) const;
  double guess() const;
  template <class Reached>
  Interval enclosed(Reached reached) const;

  const LastBend& bend_;
  const TargetLeg& leg_;
  const Rational& speed_;
  Rational slope_;    // |v|^2 - speed^2
  Rational wx_, wy_;  // from the bend to where the target would have been at time 0
  Rational along_;    // w . v
};

}  // namespace taut::pursuit::detail
