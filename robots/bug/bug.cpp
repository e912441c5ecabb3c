#include <taut/robots/bug/bug.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include <taut/geometry/predicates.h>
#include <taut/robots/bug/detail/contours.h>
#include <taut/robots/bug/detail/heading.h>
#include <taut/robots/bug/detail/trail.h>
#include <taut/search/query_ends.h>

namespace taut::bug {

namespace {

using detail::Contours;
using detail::ExactPoint;
using detail::Stand;
using detail::Walk;
using Tri = Triangulation;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Interval sum(Interval a, Interval b) {
  return {std::nextafter(a.lo + b.lo, -kInfinity), std::nextafter(a.hi + b.hi, kInfinity)};
}

Interval product(Interval a, double factor) {
  return {std::nextafter(a.lo * factor, -kInfinity), std::nextafter(a.hi * factor, kInfinity)};
}

mpq_class squared_distance(const ExactPoint& a, Point b) {
  const mpq_class dx = a.x - b.x, dy = a.y - b.y;
  return dx * dx + dy * dy;
}

/// A place on a contour. Stations 2k and 2k + 1 are the tail of half-edge k and its inside.
struct Place {
  std::uint32_t contour = kNone;
  std::uint32_t station = 0;
  Stand stand;

  Contours::At edge() const { return {contour, station / 2}; }
  bool is_vertex() const { return station % 2 == 0; }
};

class Run {
 public:
  Run(const Tri& tri, const Contours& contours, Point from, Point goal, const Options& options)
      : tri_(tri), contours_(contours), from_(from), goal_(goal), options_(options), trail_(tri, from) {}

  Journey from(Stand stand) {
    ExactPoint line(from_);
    while (!finished_) {
      const Walk walk = detail::walk_to(tri_, stand, line, goal_);
      if (walk.reached) {
        trail_.add(walk, goal_);
        journey_.reached = true;
        break;
      }
      const Place hit = place(walk.end);
      trail_.add(walk, round(hit));
      stand = after(hit).stand;
      if (options_.algorithm == Algorithm::bug1) line = stand.at;
    }
    return finish();
  }

 private:
  Journey finish() {
    journey_.path.points = trail_.points();
    journey_.path.length = Length(journey_.path.points);
    journey_.rounding = trail_.rounding();
    journey_.bound = distance_interval(from_, goal_);
    for (const Obstacle& o : journey_.obstacles)
      journey_.bound =
          sum(journey_.bound,
              product(o.perimeter, options_.algorithm == Algorithm::bug1 ? 1.5 : static_cast<double>(o.entries)));
    return std::move(journey_);
  }

  /// What follows a hit: the place where the robot leaves; finished_ when there is none, or the goal is on the contour.
  Place after(const Place& hit) {
    note(hit, journey_.hits);
    const std::optional<Place> goal = goal_on(hit);
    if (options_.algorithm == Algorithm::bug1) return goal ? arrive(hit, *goal) : after_bug1(hit);
    const std::optional<Place> leave = next_on_line(hit);
    if (goal && (!leave || steps(hit, goal->station) < steps(hit, leave->station))) return arrive(hit, *goal);
    if (!leave) return give_up(hit);
    follow(hit, *leave, options_.turn);
    note(*leave, journey_.leaves);
    return *leave;
  }

  Place after_bug1(const Place& hit) {
    const std::optional<Place> leave = nearest_open(hit.contour);
    if (!leave) return give_up(hit);
    follow(hit, hit, options_.turn);
    const Turn other = options_.turn == Turn::left ? Turn::right : Turn::left;
    follow(hit, *leave,
           way_length(hit, *leave, other) < way_length(hit, *leave, options_.turn) ? other : options_.turn);
    note(*leave, journey_.leaves);
    return *leave;
  }

  Place arrive(const Place& hit, const Place& goal) {
    follow(hit, goal, options_.turn);
    journey_.reached = true;
    finished_ = true;
    return goal;
  }

  Place give_up(const Place& hit) {
    follow(hit, hit, options_.turn);
    finished_ = true;
    return hit;
  }

  // ---- places ----------------------------------------------------------------------------------------------------

  Place place(const Stand& stand) const {
    const bool vertex = stand.kind == Stand::Kind::vertex;
    const Contours::At at = vertex ? contours_.at(tri_.sectors[stand.sector]) : contours_.at(stand.t, stand.i);
    return {at.contour, 2 * at.edge + (vertex ? 0 : 1), stand};
  }

