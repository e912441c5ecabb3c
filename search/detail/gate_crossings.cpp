#include <taut/search/detail/gate_crossings.h>

#include <algorithm>
#include <utility>

#include <taut/geometry/box.h>
#include <taut/geometry/box_index.h>

namespace taut::detail {

namespace {

Rational cross(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

Rational part_along(const ExactPoint& a, const ExactPoint& b, const ExactPoint& p) {
  const Rational ux = b.x - a.x, uy = b.y - a.y;
  return (ux * (p.x - a.x) + uy * (p.y - a.y)) / (ux * ux + uy * uy);
}

void sort_once(std::vector<GateCrossing>& crossings) {
  std::sort(crossings.begin(), crossings.end(),
            [](const GateCrossing& a, const GateCrossing& b) { return a.from_end < b.from_end; });
  const auto same = [](const GateCrossing& a, const GateCrossing& b) { return a.from_end == b.from_end; };
  crossings.erase(std::unique(crossings.begin(), crossings.end(), same), crossings.end());
}

}  // namespace

ExactPoint point_along(const Segment& c, const Rational& t) {
  const ExactPoint a(c.a), b(c.b);
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
}

Rational place_along(const Segment& c, const ExactPoint& p) { return part_along(ExactPoint(c.a), ExactPoint(c.b), p); }

void append_crossings(const ExactPoint& p, const ExactPoint& q, const WallIndex& walls, std::uint32_t c,
                      std::vector<GateCrossing>& to) {
  const Segment s = walls.segment(c);
  const ExactPoint a(s.a), b(s.b);
  const Rational of_a = cross(p, q, a), of_b = cross(p, q, b);
  if (sgn(of_a) * sgn(of_b) > 0) return;
  const auto pass = [&](const ExactPoint& at, int end) {
    const Rational t = part_along(p, q, at);
    if (t > 0 && t < 1) to.push_back({t, kNone, {}, walls.ends()[c][end], kNone});
  };
  if (of_a == 0) pass(a, 0);
  if (of_b == 0) pass(b, 1);
  if (of_a == 0 || of_b == 0) return;
  const Rational of_p = cross(a, b, p), of_q = cross(a, b, q);
  if (sgn(of_p) * sgn(of_q) >= 0) return;
  to.push_back({of_p / (of_p - of_q), c, of_a / (of_a - of_b), kNone, kNone});
}

std::vector<std::vector<GateCrossing>> gate_crossings(const ExactGates& gates) {
  std::vector<std::vector<GateCrossing>> result(gates.gates.size());
  std::vector<std::uint32_t> openings;
  std::vector<Box> boxes;
  for (std::uint32_t c = 0; c < gates.walls.ends().size(); ++c)
    if (gates.walls.is_opening(c)) {
      openings.push_back(c);
      boxes.push_back(box_around(gates.walls.segment(c).a, gates.walls.segment(c).b));
    }
  if (openings.empty()) return result;
  const BoxIndex index(std::move(boxes));
  for (std::uint32_t i = 0; i < gates.gates.size(); ++i) {
    // A rounded foot may lie a little beside the exact one: ask a little more.
    const Box box = box_around(gates.gates[i].end, gates.gates[i].foot);
    const double more =
        0x1p-40 * (box.max.x - box.min.x + box.max.y - box.min.y) +
        0x1p-50 * (std::abs(box.max.x) + std::abs(box.max.y) + std::abs(box.min.x) + std::abs(box.min.y));
    index.meeting({{box.min.x - more, box.min.y - more}, {box.max.x + more, box.max.y + more}}, [&](std::uint32_t k) {
      append_crossings(ExactPoint(gates.shapes[i].end), exact_foot(gates.shapes[i]), gates.walls, openings[k],
                       result[i]);
    });
    sort_once(result[i]);
  }
  return result;
}

}  // namespace taut::detail
