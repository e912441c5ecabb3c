#include <taut/search/funnel.h>

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include <taut/geometry/detail/expects.h>
#include <taut/geometry/predicates.h>

namespace taut {

namespace {

using Tri = Triangulation;

/// The two ends of a portal, as seen when passing it.
struct Portal {
  std::uint32_t right, left;
};

Portal portal_between(const Tri& tri, std::uint32_t t, std::uint32_t next) {
  for (int i = 0; i < 3; ++i)
    if (tri.neighbours[t][i] == next) return {tri.triangles[t][Tri::ccw(i)], tri.triangles[t][Tri::cw(i)]};
  TAUT_EXPECTS(!"consecutive triangles are neighbours");
  return {tri.triangles[t][0], tri.triangles[t][1]};
}

bool is_on(const Tri& tri, Point p, const Portal& portal) {
  return on_segment(p, tri.points[portal.right], tri.points[portal.left]);
}

/// Without the portals that an end lies on: these do not part it from the rest.
std::span<const Portal> trimmed(const Tri& tri, const Corridor& corridor, std::span<const Portal> portals) {
  while (!portals.empty() && is_on(tri, corridor.from, portals.front())) portals = portals.subspan(1);
  while (!portals.empty() && is_on(tri, corridor.to, portals.back())) portals = portals.first(portals.size() - 1);
  return portals;
}

/// A chain of the funnel that is taken from at both ends; chain[0] is the apex.
class Chain {
 public:
  void restart(Point apex) {
    points_.assign(1, apex);
    first_ = 0;
  }
  std::size_t size() const { return points_.size() - first_; }
  Point operator[](std::size_t i) const { return points_[first_ + i]; }
  Point last() const { return points_.back(); }
  Point before_last() const { return points_[points_.size() - 2]; }
  void push(Point p) { points_.push_back(p); }
  void pop_last() { points_.pop_back(); }
  void pop_apex() { ++first_; }

 private:
  std::vector<Point> points_;
  std::size_t first_ = 0;
};

/// The shortest paths from the start to both ends of the current portal: one path up to the apex, then two chains that bend away from each
/// other, the left one to the left.
class Funnel {
 public:
  explicit Funnel(Point from) : path_{from} {
    right_.restart(from);
    left_.restart(from);
  }

  void widen_right(Point p) { extend(right_, left_, p, 1); }
  void widen_left(Point p) { extend(left_, right_, p, -1); }

  /// To the goal, beyond the last portal.
  std::vector<Point> close(Point goal) {
    widen_right(goal);
    for (std::size_t i = 1; i < right_.size(); ++i) path_.push_back(right_[i]);
    return straightened(path_);
  }

 private:
  /// p is the next end of a portal on the side of `own`; `inward` is the sign of a turn towards the other side. (Three points in a line:
  /// p lies beyond the second one, since it lies beyond the portal.)
  void extend(Chain& own, Chain& other, Point p, int inward) {
    while (own.size() > 1 && orientation(own.before_last(), own.last(), p) * inward >= 0) own.pop_last();
    if (own.size() == 1) {
      while (other.size() > 1 && orientation(other[0], other[1], p) * inward >= 0) {
        other.pop_apex();
        path_.push_back(other[0]);
      }
      own.restart(other[0]);
    }
    own.push(p);
  }

  static std::vector<Point> straightened(const std::vector<Point>& points) {
    std::vector<Point> result;
    for (const Point p : points) {
      if (!result.empty() && result.back() == p) continue;
      while (result.size() > 1 && on_segment(result.back(), result[result.size() - 2], p)) result.pop_back();
      result.push_back(p);
    }
    return result;
  }

  std::vector<Point> path_;
  Chain right_, left_;
};

}  // namespace

Path funnel(const Triangulation& tri, const Corridor& corridor) {
  TAUT_EXPECTS(!corridor.triangles.empty());
  std::vector<Portal> all;
  for (std::size_t i = 0; i + 1 < corridor.triangles.size(); ++i)
    all.push_back(portal_between(tri, corridor.triangles[i], corridor.triangles[i + 1]));
  Funnel funnel(corridor.from);
  Portal last{kNone, kNone};
  for (const Portal& portal : trimmed(tri, corridor, all)) {
    if (portal.right != last.right) funnel.widen_right(tri.points[portal.right]);
    if (portal.left != last.left) funnel.widen_left(tri.points[portal.left]);
    last = portal;
  }
  Path path{funnel.close(corridor.to), {}};
  path.length = Length(path.points);
  return path;
}

std::optional<Path> shortened(const FreeSpace& space, const Path& path) {
  const auto corridor = corridor_of(space, path.points);
  if (!corridor) return std::nullopt;
  return funnel(space.triangulation(), *corridor);
}

}  // namespace taut
