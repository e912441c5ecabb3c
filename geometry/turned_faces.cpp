#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include <taut/geometry/detail/implied_area.h>
#include <taut/geometry/detail/obstacles.h>

namespace taut::detail {

namespace {

constexpr std::size_t kHullCorners = 64;  // of more nobody built a hall

double distance(Point p, Point q) { return std::hypot(p.x - q.x, p.y - q.y); }

// A line with a direction: how far along it a point lies, and how far to the left.
class Ruler {
 public:
  Ruler(Point from, Point to) : from_(from), length_(distance(from, to)) {
    x_ = (to.x - from.x) / length_;
    y_ = (to.y - from.y) / length_;
  }
  double length() const { return length_; }
  double along(Point p) const { return (p.x - from_.x) * x_ + (p.y - from_.y) * y_; }
  double left(Point p) const { return (p.y - from_.y) * x_ - (p.x - from_.x) * y_; }
  Point at(double along, double left) const {
    return {from_.x + along * x_ - left * y_, from_.y + along * y_ + left * x_};
  }

 private:
  Point from_;
  double length_, x_ = 0, y_ = 0;
};

std::size_t farthest(const Ring& ring, Point p) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < ring.size(); ++i)
    if (distance(ring[i], p) > distance(ring[best], p)) best = i;
  return best;
}

// A convex ring without the corners that rounding alone may have made. The farthest point from anywhere is a true one.
Ring simplified(Ring ring, double reach) {
  std::rotate(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(farthest(ring, ring[farthest(ring, ring[0])])),
              ring.end());
  ring.push_back(ring.front());
  Ring kept{ring.front()};
  std::size_t from = 0;
  for (std::size_t to = 2; to < ring.size(); ++to) {
    if (ring[from] == ring[to]) continue;
    const Ruler ruler(ring[from], ring[to]);
    double most = 0;
    for (std::size_t i = from + 1; i < to; ++i) most = std::max(most, std::abs(ruler.left(ring[i])));
    if (most > reach) kept.push_back(ring[from = to - 1]);
  }
  return kept;
}

// With one side along a -> b.
Ring rectangle(const Ring& hull, Point a, Point b) {
  const Ruler ruler(a, b);
  double least = 0, most = ruler.length(), width = 0;
  for (const Point p : hull) {
    least = std::min(least, ruler.along(p));
    most = std::max(most, ruler.along(p));
    width = std::max(width, ruler.left(p));
  }
  return {ruler.at(least, 0), ruler.at(most, 0), ruler.at(most, width), ruler.at(least, width)};
}

}  // namespace

Ring passed_through(const Ring& ring, const std::vector<Point>& points, double reach) {
  Ring corners = ring;
  for (Point& corner : corners)
    for (const Point p : points)
      if (distance(p, corner) <= reach) {
        corner = p;
        break;
      }
  Ring result;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Ruler ruler(ring[i], ring[(i + 1) % ring.size()]);
    std::vector<std::pair<double, Point>> on_side;
    for (const Point p : points)
      if (std::abs(ruler.left(p)) <= reach && ruler.along(p) > reach && ruler.along(p) < ruler.length() - reach)
        on_side.emplace_back(ruler.along(p), p);
    std::sort(on_side.begin(), on_side.end());
    result.push_back(corners[i]);
    for (const auto& [along, p] : on_side)
      if (p != result.back()) result.push_back(p);
  }
  return result;
}

TurnedFaces turned_faces(const std::vector<Wall>& walls, const std::vector<Point>& points, double reach) {
  std::vector<Point> ends;
  for (const Wall& wall : walls) ends.insert(ends.end(), {wall.a, wall.b});
  const Ring exact = convex_hull(std::move(ends));
  if (exact.size() < 3) return {};
  const Ring hull = simplified(exact, reach);
  if (hull.size() < 3) return {};
  double around = 0;
  for (std::size_t i = 0; i < hull.size(); ++i) around += distance(hull[i], hull[(i + 1) % hull.size()]);
  TurnedFaces faces;
  // Of a rectangle that is half covered one side is covered on an eighth of the whole length.
  for (std::size_t i = 0; i < hull.size(); ++i)
    if (const Point a = hull[i], b = hull[(i + 1) % hull.size()]; distance(a, b) > around / 8 - 2 * reach)
      faces.rectangles.push_back(passed_through(rectangle(hull, a, b), points, reach));
  if (hull.size() <= kHullCorners) faces.hull = passed_through(hull, points, reach);
  return faces;
}

}  // namespace taut::detail
