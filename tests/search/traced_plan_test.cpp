// Plans that were traced by hand: what should touch ends a little beside.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <string>

#include <support/turned.h>
#include <taut/geometry/snap.h>
#include <taut/geometry/written.h>
#include <taut/search/shortest_path.h>

namespace taut {
namespace {

using test::Turn;
using test::turns;

constexpr int kAcross = 5, kUp = 4;  // rooms of 4 x 4 metres
constexpr double kRoom = 4;

class Draw {
 public:
  explicit Draw(unsigned seed) : engine_(seed) {}
  double upto_one() { return static_cast<double>(engine_()) / 4294967296.0; }
  bool one_in(unsigned n) { return engine_() % n == 0; }

 private:
  std::mt19937 engine_;
};

/// Rooms in rows, some joined by doors in the middle of a wall; every wall by itself, from corner to corner or from
/// wall to wall.
std::vector<Wall> plan(Draw& draw) {
  std::vector<Wall> walls;
  const auto add = [&](Point a, Point b, bool inner) {
    if (!inner || !draw.one_in(2)) return walls.push_back({a, b});
    const Point u{(b.x - a.x) / kRoom, (b.y - a.y) / kRoom};
    const double door = 0.5 + 2 * draw.upto_one();
    walls.push_back({a, {a.x + door * u.x, a.y + door * u.y}});
    walls.push_back({{a.x + (door + 1) * u.x, a.y + (door + 1) * u.y}, b});
  };
  for (int y = 0; y <= kUp; ++y) {
    if (y % 2 == 0 && y % kUp != 0) continue;  // one long wall, on which others end
    for (int x = 0; x < kAcross; ++x) add({kRoom * x, kRoom * y}, {kRoom * (x + 1), kRoom * y}, y % kUp != 0);
  }
  for (int y = 2; y < kUp; y += 2) walls.push_back({{0, kRoom * y}, {kRoom * kAcross, kRoom * y}});
  for (int x = 0; x <= kAcross; ++x)
    for (int y = 0; y < kUp; ++y) add({kRoom * x, kRoom * y}, {kRoom * x, kRoom * (y + 1)}, x % kAcross != 0);
  return walls;
}

/// Every end up to half a crack beside its place, to a thousandth of that.
std::vector<Wall> traced(std::vector<Wall> walls, double crack, Draw& draw) {
  const int places = static_cast<int>(std::ceil(-std::log10(crack))) + 3;
  const auto shifted = [&](Point p) {
    const double angle = 2 * std::numbers::pi * draw.upto_one(), far = crack / 2 * draw.upto_one();
    const auto rounded = [&](double v) { return written::number(std::llround(v * std::pow(10, places)), places); };
    return Point{rounded(p.x + far * std::cos(angle)), rounded(p.y + far * std::sin(angle))};
  };
  for (Wall& wall : walls) wall = {shifted(wall.a), shifted(wall.b)};
  return walls;
}

std::optional<double> length(const FreeSpace& space, Point from, Point to) {
  const auto path = shortest_path(space, from, to);
  return path ? std::optional(path->length.value()) : std::nullopt;
}

Point middle(int room) { return {kRoom * (room % kAcross) + 2.1, kRoom * (room / kAcross) + 1.9}; }

void expect_same_rooms(const FreeSpace& right, const FreeSpace& space, const Turn& turn, double crack) {
  for (int room = 1; room < kAcross * kUp; ++room) {
    const auto wanted = length(right, middle(0), middle(room)),
               found = length(space, turn(middle(0)), turn(middle(room)));
    ASSERT_EQ(found.has_value(), wanted.has_value()) << "room " << room;
    if (!wanted) continue;
    EXPECT_NEAR(*found, *wanted, 100 * crack) << "room " << room;
  }
}

TEST(TracedPlan, LetsNothingSlipThroughItsCracksWhenTheyAreJoined) {
  int leaks = 0;
  for (int seed = 0; seed < turns(20); ++seed) {
    Draw draw(static_cast<unsigned>(seed));
    WorldParts flat;
    flat.walls = plan(draw);
    const FreeSpace right{World(flat)};
    const double crack = std::pow(10, -5 + 2 * draw.upto_one());  // 0.01 mm to 1 mm
    SCOPED_TRACE("plan " + std::to_string(seed) + ", cracks up to " + std::to_string(crack));
    // As traced, and turned, so that its numbers are computed.
    for (const Turn& turn : {Turn(0), Turn(10 + seed)}) {
      WorldParts parts;
      parts.walls = traced(flat.walls, crack, draw);
      parts = turn(parts);
      const Snapped joined = snapped(World(parts), Snap{Snap::What::automatic});
      EXPECT_LE(joined.report.displacement, joined.report.tolerance);
      EXPECT_LE(joined.report.tolerance, 1.01 * crack);
      EXPECT_TRUE(joined.report.remaining.empty());
      expect_same_rooms(right, FreeSpace(joined.world), turn, crack);
      const FreeSpace open(snapped(World(parts), 0).world);
      for (int room = 1; room < kAcross * kUp; ++room)
        leaks += length(open, turn(middle(0)), turn(middle(room))) && !length(right, middle(0), middle(room));
    }
  }
  EXPECT_GT(leaks, 0) << "no plan leaks as it is: nothing was tested";
}

}  // namespace
}  // namespace taut
