// One search of planned_drive. Private.
#pragma once

#include <vector>

#include <taut/robots/car/car_planner.h>
#include <taut/robots/car/detail/geodesic.h>
#include <taut/robots/car/detail/leg_lattice.h>

namespace taut::car::detail {

/// A* on one lattice, from any of the starts. Fills in status, legs and start when found, and adds to expanded and
/// tested.
void search_drive(const CarSpace& space, const DriveQuery& query, const std::vector<LatticePose>& starts,
                  const LegLattice& lattice, const Geodesic& geodesic, const SearchLimits& limits,
                  PlannedDrive& result);

}  // namespace taut::car::detail
