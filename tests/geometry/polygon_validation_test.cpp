#include <taut/geometry/detail/polygon_validation.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include <taut/geometry/written.h>

namespace taut::detail {
namespace {

Ring square(double x0, double y0, double x1, double y1) { return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}; }

// The first flaw; "accepted" when there is none.
std::string verdict(Polygon polygon) {
  std::vector<Flaw> flaws;
  admit(std::move(polygon), flaws);
  return flaws.empty() ? "accepted" : flaws.front().message;
}

std::vector<Polygon> meant(Polygon polygon, Crossings crossings = Crossings::refuse) {
  std::vector<Flaw> flaws;
  return admit(std::move(polygon), flaws, crossings);
}

// Independent of the gate: crossings of a ray to the right, in doubles. Precondition: p is far from all sides.
bool is_odd(Point p, const Ring& ring) {
  bool odd = false;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    const Point a = ring[j], b = ring[i];
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) * (b.x - a.x) / (b.y - a.y)) odd = !odd;
  }
  return odd;
}

bool is_meant(Point p, const Polygon& polygon) {
  return is_odd(p, polygon.outer) &&
         std::none_of(polygon.holes.begin(), polygon.holes.end(), [p](const Ring& hole) { return is_odd(p, hole); });
}

Ring random_ring(int most) {
  Ring ring;
  for (int i = *rc::gen::inRange(3, most); i > 0; --i)
    ring.push_back({static_cast<double>(*rc::gen::inRange(0, 7)), static_cast<double>(*rc::gen::inRange(0, 7))});
  return ring;
}

TEST(PolygonGate, DropsRepeatedVerticesAndTurnsRings) {
  const Polygon polygon = meant({{{0, 0}, {0, 4}, {0, 4}, {4, 4}, {4, 0}, {0, 0}}, {square(1, 1, 2, 2)}}).at(0);
  EXPECT_EQ(polygon.outer, (Ring{{0, 0}, {4, 0}, {4, 4}, {0, 4}}));
  EXPECT_EQ(written::ring_orientation(polygon.holes[0]), -1);
}

TEST(PolygonGate, KeepsStraightThroughVertices) {
  EXPECT_EQ(verdict({{{0, 0}, {2, 0}, {4, 0}, {4, 4}, {0, 4}}, {}}), "accepted");
}

TEST(PolygonGate, FindsBowTies) {
  EXPECT_EQ(verdict({{{0, 0}, {4, 4}, {4, 0}, {0, 4}}, {}}),
            "ring crosses itself: side (0, 0)-(4, 4) and side (4, 0)-(0, 4)");
}

TEST(PolygonGate, FindsAVertexOnAnotherSide) {
  EXPECT_EQ(verdict({{{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}}, {}}),
            "ring touches itself at (2, 0): side (0, 0)-(4, 0) and side (4, 4)-(2, 0)");
}

TEST(PolygonGate, FindsTouchesAndOverlaps) {
  EXPECT_EQ(verdict({{{0, 0}, {4, 0}, {2, 2}, {4, 4}, {0, 4}, {2, 2}}, {}}),
            "ring touches itself at (2, 2): side (4, 0)-(2, 2) and side (0, 4)-(2, 2)");
  EXPECT_EQ(verdict({{{1, 0}, {2, 0}, {2, 1}, {3, 1}, {3, 0}, {0, 0}, {0, 1}}, {}}),
            "ring overlaps itself: side (1, 0)-(2, 0) and side (3, 0)-(0, 0)");
  EXPECT_EQ(verdict({{{0, 0}, {4, 0}, {4, 2}, {3, 0}, {1, 0}, {0, 2}}, {}}).substr(0, 29),
            "ring touches itself at (3, 0)");
}

TEST(PolygonGate, FindsSpikesAndFlatRings) {
  EXPECT_EQ(verdict({{{0, 0}, {4, 0}, {4, 4}, {8, 4}, {4, 4}, {0, 4}}, {}}),
            "ring has a spike at (8, 4): side (8, 4)-(4, 4) folds back over side (4, 4)-(8, 4)");
  EXPECT_EQ(verdict({{{0, 0}, {4, 4}, {2, 2}}, {}}),
            "ring has a spike at (4, 4): side (4, 4)-(2, 2) folds back over side (0, 0)-(4, 4)");
  EXPECT_EQ(verdict({{{0, 0}, {4, 4}, {0, 0}}, {}}), "ring near (0, 0) has fewer than 3 distinct points");
}

