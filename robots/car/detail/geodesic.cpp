#include <taut/robots/car/detail/geodesic.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <queue>
#include <utility>

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
    : graph_(std::make_unique<VisibilityGraph>(FreeSpace(world, polygon_inside(radius)))),
      length_(graph_->roadmap().vertex_count(), kInfinite) {
  const Roadmap& roadmap = graph_->roadmap();
  using Entry = std::pair<double, Roadmap::Vertex>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  const auto reach = [&](Roadmap::Vertex v, double length) {
    if (length >= length_[v]) return;
    length_[v] = length;
    open.emplace(length, v);
  };
  for (const Point goal : goals) {
    if (graph_->space().locate(goal).kind == Location::Kind::outside) continue;
    goals_.push_back(goal);
    for (const Roadmap::Vertex v : graph_->visible_from(goal)) reach(v, distance(roadmap.point(v), goal));
  }
  while (!open.empty()) {
    const auto [length, v] = open.top();
    open.pop();
    if (length > length_[v]) continue;
    for (const Roadmap::Vertex w : roadmap.neighbours(v))
      reach(w, length + distance(roadmap.point(v), roadmap.point(w)));
  }
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
