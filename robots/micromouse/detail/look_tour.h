// Several looks planned as one tour. Private.
#pragma once

#include <optional>
#include <vector>

#include <taut/robots/micromouse/detail/belief.h>

namespace taut::micromouse::detail {

struct TourTuning {
  int looks = 4;            ///< of a tour, at most
  int beam = 5;             ///< tours kept after each look, and looks tried behind each
  double discount = 0.65;   ///< what shows a step later counts so much less
  double side_looks = 0.4;  ///< what looks on the way count in choosing the next look
};

struct Tour {
  std::vector<Action> way;  ///< to its first look, the last action first
  double value = 0;         ///< weight that shows, discounted by when
  int looks = 0;
};

/// Of the tours that a beam search finds the one of the greatest value; nothing when there is nothing to see. A wall
/// counts once: after a sight of it, also on the way to a look, only for the chance that it was out of sight then.
/// O(looks * beam * (cells + beam * steps)).
std::optional<Tour> best_tour(const WallMap& map, const MousePose& from, const WallBoard& weights,
                              const WallBoard& open, const TourTuning& tuning = {});

}  // namespace taut::micromouse::detail