  Place vertex_place(Contours::At at) const {
    const detail::HalfEdge e = contours_.edges(at.contour)[at.edge];
    return {
        at.contour, 2 * at.edge, {Stand::Kind::vertex, e.t, 0, contours_.sector(at), ExactPoint(contours_.tail(at))}};
  }

  Place side_place(Contours::At at, ExactPoint x) const {
    const detail::HalfEdge e = contours_.edges(at.contour)[at.edge];
    return {at.contour, 2 * at.edge + 1, {Stand::Kind::side, e.t, e.i, kNone, std::move(x)}};
  }

  std::uint32_t stations(std::uint32_t contour) const {
    return 2 * static_cast<std::uint32_t>(contours_.edges(contour).size());
  }

  /// The station that is j steps after `from` the way the robot turns.
  std::uint32_t station(const Place& from, std::uint32_t j) const {
    const std::uint32_t n = stations(from.contour);
    return (options_.turn == Turn::left ? from.station + j : from.station + n - j) % n;
  }

  std::uint32_t steps(const Place& from, std::uint32_t to) const {
    const std::uint32_t n = stations(from.contour);
    return (options_.turn == Turn::left ? to + n - from.station : from.station + n - to) % n;
  }

  Point round(const Place& place) {
    const Point p = detail::rounded(tri_, place.stand);
    trail_.add_rounding(place.stand.at, p);
    return p;
  }

  void note(const Place& place, std::vector<Contact>& contacts) {
    const auto [entry, is_new] =
        numbers_.try_emplace(place.contour, static_cast<std::uint32_t>(journey_.obstacles.size()));
    if (is_new) journey_.obstacles.push_back({contours_.perimeter(place.contour), 0, entries(place.contour)});
    if (&contacts == &journey_.hits) ++journey_.obstacles[entry->second].hits;
    const Point p = detail::rounded(tri_, place.stand);
    contacts.push_back({p, std::hypot(goal_.x - p.x, goal_.y - p.y), entry->second});
  }

  // ---- along a contour -------------------------------------------------------------------------------------------

  /// Is b after a, going along the half-edge that both are inside of?
  bool is_ahead(const Place& a, const Place& b) const {
    return squared_distance(a.stand.at, contours_.tail(a.edge())) <
           squared_distance(b.stand.at, contours_.tail(a.edge()));
  }

  /// Calls visit(vertex) for all vertices between a and b; once around when they are the same.
  template <typename Visit>
  void each_vertex(const Place& a, const Place& b, Turn turn, Visit visit) const {
    const std::uint32_t n = stations(a.contour);
    const bool left = turn == Turn::left;
    if (a.station == b.station && !a.is_vertex() && a.stand.at != b.stand.at && is_ahead(a, b) == left) return;
    std::uint32_t at = a.station;
    do {
      at = left ? (at + 1) % n : (at + n - 1) % n;
      if (at % 2 == 0 && at != b.station) visit(contours_.tail({a.contour, at / 2}));
    } while (at != b.station);
  }

  void follow(const Place& a, const Place& b, Turn turn) {
    each_vertex(a, b, turn, [&](Point p) { trail_.add(p); });
    trail_.add(round(b));
  }

  double way_length(const Place& a, const Place& b, Turn turn) const {
    if (a.station == b.station && a.stand.at == b.stand.at) return 0;
    const auto as_point = [](const Place& p) { return Point{p.stand.at.x.get_d(), p.stand.at.y.get_d()}; };
    Point last = as_point(a);
    double length = 0;
    const auto to = [&](Point p) {
      length += std::hypot(p.x - last.x, p.y - last.y);
      last = p;
    };
    each_vertex(a, b, turn, to);
    to(as_point(b));
    return length;
  }

  /// The first place of the contour, from the hit on, where the goal is.
  std::optional<Place> goal_on(const Place& hit) const {
    for (std::uint32_t j = 1; j < stations(hit.contour); ++j) {
      const std::uint32_t at = station(hit, j);
      const Contours::At edge{hit.contour, at / 2};
      if (at % 2 == 0 && contours_.tail(edge) == goal_) return vertex_place(edge);
      if (at % 2 == 0 || contours_.tail(edge) == goal_ || contours_.head(edge) == goal_) continue;
      if (on_segment(goal_, contours_.tail(edge), contours_.head(edge))) return side_place(edge, ExactPoint(goal_));
    }
    if (!hit.is_vertex() && on_segment(goal_, contours_.tail(hit.edge()), contours_.head(hit.edge())))
      return side_place(hit.edge(), ExactPoint(goal_));
    return std::nullopt;
  }

