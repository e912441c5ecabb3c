#include <taut/search/detail/integer_world.h>

#include <algorithm>
#include <cmath>

namespace taut::detail {

namespace {

using Tri = Triangulation;

constexpr int kSteps = 512;  // of a walk that may circle where a triangulation is not Delaunay's

}  // namespace

IntegerWorld::IntegerWorld(const FreeSpace& space, const IntegerPlaces& places)
    : space_(space), tri_(space_.triangulation()), places_(places), at_(tri_.points.size()) {
  Place most{0, 0};
  for (std::size_t v = 0; v < at_.size(); ++v) {
    places_.find(tri_.points[v], at_[v]);
    most = {std::max(most[0], at_[v][0]), std::max(most[1], at_[v][1])};
  }
  const double area = (most[0] + 1.0) * (most[1] + 1.0), cells = 1 + static_cast<double>(tri_.triangles.size()) / 2;
  while (std::ldexp(1.0, 2 * (shift_ + 1)) * cells <= area) ++shift_;
  columns_ = static_cast<std::size_t>(most[0] >> shift_) + 1;
  rows_ = static_cast<std::size_t>(most[1] >> shift_) + 1;
  hints_.assign(columns_ * rows_, kNone);
  for (std::uint32_t t = 0; t < tri_.triangles.size(); ++t) {
    const auto& v = tri_.triangles[t];
    const auto middle = [&](int axis) {
      return static_cast<std::int32_t>((std::int64_t{at_[v[0]][axis]} + at_[v[1]][axis] + at_[v[2]][axis]) / 3);
    };
    hints_[cell({middle(0), middle(1)})] = t;
  }
  std::uint32_t last = 0;
  for (std::uint32_t& hint : hints_) last = hint = hint == kNone ? last : hint;
}

/// kNone where it leaves the hull or does not end.
std::uint32_t IntegerWorld::walk(Place p) const {
  std::uint32_t t = hints_[cell(p)];
  int first = 0;
  for (int steps = 0; steps < kSteps && t != kNone; ++steps) {
    int out = -1;
    for (int k = 0; k < 3 && out < 0; ++k)
      if (const int i = (first + k) % 3; side(t, i, p) < 0) out = i;
    if (out < 0) return t;
    t = tri_.neighbours[t][out];
    first = steps % 3;
  }
  return kNone;
}

bool IntegerWorld::find(Point p, PlaceAt& place) const {
  if (tri_.triangles.empty() || !places_.find(p, place.at)) return false;
  const std::uint32_t t = walk(place.at);
  if (t == kNone) return false;
  int on = -1;
  for (int i = 0; i < 3; ++i) {
    if (side(t, i, place.at) != 0) continue;
    if (on >= 0) return false;  // a vertex
    on = i;
  }
  place.count = 0;
  place.triangles = {kNone, kNone};
  place.is_on_constraint = on >= 0 && tri_.is_constrained(t, on);
  const auto add = [&](std::uint32_t held) {
    if (held != kNone && tri_.free[held]) place.triangles[place.count++] = held;
  };
  add(t);
  if (on >= 0) add(tri_.neighbours[t][on]);
  return place.count > 0;
}

IntegerWorld::Sight IntegerWorld::sees(const PlaceAt& from, const PlaceAt& to) const {
  if (from.is_on_constraint || to.is_on_constraint) return Sight::unknown;
  std::uint32_t t = from.triangles[0];
  if (to.is_in(t) || (from.count > 1 && to.is_in(from.triangles[1]))) return Sight::yes;
  const Place d = IntegerPlaces::difference(to.at, from.at);
  int entered = -1;
  for (int steps = 0; steps < 1 << 20; ++steps) {
    const auto& corners = tri_.triangles[t];
    std::int64_t turn[3];
    for (int k = 0; k < 3; ++k) turn[k] = IntegerPlaces::cross(d, IntegerPlaces::difference(at_[corners[k]], from.at));
    int out = -1;
    for (int k = 0; k < 3; ++k) {
      const int right = Tri::ccw(k), left = Tri::cw(k);
      if (k == entered || turn[right] >= 0 || turn[left] <= 0) continue;
      if (entered >= 0 || side(t, k, to.at) < 0) out = k;
    }
    if (out < 0) return Sight::unknown;
    if (tri_.is_constrained(t, out)) return side(t, out, to.at) >= 0 ? Sight::unknown : Sight::no;
    const std::uint32_t n = tri_.neighbours[t][out];
    if (to.is_in(n)) return Sight::yes;
    entered = tri_.mirror(t, out);
    t = n;
  }
  return Sight::unknown;
}

}  // namespace taut::detail