TEST(PolygonGate, DecidesHairWidthsExactly) {
  const double up = std::nextafter(1.0, 2.0), down = std::nextafter(1.0, 0.0);
  EXPECT_EQ(verdict({{{0, 0}, {3, 3}, {1, up}, {0, 3}}, {}}), "accepted");
  EXPECT_NE(verdict({{{0, 0}, {3, 3}, {1, down}, {0, 3}}, {}}), "accepted");
  EXPECT_NE(verdict({{{0, 0}, {3, 3}, {1, 1}, {0, 3}}, {}}), "accepted");
}

TEST(PolygonGate, LetsHolesTouchAtPoints) {
  EXPECT_EQ(verdict({square(0, 0, 8, 8), {{{0, 4}, {4, 2}, {4, 4}}, {{4, 4}, {6, 4}, {6, 6}}}}), "accepted");
  EXPECT_EQ(verdict({square(0, 0, 8, 8), {{{4, 0}, {8, 4}, {4, 8}, {0, 4}}}}), "accepted");
}

TEST(PolygonGate, FindsHolesOutsideTheirRing) {
  EXPECT_EQ(verdict({square(0, 0, 4, 4), {square(5, 0, 6, 1)}}), "hole 1 at (5, 0) does not lie inside its outer ring");
  EXPECT_EQ(verdict({square(0, 0, 4, 4), {{{4, 2}, {5, 1}, {5, 3}}}}),
            "hole 1 at (4, 2) does not lie inside its outer ring");
  EXPECT_EQ(verdict({square(0, 0, 4, 4), {square(-1, -1, 5, 5)}}),
            "hole 1 at (-1, -1) does not lie inside its outer ring");
}

TEST(PolygonGate, FindsHolesThatCrossTheirRingAtItsVertices) {
  EXPECT_EQ(
      verdict({{{0, 0}, {4, 0}, {4, 2}, {4, 4}, {0, 4}}, {{{2, 2}, {4, 2}, {5, 3}, {5, 5}, {3, 5}}}}).substr(0, 30),
      "hole 1 crosses the outer ring:");
}

TEST(PolygonGate, FindsHolesAlongARing) {
  EXPECT_EQ(verdict({square(0, 0, 4, 4), {square(0, 1, 1, 2)}}).substr(0, 33), "hole 1 runs along the outer ring:");
}

TEST(PolygonGate, FindsHolesInHoles) {
  EXPECT_EQ(verdict({square(0, 0, 9, 9), {square(3, 3, 4, 4), square(2, 2, 6, 6)}}),
            "hole 1 at (3, 3) does not lie apart from hole 2");
  EXPECT_EQ(verdict({square(0, 0, 9, 9), {square(2, 2, 6, 6), {{2, 4}, {4, 3}, {4, 5}}}}),
            "hole 2 at (2, 4) does not lie apart from hole 1");
}

RC_GTEST_PROP(PolygonGate, AgreesWithTestingAllPairsOfSides, ()) {
  Ring ring;
  for (int i = *rc::gen::inRange(3, 30); i > 0; --i)
    ring.push_back({static_cast<double>(*rc::gen::inRange(0, 12)), static_cast<double>(*rc::gen::inRange(0, 12))});
  Ring clean = ring;
  clean.erase(std::unique(clean.begin(), clean.end()), clean.end());
  while (clean.size() > 1 && clean.front() == clean.back()) clean.pop_back();
  const std::size_t n = clean.size();
  bool simple = n >= 3;
  for (std::size_t i = 0; simple && i < n; ++i) {
    const Segment s{clean[i], clean[(i + 1) % n]};
    const Point next = clean[(i + 2) % n];
    simple = !written::on_segment(next, s.a, s.b) && !written::on_segment(s.a, s.b, next);
    for (std::size_t j = 0; simple && j < n; ++j)
      if (j != i && (j + 1) % n != i && (i + 1) % n != j)
        simple = !written::segments_meet(s, {clean[j], clean[(j + 1) % n]});
  }
  RC_TAG(simple ? "simple" : "not simple");
  RC_ASSERT((verdict({clean, {}}) == "accepted") == simple);
}

TEST(PolygonGate, LeavesOutWhatHasNoWidth) {
  const std::vector<Polygon> room{{square(0, 0, 4, 4), {}}};
  EXPECT_EQ(meant({{{0, 0}, {4, 0}, {4, 4}, {2, 4}, {2, 7}, {2, 4}, {0, 4}}, {}}), room) << "a spike outwards";
  EXPECT_EQ(meant({{{0, 0}, {4, 0}, {4, 4}, {2, 4}, {2, 1}, {2, 4}, {0, 4}}, {}}), room) << "a slit";
  EXPECT_EQ(meant({square(0, 0, 4, 4), {{{1, 1}, {2, 2}, {3, 3}}}}), room) << "a hole without area";
  EXPECT_TRUE(meant({{{0, 0}, {4, 4}, {2, 2}}, {}}).empty());
}

