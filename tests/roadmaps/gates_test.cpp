#include <taut/roadmaps/gates.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <taut/geometry/exact/numbers.h>

#include <set>
#include <tuple>

#include <taut/geometry/exact/exact_point.h>

#include "support/random_world.h"
#include "support/small_world.h"

namespace taut {
namespace {

using test::SmallWorld;

/// 10 x 10, walled in.
FreeSpace room(const std::vector<Segment>& walls) {
  auto parts = SmallWorld{.walls = walls, .solids = {}}.parts();
  parts.boundary = Boundary::walled;
  return FreeSpace(World(parts));
}

struct ExactPlace {
  Rational x, y;
  friend bool operator==(const ExactPlace& a, const ExactPlace& b) { return a.x == b.x && a.y == b.y; }
};

ExactPlace rational(Point p) { return {meaning(p.x), meaning(p.y)}; }
ExactPlace minus(const ExactPlace& a, const ExactPlace& b) { return {a.x - b.x, a.y - b.y}; }
Rational dot(const ExactPlace& a, const ExactPlace& b) { return a.x * b.x + a.y * b.y; }

/// The point of a b nearest to p.
ExactPlace nearest(const ExactPlace& p, Point a, Point b) {
  const ExactPlace from = rational(a), u = minus(rational(b), from);
  Rational t = dot(minus(p, from), u) / dot(u, u);
  if (t < 0) t = 0;
  if (t > 1) t = 1;
  return {from.x + t * u.x, from.y + t * u.y};
}

/// Is a point of a b, other than p and q, in the closed disc on p q?
bool in_disc(const ExactPlace& p, const ExactPlace& q, Point a, Point b) {
  const ExactPlace m{(p.x + q.x) / 2, (p.y + q.y) / 2}, x = nearest(m, a, b);
  const Rational inside = dot(minus(x, p), minus(x, q));
  return inside < 0 || (inside == 0 && !(x == p) && !(x == q));
}

/// Is a point of a b nearer to q than p is?
bool is_nearer(const ExactPlace& p, const ExactPlace& q, Point a, Point b) {
  const ExactPlace to_p = minus(p, q), to_x = minus(nearest(q, a, b), q);
  return dot(to_x, to_x) < dot(to_p, to_p);
}

/// (end or foot, foot or end, to_opening), the smaller point first, in doubles.
using Named = std::set<std::tuple<Point, Point, bool>>;

Named named(const Gates& gates) {
  Named result;
  for (const Gate& g : gates.gates()) result.insert({std::min(g.end, g.foot), std::max(g.end, g.foot), g.to_opening});
  return result;
}

/// Every end against every constraint, every candidate against every wall.
Named brute_force(const Gates& gates) {
  const auto& all = gates.space().constraints();
  const auto no_wall = [&](auto is_in_the_way, const ExactPlace& p, const ExactPlace& q) {
    for (std::uint32_t c = 0; c < all.size(); ++c)
      if (!gates.is_opening(c) && is_in_the_way(p, q, all[c].a, all[c].b)) return false;
    return true;
  };
  const auto is_gate = [&](const ExactPlace& p, bool p_is_wall, const ExactPlace& q, bool q_is_wall) {
    if (p_is_wall && q_is_wall) return no_wall(in_disc, p, q);
    return p_is_wall ? no_wall(is_nearer, p, q) : no_wall(is_nearer, q, p);
  };
  const auto is_wall_end = [&](Point p) {
    for (std::uint32_t c = 0; c < all.size(); ++c)
      if (!gates.is_opening(c) && (all[c].a == p || all[c].b == p)) return true;
    return false;
  };
  Named result;
  for (const Constraint& from : all)
    for (const Point end : {from.a, from.b})
      for (std::uint32_t c = 0; c < all.size(); ++c) {
        const ExactPlace p = rational(end), q = nearest(p, all[c].a, all[c].b);
        const Point foot{nearest_double(q.x), nearest_double(q.y)};
        const bool foot_is_end = q == rational(all[c].a) || q == rational(all[c].b);
        const bool here = is_wall_end(end), there = foot_is_end ? is_wall_end(foot) : !gates.is_opening(c);
        if (p == q || (!here && !there) || !is_gate(p, here, q, there)) continue;
        result.insert({std::min(end, foot), std::max(end, foot), !here || !there});
      }
  return result;
}

TEST(Gates, ADoorHasItsWidth) {
  const Gates gates(room({{{0, 5}, {4, 5}}, {{6, 5}, {10, 5}}}));
  ASSERT_FALSE(gates.gates().empty());
  const Gate& door = gates.gates().front();
  EXPECT_EQ(door.width, 2);
  EXPECT_EQ(gates.name(0), "2 between (4, 5) and (6, 5)");
  EXPECT_TRUE(gates.compare_width(0, 2) == 0);
  EXPECT_TRUE(gates.compare_width(0, std::nextafter(2, 3)) < 0);
}

TEST(Gates, AWidthIsNamedAsAFraction) {
  const Gates gates(room({{{7, 3}, {7.5, 3}}, {{7.9, 3}, {9, 3}}}));
  EXPECT_EQ(gates.name(0), "2/5 between (7.5, 3) and (7.9, 3)");
}

TEST(Gates, AnEndFacesTheInsideOfATiltedWall) {
  const Gates gates(room({{{2, 2}, {6, 5}}, {{5, 2}, {8, 1}}}));
  bool found = false;
  for (const Gate& g : gates.gates())
    if (g.end == Point{5, 2} && !g.foot_is_exact) {
      found = true;
      EXPECT_DOUBLE_EQ(g.width, 9.0 / 5);
      EXPECT_DOUBLE_EQ(g.foot.x, 2 + 12.0 / 5 * 4 / 5);
    }
  EXPECT_TRUE(found);
}

TEST(Gates, AnOpeningCountsTwice) {
  // The right side of the box is bare: a disc of radius 1 just passes between the wall's end and the opening.
  const SmallWorld world{.walls = {{{0, 0}, {10, 0}}, {{0, 10}, {10, 10}}, {{0, 0}, {0, 10}}, {{0, 5}, {9, 5}}},
                         .solids = {}};
  const Gates gates(world.space());
  ASSERT_FALSE(gates.gates().empty());
  EXPECT_TRUE(gates.gates()[0].to_opening);
  EXPECT_EQ(gates.name(0), "2 between (9, 5) and (10, 5)");
}

TEST(Gates, WidthsAscend) {
  const Gates gates(room({{{1, 2}, {3, 7}}, {{5, 1}, {4, 6}}, {{8, 3}, {7, 9}}}));
  for (std::uint32_t i = 0; i + 1 < gates.gates().size(); ++i) EXPECT_TRUE(gates.compare_widths(i, i + 1) <= 0);
}

RC_GTEST_PROP(Gates, AreThoseOfTheBruteForce, ()) {
  SmallWorld world = test::any_world({.side = 6, .walls = 6, .solids = 2, .straight = test::any(0, 1) == 1});
  RC_LOG(test::show(world));
  auto parts = world.parts();
  parts.boundary = test::any(0, 1) ? Boundary::walled : Boundary::limit;
  const Gates gates{FreeSpace(World(parts))};
  const Named ours = named(gates), theirs = brute_force(gates);
  // Gates within solids are of no use and not looked for.
  for (const auto& gate : ours) RC_ASSERT(theirs.contains(gate));
  for (const auto& gate : theirs) {
    const auto& [p, q, to_opening] = gate;
    const Point m{(p.x + q.x) / 2, (p.y + q.y) / 2};
    if (gates.space().locate(m).kind == Location::Kind::triangle) RC_ASSERT(ours.contains(gate));
  }
}

}  // namespace
}  // namespace taut
