// Constraints by hand, and the check of a whole path against them without any index.
#pragma once

#include <initializer_list>
#include <optional>
#include <vector>

#include <taut/geometry/contact.h>

namespace taut::test {

using Constraints = std::vector<Constraint>;

inline Constraint wall(Point a, Point b) { return {a, b, false, false, kNone}; }

/// The sides of a solid, counter-clockwise.
inline void add_solid(Constraints& to, const Ring& ring) {
  for (std::size_t i = 0; i < ring.size(); ++i)
    to.push_back({ring[i], ring[(i + 1) % ring.size()], true, false, kNone});
}

inline Constraints walls(std::initializer_list<Segment> segments) {
  Constraints result;
  for (const Segment& s : segments) result.push_back(wall(s.a, s.b));
  return result;
}

/// Indices of the constraints that the leg touches; nothing when it crosses one.
inline std::optional<std::vector<std::uint32_t>> touched(const Segment& leg, const Constraints& constraints) {
  std::vector<std::uint32_t> result;
  for (std::uint32_t i = 0; i < constraints.size(); ++i) {
    const auto kind = contact(leg, constraints[i]);
    if (kind == Contact::cross) return std::nullopt;
    if (kind == Contact::touch) result.push_back(i);
  }
  return result;
}

/// The sectors of the star at the path's end that it can be in, `from` its start's; empty when it is blocked.
inline Sectors follow_from(Sectors from, const std::vector<Point>& path, const Constraints& constraints) {
  for (std::size_t i = 0; i + 1 < path.size() && !from.empty(); ++i) {
    const Segment leg{path[i], path[i + 1]};
    const auto touching = touched(leg, constraints);
    if (!touching) return {};
    from = pass(leg, from, constraints, *touching).sectors;
  }
  return from;
}

inline Star star(Point p, const Constraints& constraints) {
  const auto touching = touched({p, p}, constraints);
  return star_at(p, constraints, *touching);
}

/// Can a path follow these points? (It starts where no constraint is, or in a sector that is not solid.)
inline bool follows(const std::vector<Point>& path, const Constraints& constraints) {
  return !follow_from(star(path.front(), constraints).free_sectors(), path, constraints).empty();
}

}  // namespace taut::test
