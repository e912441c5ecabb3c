// A string through portals, pulled taut.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include <taut/geometry/written.h>

namespace taut::detail {

/// The shortest path through a sequence of portals between convex polygons, of which only the ends that change are
/// named. One after the other in the same memory. Exact. O(ends). It keeps the shortest paths from the start to both
/// ends of the current portal: one path up to the apex, then two chains that bend away from each other, the left one to
/// the left. (Lee, Preparata 1984; Chazelle 1982.)
class TautString {
 public:
  void begin(Point from) {
    path_.assign(1, from);
    right_.restart(from);
    left_.restart(from);
  }

  /// The next portal's right or left end, as seen when passing it.
  void widen_right(Point p) { extend(right_, left_, p, 1, path_); }
  void widen_left(Point p) { extend(left_, right_, p, -1, path_); }

  /// To the goal, beyond the last portal. Equal points are merged, points in a straight line left out.
  const std::vector<Point>& close(Point goal) {
    widen_right(goal);
    for (std::size_t i = 1; i < right_.size(); ++i) path_.push_back(right_[i]);
    straighten();
    return path_;
  }

 private:
  /// Taken from at both ends; chain[0] is the apex.
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

  /// p is the next end of a portal on the side of `own`; `inward` is the sign of a turn towards the other side.
  static void extend(Chain& own, Chain& other, Point p, int inward, std::vector<Point>& path) {
    while (own.size() > 1 && is_within(own.before_last(), own.last(), p, inward)) own.pop_last();
    if (own.size() == 1) {
      while (other.size() > 1 && is_within(other[0], other[1], p, inward)) {
        other.pop_apex();
        path.push_back(other[0]);
      }
      own.restart(other[0]);
    }
    own.push(p);
  }

  /// Is p on the inner side of a -> b, or in line and beyond? In line and not beyond, the string goes around b, or p is
  /// the near end of a portal that lies in line.
  static bool is_within(Point a, Point b, Point p, int inward) {
    const int turn = written::orientation(a, b, p) * inward;
    if (turn != 0) return turn > 0;
    return std::min(a.x, p.x) <= b.x && b.x <= std::max(a.x, p.x) && std::min(a.y, p.y) <= b.y &&
           b.y <= std::max(a.y, p.y);
  }

  void straighten() {
    std::size_t size = 0;
    for (const Point p : path_) {
      if (size > 0 && path_[size - 1] == p) continue;
      while (size > 1 && written::on_segment(path_[size - 1], path_[size - 2], p)) --size;
      path_[size++] = p;
    }
    path_.resize(size);
  }

  std::vector<Point> path_;
  Chain right_, left_;
};

}  // namespace taut::detail
