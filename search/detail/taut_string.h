// A string through portals, pulled taut.
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include <taut/geometry/written.h>

namespace taut::detail {

/// Points as they are written.
struct WrittenSides {
  using Place = Point;

  /// On which side of a -> b does p lie? +1 left, 0 in line.
  int turn(Point a, Point b, Point p) const { return written::orientation(a, b, p); }
  /// Of three in line: does b lie between a and p, or at one of them?
  bool is_between(Point a, Point b, Point p) const {
    return std::min(a.x, p.x) <= b.x && b.x <= std::max(a.x, p.x) && std::min(a.y, p.y) <= b.y &&
           b.y <= std::max(a.y, p.y);
  }
};

/// The shortest path through a sequence of portals between convex polygons, of which only the ends that change are
/// named. One after the other in the same memory. As exact as Sides, which WrittenSides describes. O(ends). It keeps
/// the shortest paths from the start to both ends of the current portal: one path up to the apex, then two chains that
/// bend away from each other, the left one to the left. (Lee, Preparata 1984; Chazelle 1982.)
template <class Sides>
class TautStringOf {
 public:
  using Place = typename Sides::Place;

  explicit TautStringOf(Sides sides = {}) : sides_(std::move(sides)) {}
  Sides& sides() { return sides_; }

  void begin(const Place& from) {
    path_.assign(1, from);
    right_.restart(from);
    left_.restart(from);
  }

  /// The next portal's right or left end, as seen when passing it.
  void widen_right(const Place& p) { extend<1>(right_, left_, p); }
  void widen_left(const Place& p) { extend<-1>(left_, right_, p); }

  /// To the goal, beyond the last portal. Equal points are merged, points in a straight line left out.
  const std::vector<Place>& close(const Place& goal) {
    widen_right(goal);
    for (std::size_t i = 1; i < right_.size(); ++i) path_.push_back(right_[i]);
    straighten();
    return path_;
  }

 private:
  /// Taken from at both ends; chain[0] is the apex.
  class Chain {
   public:
    void restart(const Place& apex) {
      first_ = last_ = 0;
      points_[0] = apex;
    }
    std::size_t size() const { return last_ - first_ + 1; }
    const Place& operator[](std::size_t i) const { return points_[first_ + i]; }
    const Place& last() const { return points_[last_]; }
    const Place& before_last() const { return points_[last_ - 1]; }
    void push(const Place& p) {
      if (++last_ == points_.size()) points_.resize(2 * points_.size());
      points_[last_] = p;
    }
    void pop_last() { --last_; }
    void pop_apex() { ++first_; }

   private:
    std::vector<Place> points_ = std::vector<Place>(64);
    std::size_t first_ = 0, last_ = 0;
  };

  /// p is the next end of a portal on the side of `own`; `inward` is the sign of a turn towards the other side.
  template <int inward>
  void extend(Chain& own, Chain& other, const Place& p) {
    while (own.size() > 1 && is_within(own.before_last(), own.last(), p, inward)) own.pop_last();
    if (own.size() == 1) {
      while (other.size() > 1 && is_within(other[0], other[1], p, inward)) {
        other.pop_apex();
        path_.push_back(other[0]);
      }
      own.restart(Place(other[0]));
    }
    own.push(p);
  }

  /// Is p on the inner side of a -> b, or in line and beyond? In line and not beyond, the string goes around b, or p is
  /// the near end of a portal that lies in line.
  bool is_within(const Place& a, const Place& b, const Place& p, int inward) const {
    const int turn = sides_.turn(a, b, p) * inward;
    return turn != 0 ? turn > 0 : sides_.is_between(a, b, p);
  }

  void straighten() {
    std::size_t size = 0;
    for (const Place p : path_) {
      if (size > 0 && path_[size - 1] == p) continue;
      while (size > 1 && sides_.turn(path_[size - 2], path_[size - 1], p) == 0 &&
             sides_.is_between(path_[size - 2], path_[size - 1], p))
        --size;
      path_[size++] = p;
    }
    path_.resize(size);
  }

  Sides sides_;
  std::vector<Place> path_;
  Chain right_, left_;
};

using TautString = TautStringOf<WrittenSides>;

}  // namespace taut::detail
