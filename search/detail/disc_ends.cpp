#include <taut/search/detail/disc_ends.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <taut/geometry/exact/exact_point.h>
#include <taut/geometry/exact/twofold.h>
#include <taut/roadmaps/exact/gate_shape.h>

namespace taut::detail {

namespace {

using twofold::Pair;
using twofold::two_product;
using twofold::two_sum;

Pair sum(Pair a, Pair b) {
  const Pair s = two_sum(a.high, b.high), t = two_sum(a.low, b.low), u = two_sum(s.high, s.low + t.high);
  return two_sum(u.high, u.low + t.low);
}

Pair product(Pair a, Pair b) {
  const Pair p = two_product(a.high, b.high);
  return two_sum(p.high, p.low + (a.high * b.low + a.low * b.high));
}

Pair difference(double a, double b) { return two_sum(a, -b); }

/// The largest r with r^2 <= over / under, by doubles that carry their rounding along.
std::optional<double> root_below(Pair over, Pair under) {
  const double rough = std::sqrt(over.high / under.high);
  const auto fits = [&](double r) -> std::optional<bool> {
    const Pair left = product(two_product(r, r), under), rest = sum(over, {-left.high, -left.low});
    if (std::abs(rest.high) <= 0x1p-96 * over.high) return std::nullopt;
    return rest.high > 0;
  };
  for (const double r : {std::nextafter(rough, HUGE_VAL), rough, std::nextafter(rough, 0.0)}) {
    const std::optional<bool> told = fits(r);
    if (!told) return std::nullopt;
    if (*told) return r == std::nextafter(rough, HUGE_VAL) ? std::nullopt : std::optional(r);
  }
  return std::nullopt;
}

/// The components of free space that p touches: on a wall several.
std::vector<std::uint32_t> components_at(const FreeSpace& space, Point p) {
  const Triangulation& tri = space.triangulation();
  const Location at = space.locate(p);
  std::vector<std::uint32_t> touched{space.component(at.triangle)};
  if (at.kind == Location::Kind::side) {
    const std::uint32_t other = tri.neighbours[at.triangle][at.index];
    if (other != kNone && tri.free[other]) touched.push_back(space.component(other));
  }
  if (at.kind == Location::Kind::vertex)
    for (const auto& sector : tri.sectors_at(tri.triangles[at.triangle][at.index]))
      touched.push_back(space.component(sector.triangle));
  return touched;
}

}  // namespace

Rational squared_distance(Point p, const Segment& c) {
  if (const auto shape = gate_to_inside(p, c)) return squared_width(*shape);
  const bool to_a = dot_sign(c.a, c.b, p) <= 0;
  const Point end = to_a ? c.a : c.b;
  return squared_width({p, {end, end}});
}

double root_below(const Rational& squared) {
  const auto fits = [&](double r) {
    const Rational exact = meaning(r);
    return exact * exact <= squared;
  };
  double r = std::sqrt(to_double(squared));
  while (!fits(r)) r = std::nextafter(r, 0.0);
  for (double next = r; fits(next = std::nextafter(r, HUGE_VAL));) r = next;
  return r;
}

bool share_component(const FreeSpace& space, Point s, Point g) {
  const auto at_s = components_at(space, s), at_g = components_at(space, g);
  return std::find_first_of(at_s.begin(), at_s.end(), at_g.begin(), at_g.end()) != at_s.end();
}

std::optional<double> quick_distance_below(Point p, const Segment& c) {
  const Pair ux = difference(c.b.x, c.a.x), uy = difference(c.b.y, c.a.y);
  const Pair ax = difference(p.x, c.a.x), ay = difference(p.y, c.a.y), bx = difference(p.x, c.b.x),
             by = difference(p.y, c.b.y);
  for (const Pair& v : {ux, uy, ax, ay, bx, by})
    if (!twofold::is_regular(std::abs(v.high))) return std::nullopt;
  const auto squared = [](Pair x, Pair y) { return sum(product(x, x), product(y, y)); };
  if (dot_sign(c.a, c.b, p) <= 0) return root_below(squared(ax, ay), {1, 0});
  if (dot_sign(c.b, c.a, p) <= 0) return root_below(squared(bx, by), {1, 0});
  if (ux.high == 0 || uy.high == 0) {
    const Pair off = ux.high == 0 ? ax : ay;
    const double high = std::abs(off.high), low = off.high < 0 ? -off.low : off.low;
    return twofold::step_down(high, high > 0 && low < 0);
  }
  const Pair left = product(ux, ay), right = product(uy, ax), cross = sum(left, {-right.high, -right.low});
  // Products are off by 2^-100 of themselves, the rest is for the cross product's share in the square.
  if (std::abs(cross.high) < 0x1p-2 * std::abs(left.high)) return std::nullopt;
  return root_below(product(cross, cross), squared(ux, uy));
}

}  // namespace taut::detail