TEST(PolygonGate, TakesARingThatTouchesItselfAsItsInside) {
  EXPECT_EQ(meant({{{0, 0}, {4, 0}, {2, 2}, {4, 4}, {0, 4}, {2, 2}}, {}}),
            (std::vector<Polygon>{{{{0, 0}, {4, 0}, {2, 2}}, {}}, {{{0, 4}, {2, 2}, {4, 4}}, {}}}));
  EXPECT_EQ(meant({{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {1, 3}, {3, 1}}, {}}).at(0).holes.size(), 1U);
}

TEST(PolygonGate, TakesHolesAwayThatShareAStretch) {
  EXPECT_EQ(meant({square(0, 0, 4, 4), {square(0, 1, 4, 2)}}),
            (std::vector<Polygon>{{square(0, 0, 4, 1), {}}, {square(0, 2, 4, 4), {}}}));
  EXPECT_EQ(meant({square(0, 0, 9, 9), {square(1, 1, 2, 2), square(2, 1, 3, 2)}}).at(0).holes,
            (std::vector<Ring>{{{1, 1}, {1, 2}, {3, 2}, {3, 1}}}));
  EXPECT_TRUE(meant({square(0, 0, 4, 4), {square(0, 0, 4, 4)}}).empty());
}

TEST(PolygonGate, MeansNothingWhereRingsCrossUntilTold) {
  const Polygon bow_tie{{{0, 0}, {4, 4}, {4, 0}, {0, 4}}, {}}, over{square(0, 0, 4, 4), {square(3, 1, 6, 2)}};
  EXPECT_TRUE(meant(bow_tie).empty());
  EXPECT_EQ(meant(bow_tie, Crossings::even_odd).size(), 2U);
  EXPECT_TRUE(meant(over).empty());
  EXPECT_EQ(meant(over, Crossings::even_odd),
            (std::vector<Polygon>{{{{0, 0}, {4, 0}, {4, 1}, {3, 1}, {3, 2}, {4, 2}, {4, 4}, {0, 4}}, {}}}));
}

TEST(PolygonGate, DoubtsRingsThatWindTwice) {
  EXPECT_EQ(verdict({{{0, 0}, {9, 0}, {9, 9}, {0, 9}, {0, 0}, {4, 1}, {4, 4}, {1, 4}}, {}}).substr(0, 12),
            "ring touches");
  std::vector<Flaw> flaws;
  admit({{{0, 0}, {9, 0}, {9, 9}, {0, 9}, {0, 0}, {4, 1}, {4, 4}, {1, 4}}, {}}, flaws);
  EXPECT_TRUE(flaws.back().is_ambiguous());
}

RC_GTEST_PROP(PolygonGate, AgreesWithEvenOddRaysAndIsItsOwnFixedPoint, ()) {
  Polygon polygon{random_ring(12), {}};
  for (int holes = *rc::gen::inRange(0, 3); holes > 0; --holes) polygon.holes.push_back(random_ring(6));
  const std::vector<Polygon> parts = meant(polygon, Crossings::even_odd);
  for (const Polygon& part : parts) RC_ASSERT(meant(part) == std::vector<Polygon>{part});
  for (double x = 0.03141592653589793; x < 6; x += 0.2718281828459045)
    for (double y = 0.05772156649015329; y < 6; y += 0.1618033988749895) {
      const auto in = std::count_if(parts.begin(), parts.end(), [&](const Polygon& p) { return is_meant({x, y}, p); });
      RC_ASSERT(in == (is_meant({x, y}, polygon) ? 1 : 0));
    }
}

TEST(PolygonGate, IsFastOnLargeStars) {
  Ring ring;
  constexpr int kCorners = 20000;
  for (int i = 0; i < kCorners; ++i) {
    const double angle = 2 * M_PI * i / kCorners, radius = i % 2 == 0 ? 100 : 101;
    ring.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  EXPECT_EQ(verdict({ring, {}}), "accepted");
  std::swap(ring[5], ring[9000]);
  EXPECT_EQ(verdict({ring, {}}).substr(0, 20), "ring crosses itself:");
}

}  // namespace
}  // namespace taut::detail
