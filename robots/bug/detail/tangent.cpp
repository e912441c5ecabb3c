#include <taut/robots/bug/detail/tangent.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>

#include <taut/robots/bug/detail/logbook.h>
#include <taut/robots/bug/detail/targets.h>
#include <taut/robots/bug/detail/view.h>

namespace taut::bug::detail {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

class Tangent {
 public:
  Tangent(const ContourPlaces& places, const Stand& stand, Point from, Point goal, const Options& options)
      : places_(places),
        goal_(goal),
        options_(options),
        range_(options.range),
        log_(places, from, goal),
        x_(stand),
        limit_(distance(ExactPoint(from))) {}

  Journey run() {
    while (!finished_) go_to_goal();
    for (const Obstacle& o : log_.journey().obstacles)
      log_.add_bound(product(o.perimeter, 1.5 * static_cast<double>(o.hits)));
    return log_.finish();
  }

 private:
  using Kind = Sight::Step::Kind;

  Rational distance(const ExactPoint& p) const { return squared_distance(p, goal_.exact); }
  const ExactPoint& here() const { return x_.at; }
  Point vertex(std::uint32_t v) const { return places_.tri().points[v]; }

  void arrive() {
    log_.journey().reached = true;
    finished_ = true;
  }

  Sight look() {
    Sight sight(places_, x_, range_);
    if (options_.record_views && options_.range > 0) log_.journey().views.push_back({log_.points() - 1, sight.ring()});
    return sight;
  }

  // ---- motion to the goal ------------------------------------------------------------------------------------------

  void go_to_goal() {
    const Walk way = walk_to(places_.tri(), x_, here(), goal_);
    if (way.reached) {
      log_.walk(way);
      return arrive();
    }
    if (range_.reaches(here(), way.end.at)) return at_obstacle(places_.at(way.end));
    if (!approach(way.end.at)) {
      log_.walk(way, way.end);
      x_ = way.end;
    }
    limit_ = std::min(limit_, distance(here()));
    is_straight_ = true;
  }

  /// Goes straight on until `hit`, or what is in the way from there, is within range; not when there is no such pair of
  /// doubles.
  bool approach(const ExactPoint& hit) {
    const double dx = to_double(here().x) - to_double(hit.x), dy = to_double(here().y) - to_double(hit.y);
    const double part = options_.range * (1 - 0x1p-30) / std::hypot(dx, dy);
    const Point p{to_double(hit.x) + part * dx, to_double(hit.y) + part * dy};
    if (!(part > 0) || ExactPoint(p) == here()) return false;
    const Walk there = walk_to(places_.tri(), x_, here(), Spot(p));
    if (!there.reached || there.end.kind != Stand::Kind::open || distance(ExactPoint(p)) >= distance(here()))
      return false;
    const Walk on = walk_to(places_.tri(), there.end, there.end.at, goal_);
    if (on.reached || !range_.reaches(there.end.at, on.end.at)) return false;
    log_.walk(there, there.end);
    x_ = there.end;
    return true;
  }

  void at_obstacle(const ContourPlace& hit) {
    if (std::exchange(is_straight_, false)) log_.note(x_, hit.contour, log_.journey().hits);
    const Sight sight = look();
    const Targets targets(places_, x_, goal_, options_.turn);
    const ViewEnd left = targets.end(sight, hit, Turn::left), right = targets.end(sight, hit, Turn::right);
    std::optional<Corner> best = targets.best_corner(sight, limit_);
    for (const ViewEnd* e : {&left, &right})
      if (best && e->kind == Kind::range && distance(e->target) < limit_ &&
          targets.compare(e->target, ExactPoint(best->at)) < 0)
        best.reset();
    if (!best) return follow(hit, targets.better(hit, left, right));
    const bool is_near = distance(left.target) < limit_ || distance(right.target) < limit_;
    Obstacle& obstacle = log_.obstacle(hit.contour);
    ++obstacle.legs;
    go_for(*best, is_near ? product(obstacle.perimeter, 2) : Interval{kInfinity, kInfinity});
  }

  void go_for(const Corner& corner, Interval most) {
    const double reach = distance_interval(corner.at, *goal_.doubles).hi;
    const double twice = 2 * std::min(options_.range, reach);
    log_.add_bound(twice < most.hi ? Interval{twice, twice} : most);
    log_.walk(corner.walk, corner.walk.end);
    x_ = corner.walk.end;
    limit_ = distance(here());
  }

  // ---- following ---------------------------------------------------------------------------------------------------

  /// Where a part of the contour ends, and why.
  struct Pass {
    enum class Why { end, goal, leave, closed };
    ContourPlace at;
    Why why = Why::end;
  };

  void follow(const ContourPlace& hit, Turn turn) {
    ++log_.note(x_, hit.contour, log_.journey().minima).hits;
    turn_ = turn;
    start_ = front_ = hit;
    followed_ = distance(hit.stand.at);
    for (bool first = true; is_following(first); first = false) {
    }
  }

  /// One look and what follows from it; false when it is over.
  bool is_following(bool first) {
    const Sight sight = look();
    Sight::Step step;
    const Pass pass = sweep(sight, step);
    if (pass.why == Pass::Why::closed) return give_up();
    if (!first && sees_way_on()) return leave_straight();
    if (const auto corner = Targets(places_, x_, goal_, options_.turn).best_corner(sight, followed_)) {
      log_.note(x_, start_.contour, log_.journey().leaves);
      go_for(*corner, {kInfinity, kInfinity});
      is_straight_ = true;
      return false;
    }
    if (pass.at != front_ && go_on(pass, step) && (step.kind != Kind::range || pass.why != Pass::Why::end))
      return !is_over(pass);
    return !is_over(along_side());
  }

