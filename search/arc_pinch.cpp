#include <taut/search/arc_pinch.h>

#include <algorithm>
#include <vector>

#include <taut/geometry/written.h>

namespace taut {

namespace {

bool boxes_meet(const Segment& s, const Segment& t) {
  const auto apart = [](double a, double b, double c, double d) {
    return std::max(a, b) < std::min(c, d) || std::max(c, d) < std::min(a, b);
  };
  return !apart(s.a.x, s.b.x, t.a.x, t.b.x) && !apart(s.a.y, s.b.y, t.a.y, t.b.y);
}

double cross(Point o, Point p, Point q) { return (p.x - o.x) * (q.y - o.y) - (p.y - o.y) * (q.x - o.x); }

// Where the leg crosses the gate, its ends included; two on one line do not cross.
std::optional<Point> crossing(const Segment& leg, const Segment& gate) {
  if (!boxes_meet(leg, gate)) return std::nullopt;
  const int a = written::orientation(gate.a, gate.b, leg.a), b = written::orientation(gate.a, gate.b, leg.b);
  if (a * b > 0 || (a == 0 && b == 0)) return std::nullopt;
  if (written::orientation(leg.a, leg.b, gate.a) * written::orientation(leg.a, leg.b, gate.b) > 0) return std::nullopt;
  const double before = cross(gate.a, gate.b, leg.a), after = cross(gate.a, gate.b, leg.b);
  const double t = before == after ? 0 : std::clamp(before / (before - after), 0.0, 1.0);
  return Point{leg.a.x + t * (leg.b.x - leg.a.x), leg.a.y + t * (leg.b.y - leg.a.y)};
}

// Is leg k the first, away from the gate on which the path starts, or the last, likewise?
bool is_left(const Segment& gate, const std::vector<Point>& points, std::size_t k) {
  const auto is_on = [&](Point p) { return written::orientation(gate.a, gate.b, p) == 0; };
  return (k == 1 && is_on(points.front())) || (k + 1 == points.size() && is_on(points.back()));
}

}  // namespace

std::optional<ArcPinch> narrowest_gate(const Gates& gates, const ArcPath& path) {
  const std::vector<Point> points = sampled(path, path.radius / 1000);
  for (std::uint32_t i = 0; i < gates.gates().size(); ++i) {
    const Segment gate{gates.gates()[i].end, gates.gates()[i].foot};
    for (std::size_t k = 1; k < points.size(); ++k)
      if (const auto at = crossing({points[k - 1], points[k]}, gate); at && !is_left(gate, points, k))
        return ArcPinch{*at, named_gate(gates, i), i};
  }
  return std::nullopt;
}

}  // namespace taut
