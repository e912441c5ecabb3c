#include <taut/robots/bug/detail/targets.h>

#include <utility>

namespace taut::bug::detail {

namespace {

using Kind = Sight::Step::Kind;

Turn other(Turn turn) { return turn == Turn::left ? Turn::right : Turn::left; }

}  // namespace

int Targets::compare(const ExactPoint& p, const ExactPoint& q) const {
  return compare_roots(squared_distance(stand_.at, p), distance(p), squared_distance(stand_.at, q), distance(q));
}

std::optional<Corner> Targets::best_corner(const Sight& sight, const Rational& limit) const {
  std::optional<Corner> best;
  for (const std::uint32_t v : sight.corners()) {
    const ExactPoint p(vertex(v));
    if (distance(p) >= limit) continue;
    const int order = best ? compare(p, ExactPoint(best->at)) : -1;
    if (order > 0 || (order == 0 && !is_preferred(vertex(v)))) continue;
    if (Walk walk = walk_to(places_.tri(), stand_, stand_.at, Spot(vertex(v))); walk.reached)
      best = Corner{vertex(v), std::move(walk)};
  }
  return best;
}

bool Targets::is_preferred(Point v) const {
  return orientation(Spot(stand_.at), goal_, v) == (preferred_ == Turn::left ? 1 : -1);
}

ViewEnd Targets::end(const Sight& sight, const ContourPlace& hit, Turn turn) const {
  ContourPlace at = hit;
  for (;;) {
    const Sight::Step step = sight.step(at, turn);
    const bool hidden = step.kind == Kind::shadow && step.corner != kNone;
    if (step.kind != Kind::vertex) {
      // A vertex behind which nothing is in view is an end of its own.
      const bool is_vertex = step.end == at && at.is_vertex() && step.kind == Kind::shadow;
      return {is_vertex ? Kind::vertex : step.kind, hidden ? ExactPoint(vertex(step.corner)) : step.end.stand.at};
    }
    at = step.end;
    if (at.station == hit.station || (!hit.is_vertex() && at == places_.next_vertex(hit, other(turn))))
      return {Kind::vertex, at.stand.at};
  }
}

Turn Targets::better(const ContourPlace& hit, const ViewEnd& left, const ViewEnd& right) const {
  int order = compare(left.target, right.target);
  if (order == 0) order = compare_slopes(hit);
  return order == 0 ? preferred_ : order < 0 ? Turn::left : Turn::right;
}

int Targets::compare_slopes(const ContourPlace& hit) const {
  const auto slope = [&](Turn turn) {
    const ExactPoint &h = hit.stand.at, to = places_.next_vertex(hit, turn).stand.at;
    const Rational along = (to.x - h.x) * (goal_.exact.x - h.x) + (to.y - h.y) * (goal_.exact.y - h.y);
    return Rational(along * abs(along) / squared_distance(h, to));
  };
  return cmp(slope(Turn::right), slope(Turn::left));
}

}  // namespace taut::bug::detail