  /// Extends what is seen of the contour, side by side.
  Pass sweep(const Sight& sight, Sight::Step& step) {
    Pass pass{front_};
    do {
      step = sight.step(pass.at, turn_);
      if (step.end == pass.at) break;
      pass = look_over(pass.at, step.end);
    } while (pass.why == Pass::Why::end && step.kind == Kind::vertex);
    return pass;
  }

  /// Takes note of the contour from a to b, on one side; up to where it need not be followed any more.
  Pass look_over(const ContourPlace& a, const ContourPlace& b) {
    const Contours::At edge = places_.ahead(a, turn_);
    const Point tail = places_.contours().tail(edge), head = places_.contours().head(edge);
    const auto away = [&](const ExactPoint& p) { return squared_distance(a.stand.at, p); };
    const auto is_between = [&](const ExactPoint& p) {
      const ExactPoint &u = a.stand.at, &v = b.stand.at;
      return p != u && (v == p || same_way(u, v, p)) && away(p) <= away(v);
    };
    Pass pass{b};
    if (written::on_segment(*goal_.doubles, tail, head) && is_between(goal_.exact))
      return {places_.on(edge, goal_.exact), Pass::Why::goal};
    if (is_between(start_.stand.at) && places_.on(edge, start_.stand.at) == start_) pass = {start_, Pass::Why::closed};
    const ContourPlace foot = places_.on(edge, nearest_on(tail, head, goal_.exact));
    const bool passes_foot = is_between(foot.stand.at) && away(foot.stand.at) < away(pass.at.stand.at);
    followed_ = std::min(followed_, distance(passes_foot ? foot.stand.at : pass.at.stand.at));
    if (passes_foot && !foot.is_vertex() && is_way_off(foot)) return {foot, Pass::Why::leave};
    if (pass.why == Pass::Why::end && (b.is_vertex() || b == foot) && is_way_off(b)) pass.why = Pass::Why::leave;
    return pass;
  }

  bool is_way_off(const ContourPlace& place) const {
    return distance(place.stand.at) <= followed_ && leads_off(places_.tri(), place.stand, *goal_.doubles);
  }

  /// Can the robot go straight on to a place nearer than all that it followed?
  bool sees_way_on() const {
    const Walk way = walk_to(places_.tri(), x_, here(), goal_);
    if (range_.reaches(here(), way.end.at)) return distance(way.end.at) < followed_;
    return compare_roots(distance(here()), 0, range_.squared(), followed_) < 0;
  }

  bool leave_straight() {
    log_.note(x_, start_.contour, log_.journey().leaves);
    limit_ = followed_;
    is_straight_ = true;
    return false;
  }

  bool give_up() {
    finished_ = true;
    return false;
  }

  /// The way to a place of the contour, when it leads to that side or corner and no other at the same point.
  std::optional<Walk> way_to(const Stand& from, const ContourPlace& to) const {
    const auto is_there = [&](const Stand& s) {
      return s.kind == to.stand.kind &&
             (to.is_vertex() ? s.sector == to.stand.sector : s.t == to.stand.t && s.i == to.stand.i);
    };
    if (from.at == to.stand.at) return is_there(from) ? std::optional(Walk{true, from, {}}) : std::nullopt;
    Walk walk = walk_to(places_.tri(), from, from.at, Spot(to.stand.at));
    return walk.reached && is_there(walk.end) ? std::optional(std::move(walk)) : std::nullopt;
  }

  /// Goes where the view ends, or to what ends it; not when it would lose sight of it.
  bool go_on(const Pass& pass, const Sight::Step& step) {
    if (pass.why == Pass::Why::end && step.kind == Kind::shadow && step.corner != kNone) {
      const Walk walk = walk_to(places_.tri(), x_, here(), Spot(vertex(step.corner)));
      if (!walk.reached || !way_to(walk.end, pass.at)) return false;
      log_.walk(walk, walk.end);
      x_ = walk.end;
    } else {
      const std::optional<Walk> walk = way_to(x_, pass.at);
      if (!walk) return false;
      log_.walk(*walk, pass.at.stand);
      x_ = pass.at.stand;
    }
    front_ = pass.at;
    return true;
  }

  /// To the contour, and along it to the end of the side.
  Pass along_side() {
    const std::optional<Walk> walk = way_to(x_, front_);
    if (!walk) throw std::logic_error("Tangent Bug has lost the contour that it follows");
    log_.walk(*walk, front_.stand);
    Pass pass = look_over(front_, places_.next_vertex(front_, turn_));
    log_.follow(front_, pass.at, turn_);
    front_ = pass.at;
    x_ = pass.at.stand;
    return pass;
  }

  bool is_over(const Pass& pass) {
    if (pass.why == Pass::Why::goal) arrive();
    if (pass.why == Pass::Why::closed) give_up();
    if (pass.why == Pass::Why::leave) {
      limit_ = followed_;
      leave_straight();
    }
    return pass.why != Pass::Why::end;
  }

  const ContourPlaces& places_;
  const Spot goal_;
  const Options options_;
  const SensorRange range_;
  Logbook log_;
  Stand x_;
  Rational limit_;           // squared
  bool is_straight_ = true;  // nothing has been in the way since the start or the last leave
  bool finished_ = false;
  // Following:
  Turn turn_ = Turn::left;
  ContourPlace start_, front_;  // the part of the contour in between is seen
  Rational followed_;           // squared
};

}  // namespace

Journey tangent_journey(const ContourPlaces& places, const Stand& stand, Point from, Point goal,
                        const Options& options) {
  return Tangent(places, stand, from, goal, options).run();
}

}  // namespace taut::bug::detail
