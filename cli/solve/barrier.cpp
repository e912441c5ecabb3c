#include <taut/cli/solve/barrier.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <taut/cli/report.h>
#include <taut/geometry/detail/segment_distance.h>
#include <taut/geometry/written.h>

namespace taut::cli {

namespace {

constexpr std::size_t kNamed = 4;

/// A dead end behind the opening, on the side that is not the world's. It widens, so that the door itself is what is
/// narrow.
Ring porch(const Segment& door, const Box& box) {
  const double depth = std::max(std::abs(door.b.x - door.a.x), std::abs(door.b.y - door.a.y));
  const bool vertical = door.a.x == door.b.x;
  const double side = vertical ? door.a.x : door.a.y, low = vertical ? box.min.x : box.min.y;
  const double far = side == low ? side - depth : side + depth;
  const auto [p, q] = std::minmax(door.a, door.b);
  return vertical ? Ring{p, q, {far, q.y + depth}, {far, p.y - depth}}
                  : Ring{p, q, {q.x + depth, far}, {p.x - depth, far}};
}

bool is_on_a_side(const Segment& door, const Box& b) {
  const auto both = [&](double u, double v, double low, double high) { return u == v && (u == low || u == high); };
  return both(door.a.x, door.b.x, b.min.x, b.max.x) || both(door.a.y, door.b.y, b.min.y, b.max.y);
}

double distance(const FreeSpace& space, Point p, std::uint32_t constraint) {
  const Constraint& c = space.constraints()[constraint];
  return detail::segment_distance({p, p}, {c.a, c.b});
}

std::string and_more(std::size_t all) { return all > kNamed ? fmt::format(" and {} more", all - kNamed) : ""; }

}  // namespace

World walled_world(const World& world, const std::vector<Point>& ends) {
  if (world.boundary() == Boundary::walled) return world;
  WorldParts parts;
  parts.source = world.source();
  parts.areas = world.areas();
  parts.boundary = Boundary::walled;
  parts.walls = world.walls();
  parts.solids = world.solids();
  parts.start = world.start();
  parts.goal = world.goal();
  for (const Segment& door : world.openings()) {
    const auto stands_on_it = [&](Point p) { return written::on_segment(p, door.a, door.b); };
    if (is_on_a_side(door, world.box()) && std::any_of(ends.begin(), ends.end(), stands_on_it))
      parts.areas.push_back({Polygon{porch(door, world.box()), {}}, 0});
  }
  return World(std::move(parts));
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

Segment wall_near(const FreeSpace& space, std::uint32_t constraint, Point p) {
  const Constraint& c = space.constraints()[constraint];
  const double least = distance(space, p, constraint);
  for (const Point* end : {&c.a, &c.b})
    if (detail::segment_distance({p, p}, {*end, *end}) == least) return wall_of(space, constraint, end);
  return wall_of(space, constraint);
}

std::string separation_text(const Barrier& barrier) {
  return fmt::format("{} start and goal: {}",
                     barrier.walls.size() == 1 ? "this wall separates" : "these walls separate",
                     segments_text(barrier.walls, kNamed));
}

std::string blocked_text(const Gates& gates, const DiscPassage& passage, const Barrier& barrier, Point start,
                         Point goal, double r) {
  if (passage.status != PassageStatus::separated) {
    const bool at_start = passage.status == PassageStatus::start_blocked;
    const Point end = at_start ? start : goal;
    const char* role = at_start ? "start" : "goal";
    if (passage.barrier.empty()) return fmt::format("the {} {} is outside", role, point_text(end));
    return fmt::format("the {} {} is only {} from the wall {}", role, point_text(end),
                       number_text(distance(gates.space(), end, passage.barrier.front().constraint)),
                       segment_text(wall_near(gates.space(), passage.barrier.front().constraint, end)));
  }
  if (barrier.gates.empty()) return separation_text(barrier);
  std::vector<std::string> names;
  for (std::size_t i = 0; i < std::min(kNamed, barrier.gates.size()); ++i) names.push_back(barrier.gates[i].name);
  return fmt::format(
      "{} narrower than {}: {}{}",
      barrier.gates.size() == 1 ? "this gate is" : fmt::format("these {} gates are", barrier.gates.size()),
      number_text(2 * r), fmt::join(names, "; "), and_more(barrier.gates.size()));
}

std::optional<DiscBarrier> disc_barrier(const World& world, Point start, const std::vector<Point>& goals, double r) {
  std::vector<Point> ends = goals;
  ends.push_back(start);
  const FreeSpace space(walled_world(world, ends));
  const Gates gates(space);
  std::optional<DiscBarrier> found;
  for (const Point goal : goals) {
    const DiscPassage passage = disc_passage(gates, start, goal, r);
    if (passage.status == PassageStatus::reachable) return std::nullopt;
    if (found || passage.status != PassageStatus::separated) continue;
    Barrier barrier = barrier_of(gates, passage.barrier);
    std::string text = blocked_text(gates, passage, barrier, start, goal, r);
    found = DiscBarrier{std::move(barrier), std::move(text)};
  }
  return found;
}

std::string pinch_text(const Pinch& pinch, const FreeSpace& space, const std::string& width) {
  const std::string first = segment_text(wall_of(space, pinch.constraints[0], &pinch.posts[0]));
  if (pinch.where == Pinch::Where::gate)
    return fmt::format("narrowest {} between {} and {}, of the walls {} and {}",
                       width.empty() ? number_text(2 * pinch.clearance) : width, point_text(pinch.posts[0]),
                       point_text(pinch.posts[1]), first,
                       segment_text(wall_of(space, pinch.constraints[1], &pinch.posts[1])));
  return fmt::format("nearest to a wall at the {} {}: {} from the wall {}",
                     pinch.where == Pinch::Where::start ? "start" : "goal", point_text(pinch.posts[1]),
                     number_text(pinch.clearance), first);
}

}  // namespace taut::cli
