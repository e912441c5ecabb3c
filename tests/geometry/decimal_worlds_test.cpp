// Worlds as people write them: what lies on what in decimals lies there.
#include <cmath>
#include <cstdlib>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include <support/exact_arrangement.h>
#include <support/small_world.h>
#include <taut/geometry/written.h>
#include <taut/roadmaps/tangent_graph.h>
#include <taut/search/arc_search.h>
#include <taut/search/disc_passage.h>
#include <taut/search/shortest_path.h>
#include <taut/search/verify.h>

namespace taut {
namespace {

using test::box_ring;
using test::SmallWorld;

/// How many worlds a test draws: so many by default, or what TAUT_RANDOM_WORLDS says.
int worlds(int usual) {
  const char* asked = std::getenv("TAUT_RANDOM_WORLDS");
  return asked ? std::atoi(asked) : usual;
}

class Draw {
 public:
  explicit Draw(unsigned seed) : engine_(seed) {}
  int upto(int n) { return static_cast<int>(engine_() % static_cast<unsigned>(n + 1)); }
  int between(int a, int b) { return a + upto(b - a); }

 private:
  std::mt19937 engine_;
};

Point place(int x, int y, int places) { return {written::number(x, places), written::number(y, places)}; }

/// A wall from the left side to the right one, and another that stands on it and reaches the upper side.
struct TJunction {
  World world;
  Point left, right;  // above the first wall, on both sides of the second
};

std::optional<TJunction> t_junction(Draw& draw, int places) {
  const int unit = places == 1 ? 10 : 100, size = 4 * unit;
  const int a = draw.between(1, size / 2), b = draw.between(1, size / 2);
  // Where the wall from (0, a) to (size, b) passes a point of the lattice.
  std::vector<std::pair<int, int>> on;
  for (int x = unit / 2; x <= size - unit / 2; ++x)
    if ((b - a) * x % size == 0) on.emplace_back(x, a + (b - a) * x / size);
  if (on.empty() || a == b) return std::nullopt;
  const auto [x, y] = on[static_cast<std::size_t>(draw.upto(static_cast<int>(on.size()) - 1))];
  const int top = draw.between(x - unit / 4, x + unit / 4);
  SmallWorld world{
      .walls = {{place(0, a, places), place(size, b, places)}, {place(x, y, places), place(top, size, places)}},
      .area = box_ring(0, 0, 4, 4)};
  return TJunction{World(world.parts()), place(unit / 8, size - 1, places), place(size - unit / 8, size - 1, places)};
}

TEST(DecimalWorld, DoesNotLeakAtAWallThatStandsOnAnother) {
  Draw draw(1);
  int drawn = 0;
  for (const int wanted = worlds(200); drawn < wanted;) {
    const auto t = t_junction(draw, 1 + drawn % 2);
    if (!t) continue;
    ++drawn;
    EXPECT_EQ(shortest_path(FreeSpace(t->world), t->left, t->right), std::nullopt) << drawn;
  }
}

/// Two rooms of one plan: the lower side of the second lies along the upper side of the first.
TEST(DecimalWorld, HasADoorWhereRoomsShareAStretchOfWall) {
  Draw draw(2);
  for (int k = 0; k < worlds(100); ++k) {
    const int rise = draw.between(1, 6), width = 10 * draw.between(3, 6), base = draw.between(20, 40);
    // The wall is y = base + rise x / 10.
    const auto wall = [&](int x) { return base + rise * x / 10; };
    const int from = 10 * draw.between(0, width / 20), to = width - 10 * draw.between(0, 1) + 10;
    WorldParts parts;
    parts.boundary = Boundary::walled;
    parts.areas.push_back(
        {{{place(0, 0, 1), place(width, 0, 1), place(width, wall(width), 1), place(0, base, 1)}, {}}, 0});
    parts.areas.push_back(
        {{{place(from, wall(from), 1), place(to, wall(to), 1), place(to, 150, 1), place(from, 150, 1)}, {}}, 0});
    const FreeSpace space{World(parts)};
    const int door_from = from, door_to = std::min(width, to), middle = (door_from + door_to) / 20 * 10;
    const Point below = place(middle, base / 2, 1), above = place(middle, 145, 1);
    const auto path = shortest_path(space, below, above);
    ASSERT_TRUE(path) << k;
    EXPECT_EQ(path->points.size(), 2u) << k;
  }
}

TEST(DecimalWorld, LetsAPathStartExactlyOnASlantedSide) {
  Draw draw(3);
  for (int k = 0; k < worlds(200); ++k) {
    const Point a = place(draw.between(0, 40), draw.between(0, 20), 1),
                b = place(draw.between(60, 99), draw.between(0, 20), 1),
                c = place(draw.between(20, 70), draw.between(40, 99), 1);
    WorldParts parts;
    parts.boundary = Boundary::walled;
    parts.areas.push_back({{{a, b, c}, {}}, 0});
    const FreeSpace space{World(parts)};
    for (const Segment& side : {Segment{a, b}, Segment{b, c}, Segment{c, a}}) {
      const Point p = written::middle(side);
      EXPECT_EQ(space.locate(p).kind, Location::Kind::side);
      EXPECT_TRUE(shortest_path(space, p, written::middle({c, p})));
    }
  }
}

/// Sloped walls between points of a small lattice, ends on walls, corners and crossings included.
struct LatticeWorld {
  int width, height, places = 0;
  std::vector<std::array<int, 4>> walls;
  int start[2], goal[2];

