#include <algorithm>
#include <utility>

#include <taut/search/alternatives.h>
#include <taut/search/detail/string_gates.h>
#include <taut/search/funnel.h>
#include <taut/search/shortest_path.h>

namespace taut {

namespace {

constexpr double kBeyond = 1e-9;  // of a gate: how far its wall goes on where the foot was rounded

Wall wall_across(const Gate& gate) {
  if (gate.foot_is_exact) return {gate.end, gate.foot, 0, 0};
  const Point beyond{gate.foot.x + kBeyond * (gate.foot.x - gate.end.x),
                     gate.foot.y + kBeyond * (gate.foot.y - gate.end.y)};
  return {gate.end, beyond, 0, 0};
}

/// The space with the first `closed` gates as walls.
FreeSpace closed_space(const Gates& gates, std::size_t closed, Point s, Point g) {
  if (closed == 0) return gates.space();
  const World& world = gates.space().world();
  WorldParts parts;
  parts.source = world.source();
  parts.areas = world.areas();
  parts.boundary = world.boundary();
  parts.walls = world.walls();
  parts.solids = world.solids();
  parts.uncertainty = world.uncertainty();
  for (std::size_t i = 0; i < closed; ++i) parts.walls.push_back(wall_across(gates.gates()[i]));
  const std::vector<Point> places{s, g};
  return FreeSpace(World(std::move(parts)), Footprint::point(), places);
}

}  // namespace

std::vector<Alternative> wider_ways(const Gates& gates, Point s, Point g) {
  std::vector<Alternative> ways;
  std::size_t closed = 0;
  for (;;) {
    const FreeSpace space = closed_space(gates, closed, s, g);
    if (!space.holds(s) || !space.holds(g)) break;
    const auto path = shortest_path(space, s, g);
    auto pulled = path ? shortened(gates.space(), *path) : std::nullopt;
    if (!pulled) break;
    const auto gate = detail::narrowest_gate_of(gates, *pulled);
    if (gate && *gate < closed) break;
    // Of equally long ways the wider stands.
    while (!ways.empty() && ways.back().path.length >= pulled->length) ways.pop_back();
    ways.push_back({std::move(*pulled), gate ? std::optional(named_gate(gates, *gate)) : std::nullopt});
    if (!gate) break;
    closed = *gate + std::size_t{1};
    while (closed < gates.gates().size() && gates.compare_widths(static_cast<std::uint32_t>(closed), *gate) == 0)
      ++closed;
  }
  return ways;
}

}  // namespace taut
