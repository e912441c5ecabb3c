// Other ways to the answers of disc_passage.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include <taut/geometry/segment_distance.h>
#include <taut/search/disc_passage.h>

namespace taut::test {

/// What the inflated polygon says: true when connected; nothing when an end is no place for it.
inline std::optional<bool> inflated(const World& world, Point s, Point g, double r) {
  const FreeSpace space(world, Footprint::disc(r));
  const Location from = space.locate(s), to = space.locate(g);
  if (from.kind == Location::Kind::outside || to.kind == Location::Kind::outside) return std::nullopt;
  return space.component(from.triangle) == space.component(to.triangle);
}

/// Flood of a grid of points whose distance to all walls is at least r.
inline bool flooded(const Gates& gates, Point s, Point g, double r, double side, int steps) {
  const auto& all = gates.space().constraints();
  const double step = side / steps;
  const auto is_place = [&](Point p) {
    if (gates.space().locate(p).kind == Location::Kind::outside) return false;
    for (std::uint32_t c = 0; c < all.size(); ++c)
      if (!gates.is_opening(c) && taut::segment_distance_interval({p, p}, {all[c].a, all[c].b}).hi < r) return false;
    return true;
  };
  const auto node = [&](Point p) { return std::lround(p.y / step) * (steps + 1) + std::lround(p.x / step); };
  std::vector<char> place;
  for (int y = 0; y <= steps; ++y)
    for (int x = 0; x <= steps; ++x) place.push_back(is_place({x * step, y * step}));
  if (!place[node(s)] || !place[node(g)]) return false;
  std::vector<long> open{node(s)};
  place[open[0]] = 0;
  while (!open.empty()) {
    const long at = open.back();
    open.pop_back();
    if (at == node(g)) return true;
    const long x = at % (steps + 1), y = at / (steps + 1);
    for (const auto& [dx, dy] : {std::pair(1, 0), {-1, 0}, {0, 1}, {0, -1}}) {
      if (x + dx < 0 || x + dx > steps || y + dy < 0 || y + dy > steps) continue;
      const long next = at + dy * (steps + 1) + dx;
      if (place[next]) place[next] = 0, open.push_back(next);
    }
  }
  return false;
}

/// The chain of pieces closes, and does so around exactly one of s and g (winding by angles).
inline bool separates(const Gates& gates, const std::vector<BarrierPiece>& barrier, Point s, Point g) {
  const auto ends = [&](const BarrierPiece& piece) {
    if (piece.gate != kNone) return Segment{gates.gates()[piece.gate].end, gates.gates()[piece.gate].foot};
    const Constraint& c = gates.space().constraints()[piece.constraint];
    return Segment{c.a, c.b};
  };
  // Pieces of one chain touch; where exactly is the point of the next nearest to this.
  std::vector<Point> chain;
  for (std::size_t i = 0; i < barrier.size(); ++i) {
    const Segment here = ends(barrier[i]), next = ends(barrier[(i + 1) % barrier.size()]);
    Point joint = here.a;
    double least = HUGE_VAL;
    for (const Point p : {here.a, here.b, next.a, next.b}) {
      const double apart = segment_distance({p, p}, here) + segment_distance({p, p}, next);
      if (apart < least) least = apart, joint = p;
    }
    if (least > 1e-9) return false;
    chain.push_back(joint);
  }
  const auto winding = [&](Point p) {
    double turn = 0;
    for (std::size_t i = 0; i < chain.size(); ++i) {
      const Point a = chain[i], b = chain[(i + 1) % chain.size()];
      turn += std::atan2((a.x - p.x) * (b.y - p.y) - (a.y - p.y) * (b.x - p.x),
                         (a.x - p.x) * (b.x - p.x) + (a.y - p.y) * (b.y - p.y));
    }
    return std::lround(turn / (2 * M_PI));
  };
  return winding(s) != winding(g);
}

}  // namespace taut::test
