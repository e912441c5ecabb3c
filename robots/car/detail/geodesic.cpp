#include <taut/robots/car/detail/geodesic.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <taut/search/roadmap_distances.h>

namespace taut::car::detail {

namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr double kDown = 1 - 1e-9;    // of sums of many lengths: far more than they round
constexpr double kInside = 1 - 1e-6;  // of the disc: far more than free space is rounded by

double distance(Point p, Point q) { return std::hypot(p.x - q.x, p.y - q.y); }

Footprint polygon_inside(double radius) {
  if (radius <= 0) return Footprint::point();
  constexpr int kSides = 16;
  Ring ring;
  for (int i = 0; i < kSides; ++i) {
    const double angle = (2 * i + 1) * std::numbers::pi / kSides;
    ring.push_back({radius * kInside * std::cos(angle), radius * kInside * std::sin(angle)});
  }
  return Footprint::polygon(std::move(ring));
}

}  // namespace

Geodesic::Geodesic(const World& world, double radius, const std::vector<Point>& goals)
    : graph_(std::make_unique<VisibilityGraph>(FreeSpace(world, polygon_inside(radius)))) {
  const Roadmap& roadmap = graph_->roadmap();
  std::vector<RoadmapSource> seen;
  for (const Point goal : goals) {
    if (graph_->space().locate(goal).kind == Location::Kind::outside) continue;
    goals_.push_back(goal);
    for (const Roadmap::Vertex v : graph_->visible_from(goal)) seen.push_back({v, distance(roadmap.point(v), goal)});
  }
  length_ = roadmap_distances(roadmap, seen).length;
}

double Geodesic::from(Point p) const {
  const FreeSpace& space = graph_->space();
  if (space.locate(p).kind == Location::Kind::outside) return kInfinite;
  double least = kInfinite;
  for (const Roadmap::Vertex v : graph_->visible_from(p))
    least = std::min(least, length_[v] + distance(graph_->roadmap().point(v), p));
  for (const Point goal : goals_)
    if (const double straight = distance(goal, p); straight < least && space.sees(p, goal)) least = straight;
  return kDown * least;
}

}  // namespace taut::car::detail
