#include <taut/robots/car/detail/leg_lattice.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>

namespace taut::car::detail {

namespace {

constexpr int kQuarter = kHeadings / 4;
constexpr int kLongestStraight = 34;  // steps of the lattice
constexpr std::size_t kLegsATurn = 2;
constexpr std::size_t kLegsOnto = 6;

int wrapped(int heading) { return ((heading % kHeadings) + kHeadings) % kHeadings; }

/// A quick look at whether the leg is drivable, and how long it is; what it lets through fault_of has to confirm.
std::optional<double> length_if_drivable(const Leg& leg, const CarShape& shape) {
  const HeadingVector a = heading_vector(leg.from.heading), b = heading_vector(leg.to.heading);
  const double scale = kHeadingScale, gear = leg.backward ? -1 : 1;
  const double ux = a.x / scale, uy = a.y / scale, vx = b.x / scale, vy = b.y / scale;
  const double dx = gear * (leg.to.at.x - leg.from.at.x), dy = gear * (leg.to.at.y - leg.from.at.y);
  const double sine = ux * vy - uy * vx, cosine = ux * vx + uy * vy;
  if (sine == 0) return std::nullopt;
  const double t1 = (dx * vy - dy * vx) / sine, t2 = (ux * dy - uy * dx) / sine, tangent = std::abs(sine) / (1 + cosine);
  const double used = std::min(t1, t2);
  if (used < shape.radius * tangent * (1 - 1e-9)) return std::nullopt;
  return std::abs(t1 - t2) + used / tangent * 2 * std::atan(tangent);
}

/// The shortest `most` drivable legs from the pose to nodes with a heading.
void add_legs(const LegLattice& lattice, const CarShape& shape, const LatticePose& from, int heading, bool backward,
              std::size_t most, std::vector<Leg>& legs) {
  const double half = std::abs(std::remainder(heading_angle(heading) - heading_angle(from.heading), 6.283185307179586)) / 2;
  const int reach = static_cast<int>(2 * shape.radius * std::tan(half) / lattice.step) + 12;
  const int i0 = static_cast<int>(std::lround(from.at.x / lattice.step));
  const int j0 = static_cast<int>(std::lround(from.at.y / lattice.step));
  std::vector<std::tuple<double, int, int>> found;
  const auto leg_to = [&](int i, int j) {
    return Leg{from, {{(i0 + i) * lattice.step, (j0 + j) * lattice.step}, heading}, backward};
  };
  for (int j = -reach; j <= reach; ++j)
    for (int i = -reach; i <= reach; ++i)
      if (const auto length = length_if_drivable(leg_to(i, j), shape)) found.emplace_back(*length, i, j);
  std::ranges::sort(found);
  for (std::size_t taken = 0; const auto& [length, i, j] : found) {
    if (taken == most) break;
    const Leg leg = leg_to(i, j);
    if (fault_of(leg, shape)) continue;
    legs.push_back(leg);
    ++taken;
  }
}

void add_turns(const LegLattice& lattice, const CarShape& shape, const LatticePose& from, std::size_t most,
               bool all_turns, std::vector<Leg>& legs) {
  for (int turn = lattice.stride; turn <= kQuarter; turn = all_turns ? turn + lattice.stride : 2 * turn)
    for (const int side : {1, -1})
      for (const bool backward : {false, true})
        if (!backward || shape.reverse)
          add_legs(lattice, shape, from, wrapped(from.heading + side * turn), backward, most, legs);
}

void add_straights(const LegLattice& lattice, const CarShape& shape, int heading, std::vector<Leg>& legs) {
  const HeadingVector h = heading_vector(heading);
  const int common = std::gcd(h.x, h.y), x = h.x / common, y = h.y / common;
  if (kHeadingScale / common > kLongestStraight) return;
  for (const bool backward : {false, true})
    if (!backward || shape.reverse) {
      const double way = backward ? -lattice.step : lattice.step;
      legs.push_back({{{0, 0}, heading}, {{way * x, way * y}, heading}, backward});
    }
}

}  // namespace

bool LegLattice::holds(const LatticePose& pose) const {
  return pose.heading % stride == 0 && std::fmod(pose.at.x, step) == 0 && std::fmod(pose.at.y, step) == 0;
}

std::vector<std::vector<Primitive>> primitives(const LegLattice& lattice, const CarShape& shape) {
  std::vector<std::vector<Primitive>> all;
  for (int heading = 0; heading < kHeadings; heading += lattice.stride) {
    std::vector<Leg> legs;
    add_straights(lattice, shape, heading, legs);
    add_turns(lattice, shape, {{0, 0}, heading}, kLegsATurn, false, legs);
    std::vector<Primitive> of_heading;
    for (const Leg& leg : legs)
      of_heading.push_back({PreparedLeg(leg, shape), static_cast<int>(leg.to.at.x / lattice.step),
                            static_cast<int>(leg.to.at.y / lattice.step)});
    all.push_back(std::move(of_heading));
  }
  return all;
}

std::vector<Leg> legs_onto(const LegLattice& lattice, const CarShape& shape, const LatticePose& from) {
  std::vector<Leg> legs;
  // From a heading off the lattice: to those on either side of it.
  LatticePose base = from;
  if (from.heading % lattice.stride == 0) {
    add_turns(lattice, shape, from, kLegsOnto, true, legs);
    return legs;
  }
  for (int heading = 0; heading < kHeadings; heading += lattice.stride) {
    const int turn = wrapped(heading - from.heading);
    if (std::min(turn, kHeadings - turn) > kQuarter) continue;
    for (const bool backward : {false, true})
      if (!backward || shape.reverse) add_legs(lattice, shape, base, heading, backward, kLegsOnto, legs);
  }
  return legs;
}

std::vector<Leg> legs_to(const CarShape& shape, const LatticePose& from, Point to, const std::vector<int>& headings) {
  std::vector<Leg> legs;
  for (const int heading : headings) {
    const int turn = wrapped(heading - from.heading);
    if (std::min(turn, kHeadings - turn) > kQuarter) continue;
    for (const bool backward : {false, true}) {
      const Leg leg{from, {to, heading}, backward};
      if (turn != 0 && !length_if_drivable(leg, shape)) continue;
      if (!fault_of(leg, shape)) legs.push_back(leg);
    }
  }
  return legs;
}

}  // namespace taut::car::detail
