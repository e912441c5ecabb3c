#include <taut/search/corner_count.h>

#include <vector>

#include <taut/geometry/written.h>

namespace taut {

std::size_t corner_count(std::span<const Point> chain) {
  std::vector<Point> points;
  for (const Point p : chain)
    if (points.empty() || points.back() != p) points.push_back(p);
  std::size_t count = 0;
  for (std::size_t i = 1; i + 1 < points.size(); ++i)
    count += !written::on_segment(points[i], points[i - 1], points[i + 1]);
  return count;
}

}  // namespace taut
