// One search of LatticePlanner.
#pragma once

#include <cstddef>
#include <optional>

#include <taut/robots/roadblocks/detail/disc_distance.h>
#include <taut/robots/roadblocks/detail/pose_distance.h>
#include <taut/robots/roadblocks/lattice_planner.h>

namespace taut::roadblocks::detail {

struct Lattice {
  int bins = 4;                  ///< of positions, to the unit
  int arc = 4;                   ///< steps of an arc, and 128ths of a turn between headings; divides 128
  double slack = kMargin;        ///< kept from what is closed
  std::size_t most = 1'000'000;  ///< states to expand: then it gives up
};

struct LatticeAnswer {
  std::optional<DrivePlan> plan;
  bool exhausted = false;  ///< without a plan: all of the lattice that the start is connected to was searched
};

/// A*. Adds to `expanded`.
LatticeAnswer lattice_search(const Obstacles& obstacles, const DiscDistance& disc, const PoseDistance& distance,
                             const Lattice& lattice, const Pose& from, std::size_t& expanded);

}  // namespace taut::roadblocks::detail
