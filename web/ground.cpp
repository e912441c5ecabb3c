#include <taut/web/detail/ground.h>

#include <utility>

#include <taut/geometry/nearest_free.h>

namespace taut::web {

Ground::Ground(World world, ReadNotes notes) : space_(std::move(world)), notes_(std::move(notes)) {}

const Polyanya& Ground::polyanya() {
  if (!polyanya_) polyanya_.emplace(space_);
  return *polyanya_;
}

PolyanyaSearch& Ground::search() {
  if (!search_) search_.emplace(polyanya());
  return *search_;
}

const Navmesh& Ground::mesh() { return polyanya().mesh(); }

const NoPath& Ground::no_path() {
  if (!no_path_) no_path_ = std::make_unique<NoPath>(space_);
  return *no_path_;
}

const Gates& Ground::gates() {
  if (!gates_) gates_.emplace(space_);
  return *gates_;
}

const TangentGraph& Ground::tangents(double radius) {
  if (!tangents_ || tangents_->radius() != radius) tangents_.emplace(space_, radius);
  return *tangents_;
}

Ends ends_to_begin_with(const Ground& ground) {
  const World& world = ground.world();
  Ends ends{world.start(), world.goal()};
  const Box box = world.box();
  const auto place = [&](double share) -> std::optional<Point> {
    const Point p{box.min.x + share * (box.max.x - box.min.x), box.min.y + share * (box.max.y - box.min.y)};
    const std::optional<FreePlace> near = nearest_free(ground.space(), p);
    return near ? std::optional(near->point) : std::nullopt;
  };
  constexpr double kNearCorner = 0.05;
  if (!ends.start) ends.start = place(kNearCorner);
  if (!ends.goal.point && ends.goal.room.empty()) ends.goal.point = place(1 - kNearCorner);
  return ends;
}

}  // namespace taut::web