  LatticeWorld(Draw& draw, int digits) : width(draw.between(4, 9)), height(draw.between(3, 9)), places(digits) {
    for (int n = draw.between(2, 7); n > 0; --n) {
      const std::array<int, 4> w{draw.upto(width), draw.upto(height), draw.upto(width), draw.upto(height)};
      if (w[0] != w[2] || w[1] != w[3]) walls.push_back(w);
    }
    for (auto* end : {start, goal}) {
      end[0] = draw.upto(width);
      end[1] = draw.upto(height);
    }
  }

  World world() const {
    SmallWorld result{
        .area = {place(0, 0, places), place(width, 0, places), place(width, height, places), place(0, height, places)}};
    for (const auto& w : walls) result.walls.push_back({place(w[0], w[1], places), place(w[2], w[3], places)});
    return World(result.parts()).with_ends(place(start[0], start[1], places), place(goal[0], goal[1], places));
  }

  std::optional<double> length() const {
    std::vector<test::RationalWall> exact;
    for (const auto& w : walls) exact.push_back({{w[0], w[1]}, {w[2], w[3]}});
    return test::arrangement_path(width, height, exact, {start[0], start[1]}, {goal[0], goal[1]});
  }

  std::string text() const {
    std::string s = "boundary 0 0 " + std::to_string(width) + " " + std::to_string(height) + "\nstart " +
                    std::to_string(start[0]) + " " + std::to_string(start[1]) + "\ngoal " + std::to_string(goal[0]) +
                    " " + std::to_string(goal[1]) + "\n";
    for (const auto& w : walls) {
      for (const int c : w) s += std::to_string(c) + " ";
      s += "\n";
    }
    return s;
  }
};

TEST(DecimalWorld, HasTheShortestPathsOfTheExactArrangement) {
  Draw draw(4);
  for (int k = 0; k < worlds(300); ++k) {
    const LatticeWorld drawn(draw, k % 3);
    const World world = drawn.world();
    const FreeSpace space(world);
    const auto path = shortest_path(space, *world.start(), *world.goal().point);
    const auto exact = drawn.length();
    ASSERT_EQ(path.has_value(), exact.has_value()) << k << ", places " << drawn.places << "\n" << drawn.text();
    if (!path) continue;
    ASSERT_NEAR(path->length.value() * std::pow(10, drawn.places), *exact, 1e-9 * (1 + *exact))
        << k << ", places " << drawn.places << "\n"
        << drawn.text();
    ASSERT_TRUE(verify(*path, space, *world.start(), world.goal()).valid) << drawn.text();
  }
}

TEST(DecimalWorld, LetsADiscThroughAGapThatIsExactlyAsWide) {
  Draw draw(5);
  for (int k = 0; k < worlds(100); ++k) {
    const int size = draw.between(1, 30);  // of the gap: 3, 4, 5 hundredths each
    const int x = draw.between(100, 700), y = draw.between(300, 500);
    const Point a = place(x, y, 2), b = place(x + 3 * size, y + 4 * size, 2);
    const SmallWorld walls{.walls = {{{0, a.y}, a}, {b, {10, b.y}}}};
    const FreeSpace space = walls.space();
    const Point below = place(x, y - 250, 2), above = place(x + 3 * size, y + 4 * size + 250, 2);
    const double r = written::number(25 * size, 3), more = written::number(25 * size + 1, 3);
    EXPECT_EQ(disc_passage(space, below, above, r).status, DiscStatus::found) << k;
    EXPECT_EQ(disc_passage(space, below, above, more).status, DiscStatus::none) << k;
    EXPECT_EQ(widest_passage(space, below, above).value().radius, r);
    EXPECT_EQ(arc_search(TangentGraph(space, r), below, above).status, DiscStatus::found) << k;
    EXPECT_EQ(arc_search(TangentGraph(space, more), below, above).status, DiscStatus::none) << k;
  }
}

TEST(DecimalWorld, HasWallsAsThickAsTheyAreWritten) {
  Draw draw(6);
  for (int k = 0; k < worlds(100); ++k) {
    // Two thick walls whose faces touch: nothing gets between them. A hundredth apart it does.
    const int y = draw.between(100, 800), t = draw.between(1, 40);
    for (const int gap : {0, 1}) {
      const double above = written::number(y + t + gap, 2);
      const SmallWorld walls{
          .walls = {{{0, written::number(y, 2)}, {7, written::number(y, 2)}}, {{0, above}, {7, above}}},
          .thickness = written::number(t, 2)};
      const Point middle{3, written::middle(written::number(y, 2), above)};
      EXPECT_EQ(walls.space().locate(middle).kind != Location::Kind::outside, gap == 1) << k;
    }
  }
}

}  // namespace
}  // namespace taut