  // ---- Bug 1 -----------------------------------------------------------------------------------------------------

  /// Keeps the nearest places seen so far.
  struct Nearest {
    std::optional<mpq_class> distance;
    std::vector<Place> places;

    void offer(const mpq_class& d, Place place) {
      if (distance && d > *distance) return;
      if (!distance || d < *distance) places.clear();
      distance = d;
      places.push_back(std::move(place));
    }
  };

  /// The foot of the perpendicular from the goal, when it is inside the half-edge.
  std::optional<ExactPoint> foot(Contours::At at) const {
    const ExactPoint a(contours_.tail(at)), b(contours_.head(at));
    const mpq_class dx = b.x - a.x, dy = b.y - a.y, along = dx * (goal_.x - a.x) + dy * (goal_.y - a.y);
    const mpq_class whole = dx * dx + dy * dy;
    if (along <= 0 || along >= whole) return std::nullopt;
    const mpq_class part = along / whole;
    return ExactPoint{a.x + part * dx, a.y + part * dy};
  }

  std::optional<Place> nearest_open(std::uint32_t contour) const {
    Nearest nearest;
    for (std::uint32_t k = 0; k < contours_.edges(contour).size(); ++k) {
      const Contours::At at{contour, k};
      nearest.offer(squared_distance(ExactPoint(contours_.tail(at)), goal_), vertex_place(at));
      if (const auto x = foot(at)) nearest.offer(squared_distance(*x, goal_), side_place(at, *x));
    }
    for (const Place& p : nearest.places)
      if (detail::leads_off(tri_, p.stand, goal_)) return p;
    return std::nullopt;
  }

  // ---- Bug 2 -----------------------------------------------------------------------------------------------------

  /// Is p, on the m-line, at `after` or beyond, and not beyond the goal?
  bool is_between(const ExactPoint& p, const ExactPoint& after) const {
    const ExactPoint g(goal_);
    const auto ordered = [](const mpq_class& a, const mpq_class& b, const mpq_class& c) {
      return (a <= b && b <= c) || (a >= b && b >= c);
    };
    return ordered(after.x, p.x, g.x) && ordered(after.y, p.y, g.y);
  }

  /// The place of a station that is on the m-line, between `after` and the goal; sides along the m-line have none.
  std::optional<Place> on_line(std::uint32_t contour, std::uint32_t station, const ExactPoint& after) const {
    const Contours::At at{contour, station / 2};
    const Point tail = contours_.tail(at);
    const int o = orientation(from_, goal_, tail);
    std::optional<Place> found;
    if (station % 2 == 0) {
      if (o == 0) found = vertex_place(at);
    } else if (o * orientation(from_, goal_, contours_.head(at)) < 0) {
      found = side_place(at, taut::detail::line_crossing({from_, goal_}, {tail, contours_.head(at)}));
    }
    return found && is_between(found->stand.at, after) ? found : std::nullopt;
  }

  std::optional<Place> next_on_line(const Place& hit) const {
    for (std::uint32_t j = 1; j < stations(hit.contour); ++j)
      if (auto p = on_line(hit.contour, station(hit, j), hit.stand.at);
          p && p->stand.at != ExactPoint(goal_) && detail::leads_off(tri_, p->stand, goal_))
        return p;
    return std::nullopt;
  }

  /// Places of the contour in which the m-line, coming from the start, is blocked.
  std::size_t entries(std::uint32_t contour) const {
    std::size_t count = 0;
    if (options_.algorithm == Algorithm::bug1) return 0;
    const ExactPoint start(from_);
    for (std::uint32_t s = 0; s < stations(contour); ++s)
      if (const auto p = on_line(contour, s, start); p && p->stand.at != ExactPoint(goal_))
        count +=
            !detail::is_open(tri_, p->stand, goal_) && (p->stand.at == start || detail::is_open(tri_, p->stand, from_));
    return count;
  }

  const Tri& tri_;
  const Contours& contours_;
  Point from_, goal_;
  Options options_;
  detail::Trail trail_;
  Journey journey_;
  std::map<std::uint32_t, std::uint32_t> numbers_;  // contour -> obstacle
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
  for (const Stand& stand : stands(space, from, to)) {
    journey = Run(space.triangulation(), contours, from, to, options).from(stand);
    if (journey.reached) break;
  }
  return journey;
}

}  // namespace taut::bug
