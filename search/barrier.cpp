#include <taut/search/barrier.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <map>
#include <utility>

#include <taut/geometry/predicates.h>
#include <taut/geometry/segment_distance.h>
#include <taut/geometry/walled_world.h>
#include <taut/geometry/written.h>

namespace taut {

namespace {

// With its ends in order, to be found again.
std::pair<Point, Point> key(const Constraint& c) { return std::minmax(c.a, c.b); }

std::vector<Constraint> without_dead_ends(const std::vector<Constraint>& chain) {
  std::map<std::pair<Point, Point>, int> passes;
  for (const Constraint& c : chain) ++passes[key(c)];
  std::vector<Constraint> rest;
  for (const Constraint& c : chain)
    if (passes[key(c)] == 1) rest.push_back(c);
  return rest;
}

// Turns each piece so that it begins where the one before ends.
std::vector<Segment> oriented(const std::vector<Constraint>& chain) {
  std::vector<Segment> result;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    Segment s{chain[i].a, chain[i].b};
    const bool follows = i > 0 && (result.back().b == s.a || result.back().b == s.b);
    const bool flip =
        follows ? s.b == result.back().b : i + 1 < chain.size() && (s.a == chain[i + 1].a || s.a == chain[i + 1].b);
    if (flip) std::swap(s.a, s.b);
    result.push_back(s);
  }
  return result;
}

bool on_side(const Constraint& c, const Box& box) {
  return (c.a.x == c.b.x && (c.a.x == box.min.x || c.a.x == box.max.x)) ||
         (c.a.y == c.b.y && (c.a.y == box.min.y || c.a.y == box.max.y));
}

// Beginning after a gap, where there is one.
std::vector<Constraint> without_border(std::vector<Constraint> chain, const Box& border) {
  const auto gap = std::find_if(chain.begin(), chain.end(), [&](const Constraint& c) { return on_side(c, border); });
  if (gap == chain.end()) return chain;
  std::rotate(chain.begin(), gap, chain.end());
  std::vector<Constraint> rest;
  std::remove_copy_if(chain.begin(), chain.end(), std::back_inserter(rest),
                      [&](const Constraint& c) { return on_side(c, border); });
  return rest.empty() ? chain : rest;
}

bool goes_on(const Segment& s, const Segment& next) {
  return s.b == next.a && written::orientation(s.a, s.b, next.b) == 0 && written::on_segment(s.b, s.a, next.b);
}

}  // namespace

std::vector<Segment> joined_walls(const std::vector<Constraint>& chain, const Box& border) {
  std::vector<Segment> joined;
  for (const Segment& s : oriented(without_border(without_dead_ends(chain), border))) {
    if (!joined.empty() && goes_on(joined.back(), s))
      joined.back().b = s.b;
    else
      joined.push_back(s);
  }
  if (joined.size() > 1 && goes_on(joined.back(), joined.front())) {
    joined.front().a = joined.back().a;
    joined.pop_back();
  }
  return joined;
}

NamedGate named_gate(const Gates& gates, std::uint32_t gate) {
  const Gate& g = gates.gates()[gate];
  return {{g.end, g.foot}, g.width, gates.width_text(gate), gates.name(gate)};
}

std::vector<Segment> Barrier::gate_segments() const {
  std::vector<Segment> all;
  for (const NamedGate& gate : gates) all.push_back(gate.at);
  return all;
}

Barrier barrier_of(const Gates& gates, const std::vector<BarrierPiece>& pieces) {
  std::vector<Constraint> chain;
  std::vector<std::uint32_t> narrow;
  for (const BarrierPiece& piece : pieces) {
    if (piece.gate != kNone)
      narrow.push_back(piece.gate);
    else
      chain.push_back(gates.space().constraints()[piece.constraint]);
  }
  std::sort(narrow.begin(), narrow.end(), std::greater<>());
  Barrier barrier;
  barrier.walls = joined_walls(chain, gates.space().world().box());
  for (const std::uint32_t gate : narrow) barrier.gates.push_back(named_gate(gates, gate));
  return barrier;
}

Segment wall_of(const FreeSpace& space, std::uint32_t constraint, const Point* end) {
  const auto& all = space.constraints();
  const auto is_named = [](const Constraint& c) { return c.wall != kNone; };
  const auto ends_there = [&](const Constraint& c) { return is_named(c) && (c.a == *end || c.b == *end); };
  auto piece = all.begin() + constraint;
  if (end && !is_named(*piece))
    if (const auto other = std::find_if(all.begin(), all.end(), ends_there); other != all.end()) piece = other;
  if (!is_named(*piece)) return {piece->a, piece->b};
  const Wall& wall = space.world().walls()[piece->wall];
  return {wall.a, wall.b};
}

double distance_to(const FreeSpace& space, std::uint32_t constraint, Point p) {
  const Constraint& c = space.constraints()[constraint];
  return segment_distance({p, p}, {c.a, c.b});
}

Segment wall_near(const FreeSpace& space, std::uint32_t constraint, Point p) {
  const Constraint& c = space.constraints()[constraint];
  const double least = distance_to(space, constraint, p);
  for (const Point* end : {&c.a, &c.b})
    if (segment_distance({p, p}, {*end, *end}) == least) return wall_of(space, constraint, end);
  return wall_of(space, constraint);
}

std::optional<Barrier> disc_barrier(const World& world, Point start, const std::vector<Point>& goals, double r) {
  std::vector<Point> ends = goals;
  ends.push_back(start);
  const FreeSpace space(walled_world(world, ends));
  const Gates gates(space);
  std::optional<Barrier> found;
  for (const Point goal : goals) {
    const DiscPassage passage = disc_passage(gates, start, goal, r);
    if (passage.status == DiscStatus::found) return std::nullopt;
    if (!found && passage.status == DiscStatus::none) found = barrier_of(gates, passage.barrier);
  }
  return found;
}

}  // namespace taut
