// What a FreeSpace keeps.
#pragma once

#include <mutex>

#include <taut/geometry/detail/locator.h>
#include <taut/geometry/free_space.h>

namespace taut {

struct FreeSpace::Impl {
  World world;
  Footprint footprint;
  FreeSpaceReport report;
  std::vector<Constraint> constraints;
  Triangulation tri;
  std::vector<std::uint32_t> piece_of;    // 3 * triangle + side -> constraint
  std::vector<std::uint32_t> components;  // triangle -> component
  std::uint32_t component_count = 0;
  detail::Locator locator;

  mutable std::once_flag polygons_made;  // most callers never look at them
  mutable std::vector<Polygon> polygons;
};

}  // namespace taut
