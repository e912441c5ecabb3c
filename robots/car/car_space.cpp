#include <taut/robots/car/car_space.h>

#include <algorithm>
#include <utility>

#include <taut/robots/car/detail/car_space_impl.h>

namespace taut::car {

namespace {

using detail::NearWall;
using detail::PreparedLeg;

Box moved(const Box& box, Point by) {
  return {{box.min.x + by.x, box.min.y + by.y}, {box.max.x + by.x, box.max.y + by.y}};
}

std::vector<std::uint32_t> openings_of(const taut::WallIndex& walls) {
  std::vector<std::uint32_t> openings;
  for (std::uint32_t c = 0; c < walls.space().constraints().size(); ++c)
    if (walls.is_opening(c)) openings.push_back(c);
  return openings;
}

std::vector<Box> boxes_of(const taut::WallIndex& walls, const std::vector<std::uint32_t>& constraints) {
  std::vector<Box> boxes;
  for (const std::uint32_t c : constraints) {
    const Segment s = walls.segment(c);
    boxes.push_back(taut::box_around(s.a, s.b));
  }
  return boxes;
}

}  // namespace

CarSpace::Impl::Impl(const FreeSpace& free_space, const CarShape& car)
    : walls(free_space), shape(car), openings(openings_of(walls)), opening_boxes(boxes_of(walls, openings)) {}

void CarSpace::Impl::walls_near(const Box& box, Point origin, std::vector<NearWall>& near) const {
  near.clear();
  walls.walls_meeting(moved(box, origin), [&](std::uint32_t c) { near.emplace_back(walls.segment(c), origin); });
}

bool CarSpace::Impl::is_clear(const PreparedLeg& leg, const Leg& at, const std::vector<NearWall>& near) const {
  for (const NearWall& wall : near)
    if (leg.meets(wall, at, shape)) return false;
  if (openings.empty()) return true;
  bool leaves = false;
  opening_boxes.meeting(moved(leg.box(), at.from.at), [&](std::uint32_t i) {
    const std::uint32_t c = openings[i];
    leaves = leaves || leg.may_leave(walls.segment(c), walls.space().constraints()[c].solid_left, at);
  });
  return !leaves;
}

CarSpace::CarSpace(const FreeSpace& space, const CarShape& shape) : impl_(new Impl(space, shape)) {}
CarSpace::~CarSpace() = default;
CarSpace::CarSpace(CarSpace&&) noexcept = default;
CarSpace& CarSpace::operator=(CarSpace&&) noexcept = default;

const FreeSpace& CarSpace::space() const { return impl_->walls.space(); }
const CarShape& CarSpace::shape() const { return impl_->shape; }

bool CarSpace::is_free(const LatticePose& pose) const {
  if (space().locate(pose.at).kind == Location::Kind::outside) return false;
  // A straight leg of length 0 sweeps over the car itself.
  return is_clear({pose, pose});
}

bool CarSpace::is_clear(const Leg& leg) const {
  const PreparedLeg prepared(leg, shape());
  std::vector<NearWall> near;
  impl_->walls_near(prepared.box(), leg.from.at, near);
  return impl_->is_clear(prepared, leg, near);
}

}  // namespace taut::car
