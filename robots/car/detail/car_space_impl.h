// What a CarSpace is made of. Private.
#pragma once

#include <vector>

#include <taut/geometry/box_index.h>
#include <taut/roadmaps/wall_index.h>
#include <taut/robots/car/car_space.h>
#include <taut/robots/car/detail/prepared_leg.h>

namespace taut::car {

struct CarSpace::Impl {
  Impl(const FreeSpace& free_space, const CarShape& car);

  /// The walls whose boxes meet `box`, relative to `origin`.
  void walls_near(const Box& box, Point origin, std::vector<detail::NearWall>& near) const;

  /// Is the way free of these walls, and of all openings? `at` is the leg where it is.
  bool is_clear(const detail::PreparedLeg& leg, const Leg& at, const std::vector<detail::NearWall>& near) const;

  taut::WallIndex walls;
  CarShape shape;
  std::vector<std::uint32_t> openings;
  taut::BoxIndex opening_boxes;
};

}  // namespace taut::car
