// The length of a disc's way around fixed corners, as a function of its radius.
#pragma once

#include <compare>
#include <utility>
#include <vector>

#include <taut/search/arc_path.h>

namespace taut {

/// L(r) = constant + angle r + the sum over legs that turn with r of sqrt(d^2 - (k r)^2) + k r asin(k r / d).
///
/// A leg between circles that the way passes on one side is as long as its centres are apart; another one turns, and
/// the way turns as much more at both of its ends. Convex: its derivative is the total of all turns, and no leg's turn
/// becomes less. Right while the way bends around these corners; beyond, legs go on straight where they end to be.
struct LengthFormula {
  struct Turning {
    double d = 0;  ///< from centre to centre
    double k = 0;  ///< 2 between circles that the way passes on different sides, 1 from or to a point

    friend auto operator<=>(const Turning&, const Turning&) = default;
  };
  double constant = 0;          ///< the legs that do not turn
  double angle = 0;             ///< radians
  std::vector<Turning> legs{};  ///< sorted

  double operator()(double r) const;
  double slope(double r) const;
  /// Takes out the legs that both have.
  static std::pair<LengthFormula, LengthFormula> apart(const LengthFormula& a, const LengthFormula& b);
};

/// Of the path's bends. Precondition: as pieces().
LengthFormula length_formula(const ArcPath& path);

}  // namespace taut
