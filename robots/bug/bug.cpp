#include <taut/robots/bug/bug.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <taut/geometry/written.h>
#include <taut/robots/bug/detail/contours.h>
#include <taut/robots/bug/detail/heading.h>
#include <taut/robots/bug/detail/logbook.h>
#include <taut/robots/bug/detail/tangent.h>
#include <taut/search/query_ends.h>

namespace taut::bug {

namespace {

using detail::ContourPlace;
using detail::ContourPlaces;
using detail::Contours;
using detail::product;
using detail::Spot;
using detail::squared_distance;
using detail::Stand;
using detail::Walk;
using Tri = Triangulation;

/// Bug 1 and Bug 2, from one stand.
class Run {
 public:
  Run(const ContourPlaces& places, Point from, Point goal, const Options& options)
      : places_(places), from_(from), goal_(goal), options_(options), log_(places, from, goal) {}

  Journey from(Stand stand) {
    ExactPoint line(from_);
    while (!finished_) {
      const Walk walk = detail::walk_to(places_.tri(), stand, line, Spot(goal_));
      if (walk.reached) {
        log_.walk(walk);
        log_.journey().reached = true;
        break;
      }
      const ContourPlace hit = places_.at(walk.end);
      log_.walk(walk, walk.end);
      stand = after(hit).stand;
      if (options_.algorithm == Algorithm::bug1) line = stand.at;
    }
    for (const Obstacle& o : log_.journey().obstacles)
      log_.add_bound(
          product(o.perimeter, options_.algorithm == Algorithm::bug1 ? 1.5 : static_cast<double>(o.entries)));
    return log_.finish();
  }

 private:
  /// What follows a hit: the place where the robot leaves; finished_ when there is none, or the goal is on the contour.
  ContourPlace after(const ContourPlace& hit) {
    Obstacle& obstacle = log_.note(hit.stand, hit.contour, log_.journey().hits);
    if (++obstacle.hits == 1) obstacle.entries = entries(hit.contour);
    const std::optional<ContourPlace> goal = goal_on(hit);
    if (options_.algorithm == Algorithm::bug1) return goal ? arrive(hit, *goal) : after_bug1(hit);
    const std::optional<ContourPlace> leave = next_on_line(hit);
    if (goal && (!leave || steps(hit, goal->station) < steps(hit, leave->station))) return arrive(hit, *goal);
    if (!leave) return give_up(hit);
    log_.follow(hit, *leave, options_.turn);
    log_.note(leave->stand, leave->contour, log_.journey().leaves);
    return *leave;
  }

  ContourPlace after_bug1(const ContourPlace& hit) {
    const std::optional<ContourPlace> leave = nearest_open(hit.contour);
    if (!leave) return give_up(hit);
    log_.follow(hit, hit, options_.turn);
    const Turn other = options_.turn == Turn::left ? Turn::right : Turn::left;
    log_.follow(hit, *leave,
                way_length(hit, *leave, other) < way_length(hit, *leave, options_.turn) ? other : options_.turn);
    log_.note(leave->stand, leave->contour, log_.journey().leaves);
    return *leave;
  }

  ContourPlace arrive(const ContourPlace& hit, const ContourPlace& goal) {
    log_.follow(hit, goal, options_.turn);
    log_.journey().reached = true;
    finished_ = true;
    return goal;
  }

  ContourPlace give_up(const ContourPlace& hit) {
    log_.follow(hit, hit, options_.turn);
    finished_ = true;
    return hit;
  }

  std::uint32_t steps(const ContourPlace& from, std::uint32_t to) const {
    return places_.steps(from, to, options_.turn);
  }
  Point tail(Contours::At at) const { return places_.contours().tail(at); }
  Point head(Contours::At at) const { return places_.contours().head(at); }

  double way_length(const ContourPlace& a, const ContourPlace& b, Turn turn) const {
    if (a.station == b.station && a.stand.at == b.stand.at) return 0;
    const auto as_point = [](const ContourPlace& p) { return Point{to_double(p.stand.at.x), to_double(p.stand.at.y)}; };
    Point last = as_point(a);
    double length = 0;
    const auto to = [&](Point p) {
      length += std::hypot(p.x - last.x, p.y - last.y);
      last = p;
    };
    log_.each_vertex(a, b, turn, to);
    to(as_point(b));
    return length;
  }

  /// The first place of the contour, from the hit on, where the goal is.
  std::optional<ContourPlace> goal_on(const ContourPlace& hit) const {
    for (std::uint32_t j = 1; j < places_.stations(hit.contour); ++j) {
      const std::uint32_t at = places_.station(hit, j, options_.turn);
      const Contours::At edge{hit.contour, at / 2};
      if (at % 2 == 0 && tail(edge) == goal_) return places_.vertex(edge);
      if (at % 2 == 0 || tail(edge) == goal_ || head(edge) == goal_) continue;
      if (written::on_segment(goal_, tail(edge), head(edge))) return places_.side(edge, ExactPoint(goal_));
    }
    if (!hit.is_vertex() && written::on_segment(goal_, tail(hit.edge()), head(hit.edge())))
      return places_.side(hit.edge(), ExactPoint(goal_));
    return std::nullopt;
  }

  // ---- Bug 1 -----------------------------------------------------------------------------------------------------

  /// Keeps the nearest places seen so far.
  struct Nearest {
    std::optional<Rational> distance;
    std::vector<ContourPlace> places;

