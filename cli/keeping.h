// When to tell Run::so_far() in a loop.
#pragma once

#include <taut/search/stopwatch.h>

namespace taut::cli {

/// Of many small results each telling costs as much as all that came before. So after the first a telling is left out
/// while they have taken more than a tenth of the time: what a stop then loses took next to nothing.
class Keeping {
 public:
  template <typename Tell>
  void tell(Tell tell) {
    if (spent_ > kShare * whole_.seconds().wall) return;
    const taut::Stopwatch watch;
    tell();
    spent_ += watch.seconds().wall;
  }

 private:
  static constexpr double kShare = 0.1;

  taut::Stopwatch whole_;
  double spent_ = 0;
};

}  // namespace taut::cli
