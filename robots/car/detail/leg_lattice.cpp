#include <taut/robots/car/detail/leg_lattice.h>

#include <algorithm>
#include <cmath>
#include <compare>
#include <cstdint>
#include <numeric>
#include <optional>
#include <utility>

namespace taut::car::detail {

namespace {

constexpr int kQuarter = kHeadings / 4;
constexpr int kLongestStraight = 34;  // steps of the lattice
constexpr std::size_t kLegsATurn = 2;
constexpr std::size_t kLegsOnto = 6;

int wrapped(int heading) { return ((heading % kHeadings) + kHeadings) % kHeadings; }

/// The tangents of a leg and how long it is, to rounding.
struct Tangents {
  Tangents(int from, int to) {
    const HeadingVector a = heading_vector(from), b = heading_vector(to);
    const double scale = kHeadingScale;
    u = {a.x / scale, a.y / scale};
    v = {b.x / scale, b.y / scale};
    sine = u.x * v.y - u.y * v.x;
    half = std::abs(sine) / (1 + u.x * v.x + u.y * v.y);
  }

  /// Of a leg that goes by d; what this lets through validate has to confirm. Precondition: sine is not 0.
  std::optional<double> length(Point d, double radius) const {
    const double t1 = (d.x * v.y - d.y * v.x) / sine, t2 = (u.x * d.y - u.y * d.x) / sine, used = std::min(t1, t2);
    if (used < radius * half * (1 - 1e-9)) return std::nullopt;
    return std::abs(t1 - t2) + used / half * 2 * std::atan(half);
  }

  Point u{}, v{};
  double sine = 0, half = 0;  ///< sine of the turn, tangent of half of it
};

struct Candidate {
  double length;
  std::int64_t i, j;
  friend auto operator<=>(const Candidate&, const Candidate&) = default;
};

/// The nodes that legs from the pose reach with tangents at most `more` longer than the tightest turn needs, and some
/// further ones; shortest legs first.
std::vector<Candidate> candidates(const LegLattice& lattice, double radius, const LatticePose& from,
                                  const Tangents& turn, double gear, double more) {
  const double least = radius * turn.half, most = least + more;
  Box box{{1e300, 1e300}, {-1e300, -1e300}};
  for (const double t1 : {least, most})
    for (const double t2 : {least, most}) {
      const double x = from.at.x + gear * (t1 * turn.u.x + t2 * turn.v.x),
                   y = from.at.y + gear * (t1 * turn.u.y + t2 * turn.v.y);
      box = {{std::min(box.min.x, x), std::min(box.min.y, y)}, {std::max(box.max.x, x), std::max(box.max.y, y)}};
    }
  const auto below = [&](double x) { return static_cast<std::int64_t>(std::floor(x / lattice.step)); };
  std::vector<Candidate> found;
  for (std::int64_t j = below(box.min.y); j <= below(box.max.y) + 1; ++j)
    for (std::int64_t i = below(box.min.x); i <= below(box.max.x) + 1; ++i) {
      const double x = static_cast<double>(i) * lattice.step, y = static_cast<double>(j) * lattice.step;
      if (const auto length = turn.length({gear * (x - from.at.x), gear * (y - from.at.y)}, radius))
        found.push_back({*length, i, j});
    }
  std::ranges::sort(found);
  return found;
}

/// The shortest `most` drivable legs from the pose to nodes with a heading. A leg whose tangents are `more` longer than
/// needed is at least `more` longer than the tightest turn, so those that are less than that longer are all known.
void add_legs(const LegLattice& lattice, const CarShape& shape, const LatticePose& from, int heading, bool backward,
              std::size_t most, std::vector<Leg>& legs) {
  const Tangents turn(from.heading, heading);
  const double tightest = shape.radius * 2 * std::atan(turn.half);
  std::vector<Leg> found;
  for (double more = lattice.step * (4 + std::sqrt(12 / std::abs(turn.sine))); found.size() < most; more *= 2) {
    found.clear();
    for (const Candidate& c : candidates(lattice, shape.radius, from, turn, backward ? -1 : 1, more)) {
      if (found.size() == most || c.length > tightest + more) break;
      const Leg leg{from,
                    {{static_cast<double>(c.i) * lattice.step, static_cast<double>(c.j) * lattice.step}, heading},
                    backward};
      if (!validate(leg, shape)) found.push_back(leg);
    }
  }
  legs.insert(legs.end(), found.begin(), found.end());
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
    of_heading.reserve(legs.size());
    for (const Leg& leg : legs)
      of_heading.push_back({PreparedLeg(leg, shape), static_cast<int>(leg.to.at.x / lattice.step),
                            static_cast<int>(leg.to.at.y / lattice.step)});
    all.push_back(std::move(of_heading));
  }
  return all;
}

std::vector<Leg> legs_onto(const LegLattice& lattice, const CarShape& shape, const LatticePose& from) {
  std::vector<Leg> legs;
  if (from.heading % lattice.stride == 0) {
    add_turns(lattice, shape, from, kLegsOnto, true, legs);
    return legs;
  }
  for (int heading = 0; heading < kHeadings; heading += lattice.stride) {
    const int turn = wrapped(heading - from.heading);
    if (std::min(turn, kHeadings - turn) > kQuarter) continue;
    for (const bool backward : {false, true})
      if (!backward || shape.reverse) add_legs(lattice, shape, from, heading, backward, kLegsOnto, legs);
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
      const double gear = backward ? -1 : 1;
      const Point d{gear * (to.x - from.at.x), gear * (to.y - from.at.y)};
      if (turn != 0 && !Tangents(from.heading, heading).length(d, shape.radius)) continue;
      if (!validate(leg, shape)) legs.push_back(leg);
    }
  }
  return legs;
}

}  // namespace taut::car::detail