    void offer(const Rational& d, ContourPlace place) {
      if (distance && d > *distance) return;
      if (!distance || d < *distance) places.clear();
      distance = d;
      places.push_back(std::move(place));
    }
  };

  std::optional<ContourPlace> nearest_open(std::uint32_t contour) const {
    Nearest nearest;
    const ExactPoint goal(goal_);
    for (std::uint32_t k = 0; k < places_.contours().edges(contour).size(); ++k) {
      const Contours::At at{contour, k};
      nearest.offer(squared_distance(ExactPoint(tail(at)), goal), places_.vertex(at));
      if (const ContourPlace foot = places_.on(at, detail::nearest_on(tail(at), head(at), goal)); !foot.is_vertex())
        nearest.offer(squared_distance(foot.stand.at, goal), foot);
    }
    for (const ContourPlace& p : nearest.places)
      if (detail::leads_off(places_.tri(), p.stand, goal_)) return p;
    return std::nullopt;
  }

  // ---- Bug 2 -----------------------------------------------------------------------------------------------------

  /// Is p, on the m-line, at `after` or beyond, and not beyond the goal?
  bool is_between(const ExactPoint& p, const ExactPoint& after) const {
    const ExactPoint g(goal_);
    const auto ordered = [](const Rational& a, const Rational& b, const Rational& c) {
      return (a <= b && b <= c) || (a >= b && b >= c);
    };
    return ordered(after.x, p.x, g.x) && ordered(after.y, p.y, g.y);
  }

  /// The place of a station that is on the m-line, between `after` and the goal; sides along the m-line have none.
  std::optional<ContourPlace> on_line(std::uint32_t contour, std::uint32_t station, const ExactPoint& after) const {
    const Contours::At at{contour, station / 2};
    const Point here = tail(at);
    const int o = written::orientation(from_, goal_, here);
    std::optional<ContourPlace> found;
    if (station % 2 == 0) {
      if (o == 0) found = places_.vertex(at);
    } else if (o * written::orientation(from_, goal_, head(at)) < 0) {
      found = places_.side(at, taut::line_crossing({from_, goal_}, {here, head(at)}));
    }
    return found && is_between(found->stand.at, after) ? found : std::nullopt;
  }

  std::optional<ContourPlace> next_on_line(const ContourPlace& hit) const {
    for (std::uint32_t j = 1; j < places_.stations(hit.contour); ++j)
      if (auto p = on_line(hit.contour, places_.station(hit, j, options_.turn), hit.stand.at);
          p && p->stand.at != ExactPoint(goal_) && detail::leads_off(places_.tri(), p->stand, goal_))
        return p;
    return std::nullopt;
  }

  /// ContourPlaces of the contour in which the m-line, coming from the start, is blocked.
  std::size_t entries(std::uint32_t contour) const {
    std::size_t count = 0;
    if (options_.algorithm == Algorithm::bug1) return 0;
    const ExactPoint start(from_);
    for (std::uint32_t s = 0; s < places_.stations(contour); ++s)
      if (const auto p = on_line(contour, s, start); p && p->stand.at != ExactPoint(goal_))
        count += !detail::is_open(places_.tri(), p->stand, goal_) &&
                 (p->stand.at == start || detail::is_open(places_.tri(), p->stand, from_));
    return count;
  }

  const ContourPlaces& places_;
  Point from_, goal_;
  Options options_;
  detail::Logbook log_;
  bool finished_ = false;
};

/// Where a robot at p can stand, places that are open to the goal first.
std::vector<Stand> stands(const FreeSpace& space, Point p, Point goal) {
  const Tri& tri = space.triangulation();
  const Location at = space.locate(p);
  std::vector<Stand> all;
  if (at.kind == Location::Kind::triangle) all.push_back({Stand::Kind::open, at.triangle, 0, kNone, ExactPoint(p)});
  if (at.kind == Location::Kind::side) {
    all.push_back({Stand::Kind::side, at.triangle, at.index, kNone, ExactPoint(p)});
    const std::uint32_t n = tri.neighbours[at.triangle][at.index];
    if (n != kNone && tri.free[n])
      all.push_back({Stand::Kind::side, n, tri.mirror(at.triangle, at.index), kNone, ExactPoint(p)});
  }
  if (at.kind == Location::Kind::vertex)
    for (const Tri::Sector& s : tri.sectors_at(tri.triangles[at.triangle][at.index]))
      all.push_back(
          {Stand::Kind::vertex, s.triangle, 0, static_cast<std::uint32_t>(&s - tri.sectors.data()), ExactPoint(p)});
  std::stable_partition(all.begin(), all.end(), [&](const Stand& s) { return detail::is_open(tri, s, goal); });
  return all;
}

}  // namespace

std::string_view name(Algorithm algorithm) {
  return algorithm == Algorithm::bug1 ? "bug1" : algorithm == Algorithm::bug2 ? "bug2" : "tangent";
}

Journey travel(const FreeSpace& space, Point from, Point to, const Options& options) {
  require_free(space, from, "start");
  require_free(space, to, "goal");
  Journey journey;
  if (from == to) {
    journey.reached = true;
    journey.path.points = {from};
    return journey;
  }
  const Contours contours(space.triangulation());
  const ContourPlaces places(space.triangulation(), contours);
  for (const Stand& stand : stands(space, from, to)) {
    journey = options.algorithm == Algorithm::tangent ? detail::tangent_journey(places, stand, from, to, options)
                                                      : Run(places, from, to, options).from(stand);
    if (journey.reached) break;
  }
  return journey;
}

}  // namespace taut::bug
