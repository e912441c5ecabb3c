// Pursuers of textbooks: in the plane, without a clock, towards where the target will be.
#pragma once

#include <limits>
#include <vector>

#include <taut/robots/pursuit/pursuit.h>

namespace taut::pursuit {

/// Heads for the place of a target, all of whose way is known, so many seconds later, and plans anew each second.
///
///  1. Its aim at a second is the first free cell of the trajectory `ahead` seconds later or after that, of a
///     trajectory that ends before the last one; kToTheEnd: the last one, always.
///  2. It goes along a way of least cost to the aim as if time did not count, and waits where it is when it has arrived
///     or when there is no way.
///  3. Incomplete, to be seen beside the others: it may pass where it could have waited, be late where a dearer way is
///     in time, and circle behind a target that is as fast.
///
/// O(cells log cost) a second while the aim moves. The chase's map is kept by reference.
class HeadingPursuer {
 public:
  static constexpr int kToTheEnd = std::numeric_limits<int>::max();

  /// Precondition: ahead >= 0.
  HeadingPursuer(Chase chase, int ahead);

  /// Where to from `at` at second `now`: a neighbour or `at` itself.
  CellIndex next(CellIndex at, int now);

  int plans() const { return plans_; }

 private:
  const Meeting& aim(int now) const;

  Chase chase_;
  int ahead_;
  std::vector<CellIndex> way_;  // from where it stands to the aim, backwards
  int plans_ = 0;
};

}  // namespace taut::pursuit
