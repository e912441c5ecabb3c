// Which boxes meet a box: Boost.Geometry's r-tree behind three lines.
#pragma once

#include <boost/geometry/core/cs.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/iterator/function_output_iterator.hpp>

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include <taut/geometry/point.h>

namespace taut::detail {

inline Box box_of(Point a, Point b) {
  return {{std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)}};
}

/// An immutable set of n closed boxes, known by index. Built in O(n log n); a query costs O(log n + answers) on usual inputs.
class BoxTree {
 public:
  explicit BoxTree(const std::vector<Box>& boxes) : tree_(entries(boxes)) {}

  /// Calls visit(index) for each box that meets `box`, in no particular order.
  template <class Visitor>
  void query(const Box& box, Visitor visit) const {
    tree_.query(boost::geometry::index::intersects(convert(box)),
                boost::iterators::make_function_output_iterator([&](const Entry& e) { visit(e.second); }));
  }

 private:
  using BoostPoint = boost::geometry::model::point<double, 2, boost::geometry::cs::cartesian>;
  using BoostBox = boost::geometry::model::box<BoostPoint>;
  using Entry = std::pair<BoostBox, std::uint32_t>;

  static BoostBox convert(const Box& b) { return {{b.min.x, b.min.y}, {b.max.x, b.max.y}}; }

  static std::vector<Entry> entries(const std::vector<Box>& boxes) {
    std::vector<Entry> result(boxes.size());
    for (std::uint32_t i = 0; i < boxes.size(); ++i) result[i] = {convert(boxes[i]), i};
    return result;
  }

  boost::geometry::index::rtree<Entry, boost::geometry::index::quadratic<16>> tree_;
};

}  // namespace taut::detail
