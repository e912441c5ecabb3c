// Polygons of a floor plan that change nothing.
#pragma once

#include <cstddef>
#include <vector>

#include <taut/geometry/world.h>

namespace taut {

/// An area that lies wholly in another one; they may touch. Places in the list that was asked about.
struct NestedArea {
  std::size_t inner = 0;
  std::size_t outer = 0;
};

/// Those areas, in their order, each with the first that it lies in; of equal ones all but the first. What only
/// several others cover together is not among them. Exact. Precondition: polygons as World guarantees them.
/// O((n + k) log n) for n vertices and k pairs of sides whose boxes meet.
std::vector<NestedArea> nested_areas(const std::vector<Area>& areas);

}  // namespace taut
