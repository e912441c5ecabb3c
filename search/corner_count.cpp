#include <taut/search/corner_count.h>

#include <cmath>
#include <vector>

#include <taut/geometry/written.h>

namespace taut {

namespace {

/// How far p lies from the line through a and b.
double from_line(Point p, Point a, Point b) {
  const double dx = b.x - a.x, dy = b.y - a.y, length = std::hypot(dx, dy);
  if (length == 0) return std::hypot(p.x - a.x, p.y - a.y);
  return std::abs(dx * (p.y - a.y) - dy * (p.x - a.x)) / length;
}

double distance(Point p, Point q) { return std::hypot(q.x - p.x, q.y - p.y); }

/// Does a path from a over p to b turn back? Points nearer than they are certain have no order.
bool turns_back(Point a, Point p, Point b, double slack) {
  if (distance(a, p) <= slack || distance(p, b) <= slack) return false;
  return (p.x - a.x) * (b.x - p.x) + (p.y - a.y) * (b.y - p.y) <= 0;
}

bool is_straight(std::span<const Point> points, double slack) {
  const Point from = points.front(), to = points.back();
  for (const Point p : points.subspan(1, points.size() - 2)) {
    if (from_line(p, from, to) > slack && written::orientation(from, p, to) != 0) return false;
    if (turns_back(from, p, to, slack)) return false;
  }
  return true;
}

std::size_t bends(std::span<const Point> points) {
  std::size_t count = 0;
  for (std::size_t i = 1; i + 1 < points.size(); ++i)
    count += !written::on_segment(points[i], points[i - 1], points[i + 1]);
  return count;
}

/// Those that no shift of the points by half of `slack` explains.
std::size_t certain_bends(std::span<const Point> points, double slack) {
  std::size_t count = 0, from = 0;
  for (std::size_t to = 2; to < points.size(); ++to) {
    if (is_straight(points.subspan(from, to - from + 1), slack)) continue;
    ++count;
    from = to - 1;
  }
  return count;
}

}  // namespace

std::size_t corner_count(std::span<const Point> points, double uncertainty) {
  std::vector<Point> chain;
  for (const Point p : points)
    if (chain.empty() || chain.back() != p) chain.push_back(p);
  return uncertainty == 0 ? bends(chain) : certain_bends(chain, 2 * uncertainty);
}

}  // namespace taut
