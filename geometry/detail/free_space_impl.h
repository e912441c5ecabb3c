// What a FreeSpace keeps.
#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

#include <taut/geometry/cell_plan.h>
#include <taut/geometry/detail/locator.h>
#include <taut/geometry/free_space.h>

namespace taut {

namespace detail {

/// Pieces and triangles.
struct FreeSpaceMade {
  FreeSpaceReport report;
  std::vector<Constraint> constraints;
  Triangulation tri;
  std::vector<std::uint32_t> piece_of;    // 3 * triangle + side -> constraint
  std::vector<std::uint32_t> components;  // triangle -> component
  std::uint32_t component_count = 0;
  Locator locator;
};

}  // namespace detail

struct FreeSpace::Impl {
  Impl(World world, Footprint footprint, std::span<const Point> places);

  const detail::FreeSpaceMade& parts() const { return is_made.load(std::memory_order_acquire) ? *made : make(); }
  const detail::FreeSpaceMade& make() const;

  World world;
  Footprint footprint;
  std::vector<Point> places;
  std::optional<CellPlan> cells;

  mutable std::once_flag making;
  mutable std::atomic<bool> is_made = false;
  mutable std::unique_ptr<const detail::FreeSpaceMade> made;

  mutable std::once_flag polygons_made;  // most callers never look at them
  mutable std::vector<Polygon> polygons;
};

}  // namespace taut
