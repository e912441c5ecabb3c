// The nearest of a growing set of points.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <taut/geometry/point.h>

namespace taut {

/// A grid of buckets over numbered points, about two points a bucket, laid anew with each add(): for points that come
/// in batches, each a part of what there is. Nearer means: with the smaller squared distance, rounded; then with the
/// lower number.
class PrmNearest {
 public:
  std::size_t size() const { return points_.size(); }
  /// Numbers go on from size(). O(size).
  void add(std::span<const Point> points);

  /// The `count` nearest, nearest first; all when there are fewer. Expected O(count log count) for points spread
  /// evenly.
  std::vector<std::uint32_t> nearest(Point p, std::size_t count) const;
  /// All that are not farther than `radius`, nearest first.
  std::vector<std::uint32_t> within(Point p, double radius) const;

 private:
  using Rank = std::pair<double, std::uint32_t>;
  /// Buckets, first and last included.
  struct Block {
    int left, right, bottom, top;
  };

  void lay();
  int column(double x) const;
  int row(double y) const;
  void gather(Point p, const Block& block, std::vector<Rank>& ranks) const;
  double reach(Point p, const Block& block) const;

  std::vector<Point> points_;
  Box box_;
  double side_ = 1;  // of a bucket
  int columns_ = 1, rows_ = 1;
  std::vector<std::uint32_t> first_, numbers_;  // bucket -> its part of numbers_
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

}  // namespace taut
