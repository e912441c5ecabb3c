#include <taut/geometry/nearest_free.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <taut/geometry/segment_distance.h>
#include <taut/geometry/written.h>

namespace taut {

namespace {

using Kind = NearObstacle::Kind;

/// To the rectangle of the wall; negative inside.
double distance_to(const Wall& wall, Point p) {
  const double dx = wall.b.x - wall.a.x, dy = wall.b.y - wall.a.y, length = std::hypot(dx, dy);
  const double ux = length > 0 ? dx / length : 1, uy = length > 0 ? dy / length : 0;
  const double x = p.x - wall.a.x, y = p.y - wall.a.y, half = wall.thickness / 2;
  const double beyond = std::abs(ux * x + uy * y - length / 2) - length / 2 - half;
  const double beside = std::abs(ux * y - uy * x) - half;
  return std::min(std::max(beyond, beside), 0.0) + std::hypot(std::max(beyond, 0.0), std::max(beside, 0.0));
}

/// The side of the area's rings nearest to p, and how far.
NearObstacle nearest_side(const Area& area, Point p) {
  NearObstacle found{.distance = std::numeric_limits<double>::infinity(), .line = area.line};
  const auto consider = [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Segment side{ring[i], ring[(i + 1) % ring.size()]};
      const double distance = segment_distance_interval({p, p}, side).lo;
      if (distance >= found.distance) continue;
      found.distance = distance;
      found.side = side;
    }
  };
  consider(area.polygon.outer);
  std::ranges::for_each(area.polygon.holes, consider);
  return found;
}

bool lies_in(const Area& area, Point p) {
  return written::side_of_ring(p, area.polygon.outer) >= 0 &&
         std::none_of(area.polygon.holes.begin(), area.polygon.holes.end(),
                      [p](const Ring& hole) { return written::side_of_ring(p, hole) > 0; });
}

}  // namespace

bool is_in_world(const World& world, Point p) {
  return std::any_of(world.areas().begin(), world.areas().end(), [p](const Area& a) { return lies_in(a, p); });
}

NearObstacle nearest_obstacle(const World& world, Point p) {
  NearObstacle nearest{.distance = std::numeric_limits<double>::infinity()};
  const auto consider = [&](NearObstacle other, Kind kind, std::size_t index) {
    if (other.distance >= nearest.distance) return;
    nearest = other;
    nearest.kind = kind;
    nearest.index = static_cast<std::uint32_t>(index);
  };
  for (const Wall& wall : world.walls())
    consider({.side = {wall.a, wall.b}, .distance = distance_to(wall, p), .line = wall.line}, Kind::wall,
             static_cast<std::size_t>(&wall - world.walls().data()));
  const auto consider_area = [&](const Area& area, bool is_within, Kind kind, std::size_t index) {
    NearObstacle side = nearest_side(area, p);
    if (is_within) side.distance = -side.distance;
    consider(side, kind, index);
  };
  for (std::size_t i = 0; i < world.solids().size(); ++i)
    consider_area(world.solids()[i], lies_in(world.solids()[i], p), Kind::solid, i);
  const bool outside = !is_in_world(world, p);
  if (outside || world.boundary() == Boundary::walled)
    for (std::size_t i = 0; i < world.areas().size(); ++i) consider_area(world.areas()[i], outside, Kind::outline, i);
  return nearest;
}

std::string text(const NearObstacle& obstacle) {
  const auto [a, b] = obstacle.side;
  const std::string where = fmt::format("from ({}, {}) to ({}, {}){}", a.x, a.y, b.x, b.y,
                                        obstacle.line > 0 ? fmt::format(", line {}", obstacle.line) : "");
  switch (obstacle.kind) {
    case Kind::wall: return "the wall " + where;
    case Kind::solid: return "the obstacle with the side " + where;
    case Kind::outline: return "the outline " + where;
    case Kind::none: break;
  }
  return "an obstacle";
}

}  // namespace taut
