// Mazes that agree with what is known: the robot's idea of what it has not seen. Private.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <taut/robots/micromouse/detail/boards.h>
#include <taut/robots/micromouse/wall_map.h>

namespace taut::micromouse::detail {

/// A fixed number of sampled mazes. Each unknown wall stands with probability `density`, independently. A sample keeps its draws
/// for ever, so what has not been seen does not change from step to step, and a lower density only takes walls away.
class Belief {
 public:
  Belief(const Task& task, int samples, std::uint64_t seed);

  int samples() const { return static_cast<int>(north_.size()); }
  /// What maze `sample` looks like, the known walls taken over: the prior's law given the facts. `into` is reused.
  void world(int sample, const WallMap& map, double density, Passages& into) const;

  /// How likely an unknown wall stands, by those seen so far and a prior of `weight` walls of which `share` stand.
  static double density(const WallMap& map, double share, double weight);

 private:
  static constexpr int kLevels = 32;          // densities are multiples of 1 / kLevels
  std::vector<std::vector<CellBits>> north_;  // [sample][level]: bit set where the draw is at least level
  std::vector<std::vector<CellBits>> east_;
};

/// How much is to be gained by learning each wall: sums of the gains of plans that need it open.
struct WallWeights {
  std::vector<float> north;  // by cell
  std::vector<float> east;
};

/// What a look at it is worth: from every cell in each direction, the expected weight of the unknown walls that come into sight.
class Outlook {
 public:
  Outlook(const WallMap& map, const WallWeights& weights, double density);
  /// From a cell in one direction.
  float ray(std::size_t cell, Side side) const { return rays_[static_cast<std::size_t>(side)][cell]; }
  /// From a pose: all but what lies behind.
  float at(std::size_t cell, Side heading) const {
    return ray(cell, turned(heading, -1)) + ray(cell, heading) + ray(cell, turned(heading, 1));
  }

 private:
  std::array<std::vector<float>, 4> rays_;
};

}  // namespace taut::micromouse::detail
