// What a journey leaves behind: the way walked, where contours were hit and left, and what it may cost.
#pragma once

#include <map>
#include <vector>

#include <taut/robots/bug/bug.h>
#include <taut/robots/bug/detail/place.h>
#include <taut/robots/bug/detail/trail.h>

namespace taut::bug::detail {

Interval sum(Interval a, Interval b);
Interval product(Interval a, double factor);

/// Writes a Journey. Keeps references.
class Logbook {
 public:
  Logbook(const ContourPlaces& places, Point from, Point goal)
      : places_(places), goal_(goal), trail_(places.tri(), from) {
    journey_.bound = distance_interval(from, goal);
  }

  /// Straight, to the goal or to a stand.
  void walk(const Walk& walk) { trail_.add(walk, goal_); }
  void walk(const Walk& walk, const Stand& to) { trail_.add(walk, round(to)); }
  /// Along a contour from a to b; once around when they are the same.
  void follow(const ContourPlace& a, const ContourPlace& b, Turn turn);

  /// Calls visit(vertex) for all vertices between a and b; once around when they are the same.
  template <typename Visit>
  void each_vertex(const ContourPlace& a, const ContourPlace& b, Turn turn, Visit visit) const {
    const std::uint32_t n = places_.stations(a.contour);
    const bool left = turn == Turn::left;
    if (a.station == b.station && !a.is_vertex() && a.stand.at != b.stand.at && places_.is_ahead(a, b) == left) return;
    std::uint32_t at = a.station;
    do {
      at = left ? (at + 1) % n : (at + n - 1) % n;
      if (at % 2 == 0 && at != b.station) visit(places_.contours().tail({a.contour, at / 2}));
    } while (at != b.station);
  }

  /// The contour as one of the obstacles.
  Obstacle& obstacle(std::uint32_t contour);
  /// A contact with one.
  Obstacle& note(const Stand& at, std::uint32_t contour, std::vector<Contact>& contacts);
  void add_bound(Interval more) { journey_.bound = sum(journey_.bound, more); }

  std::size_t points() const { return trail_.points().size(); }
  Journey& journey() { return journey_; }
  Journey finish();

 private:
  Point round(const Stand& stand);
  std::uint32_t number(std::uint32_t contour);

  const ContourPlaces& places_;
  Point goal_;
  Trail trail_;
  Journey journey_;
  std::map<std::uint32_t, std::uint32_t> numbers_;  // contour -> obstacle
};

}  // namespace taut::bug::detail
