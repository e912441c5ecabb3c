// The nearest of a growing set of points. Private.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <taut/geometry/point.h>

namespace taut::detail {

/// An R-tree (Boost.Geometry) over numbered points. Nearer means: with the smaller squared distance, rounded; then with the lower number.
class PrmNearest {
 public:
  PrmNearest();
  ~PrmNearest();
  PrmNearest(PrmNearest&&) noexcept;

  std::size_t size() const { return points_.size(); }
  /// Numbers go on from size().
  void add(std::span<const Point> points);

  /// The `count` nearest, nearest first; all when there are fewer.
  std::vector<std::uint32_t> nearest(Point p, std::size_t count) const;
  /// All that are not farther than `radius`, nearest first.
  std::vector<std::uint32_t> within(Point p, double radius) const;

 private:
  struct Tree;
  std::vector<Point> points_;
  std::unique_ptr<Tree> tree_;
};

/// The first `count` points, by distance from p, for which accept(number) holds, among the `among` nearest. Asks about
/// them in that order, and about no more than it needs.
template <class Accept>
std::vector<std::uint32_t> nearest_accepted(const PrmNearest& points, Point p, std::size_t count, std::size_t among,
                                            Accept&& accept) {
  std::vector<std::uint32_t> result;
  const std::size_t last = among < points.size() ? among : points.size();
  std::size_t done = 0;
  for (std::size_t reach = 4 * count + 1; done < last && result.size() < count; reach *= 4) {
    const std::vector<std::uint32_t> found = points.nearest(p, reach < last ? reach : last);
    for (; done < found.size() && result.size() < count; ++done)
      if (accept(found[done])) result.push_back(found[done]);
  }
  return result;
}

}  // namespace taut::detail
