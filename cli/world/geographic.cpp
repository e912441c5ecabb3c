#include <taut/cli/world/geographic.h>

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include <taut/search/query_ends.h>

namespace taut::cli {

Goal Shown::operator()(Goal goal) const {
  if (goal.point) goal.point = (*this)(*goal.point);
  goal.room = (*this)(std::move(goal.room));
  return goal;
}

Barrier Shown::operator()(Barrier barrier) const {
  barrier.walls = (*this)(std::move(barrier.walls));
  for (NamedGate& gate : barrier.gates) gate.at = (*this)(gate.at);
  return barrier;
}

FreePlace Shown::operator()(FreePlace place) const {
  place.point = (*this)(place.point);
  return place;
}

PlanResult Shown::operator()(PlanResult result) const {
  if (!geographic_) return result;
  result.path.points = (*this)(std::move(result.path.points));
  result.separation = (*this)(std::move(result.separation));
  if (result.start) result.start = (*this)(*result.start);
  result.goal = (*this)(std::move(result.goal));
  if (result.overestimate) result.overestimate->at = (*this)(result.overestimate->at);
  const Point scale = geographic_->metres_a_degree();
  result.uncertainty /= std::min(scale.x, scale.y);  // of the points, which corners are counted by
  return result;
}

Json Shown::json(const std::vector<Point>& path, double length) const {
  if (!geographic_) return nullptr;
  Json json{{"centre", geographic_->centre()},
            {"metres_a_degree", geographic_->metres_a_degree()},
            {"unit", geographic_->unit()},
            {"relative_error", geographic_->relative_error()}};
  if (!path.empty()) json["error"] = geographic_->length_error(path, length);
  return json;
}

std::string blocked_text(const World& world, Point p, std::string_view role, const std::optional<FreePlace>& nearest,
                         const Shown& shown) {
  if (!shown) return taut::blocked_text(world, p, role, nearest);
  NearObstacle near = nearest_obstacle(world, p);
  near.side = shown(near.side);
  const std::string depth = nearest ? fmt::format("{:.6g} m ", nearest->distance) : "";
  const std::string where = !is_in_world(world, p) ? "lies " + depth + "outside the world"
                            : near.distance < 0    ? "lies " + depth + "inside " + text(near)
                                                   : "is " + depth + "too near for the robot to " + text(near);
  const Point at = shown(p), place = nearest ? shown(nearest->point) : Point{};
  return fmt::format("{} ({}, {}) {}; {}", role, at.x, at.y, where,
                     nearest ? fmt::format("nearest free point ({}, {})", place.x, place.y) : "the robot fits nowhere");
}

void require_free(const FreeSpace& space, Point p, std::string_view role, const Shown& shown) {
  if (!shown) return taut::require_free(space, p, role);
  if (space.locate(p).kind != Location::Kind::outside) return;
  throw InputError(space.world().source(), 0, blocked_text(space.world(), p, role, nearest_free(space, p), shown));
}

}  // namespace taut::cli
