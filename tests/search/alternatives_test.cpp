#include <taut/search/alternatives.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <memory>
#include <set>

#include <taut/geometry/maze_generator.h>
#include <taut/geometry/written.h>
#include <taut/search/corridor.h>
#include <taut/search/funnel.h>
#include <taut/search/passage_index.h>
#include <taut/search/shortest_path.h>
#include <taut/search/verify.h>

#include "support/random_world.h"
#include "support/small_world.h"

namespace taut {
namespace {

using test::SmallWorld;

Gates room(const std::vector<Segment>& walls) {
  return Gates(FreeSpace(SmallWorld{.walls = walls, .solids = {}}.bounded(Boundary::walled)));
}

//   +--------------+
//   |      g       |    a bar: past its left end, 4 wide, or past its right end, 3 wide
//   |    ------    |
//   |       s      |
//   +--------------+
TEST(Alternatives, PassABarOnBothSides) {
  const Alternatives found = alternatives(room({{{4, 5}, {7, 5}}}), {6, 4}, {6, 6}, {.count = 5});
  EXPECT_EQ(found.status, SearchStatus::found);
  EXPECT_TRUE(found.all);
  ASSERT_EQ(found.ways.size(), 2U);
  EXPECT_EQ(found.ways[0].path.points, (std::vector<Point>{{6, 4}, {7, 5}, {6, 6}}));
  EXPECT_EQ(found.ways[1].path.points, (std::vector<Point>{{6, 4}, {4, 5}, {6, 6}}));
  ASSERT_TRUE(found.ways[0].gate && found.ways[1].gate);
  EXPECT_EQ(found.ways[0].gate->name, "3 between (7, 5) and (10, 5)");
  EXPECT_EQ(found.ways[1].gate->name, "4 between (0, 5) and (4, 5)");
}

TEST(Alternatives, OfEqualLengthAreInTheOrderOfTheirPoints) {
  const Alternatives found = alternatives(room({{{4, 5}, {6, 5}}}), {5, 4}, {5, 6}, {.count = 2});
  ASSERT_EQ(found.ways.size(), 2U);
  EXPECT_EQ(found.ways[0].path.length, found.ways[1].path.length);
  EXPECT_LT(found.ways[0].path.points, found.ways[1].path.points);
  EXPECT_EQ(alternatives(room({{{4, 5}, {6, 5}}}), {5, 4}, {5, 6}, {.count = 1}).ways[0].path.points,
            found.ways[0].path.points);
}

TEST(Alternatives, AreNoneWhereAWallSeparates) {
  const Alternatives found = alternatives(room({{{0, 5}, {10, 5}}}), {5, 4}, {5, 6});
  EXPECT_EQ(found.status, SearchStatus::none);
  EXPECT_TRUE(found.ways.empty());
}

TEST(Alternatives, BetweenOnePlaceAndItselfAreOne) {
  const Alternatives found = alternatives(room({{{4, 5}, {6, 5}}}), {5, 4}, {5, 4}, {.count = 3});
  ASSERT_EQ(found.ways.size(), 1U);
  EXPECT_EQ(found.ways[0].path.length, Length());
}

TEST(Alternatives, StopAtTheLimitWithWhatIsSure) {
  const Alternatives found = alternatives(room({{{4, 5}, {7, 5}}}), {6, 4}, {6, 6}, {.count = 2, .most_expanded = 3});
  EXPECT_EQ(found.status, SearchStatus::stopped);
  EXPECT_LT(found.ways.size(), 2U);
}

TEST(Alternatives, RunAlongAWallOnTheSideThatTheyTurnTo) {
  // Left at one end of a wall and right at its other is taut on neither side of it.
  const Gates gates = room({{{3, 5}, {7, 5}}});
  const Alternatives found = alternatives(gates, {1, 3}, {9, 7}, {.count = 10});
  EXPECT_TRUE(found.all);
  EXPECT_EQ(found.ways.size(), 2U);
}

/// No corner on another leg, no crossing of two legs.
bool is_simple(const std::vector<Point>& points) {
  for (std::size_t i = 1; i + 1 < points.size(); ++i)
    for (std::size_t j = 1; j < points.size(); ++j)
      if (j != i && j != i + 1 && written::on_segment(points[i], points[j - 1], points[j])) return false;
  const auto side = [](Point a, Point b, Point c) { return written::orientation(a, b, c); };
  for (std::size_t i = 1; i < points.size(); ++i)
    for (std::size_t j = i + 1; j < points.size(); ++j) {
      const Point a = points[i - 1], b = points[i], c = points[j - 1], d = points[j];
      if (side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0) return false;
    }
  return true;
}

/// The second opinion: every walk of triangles from the one to the other that passes none more than thrice and never
/// turns back, pulled taut.
class Sleeves {
 public:
  Sleeves(const FreeSpace& space, Point s, Point g) : tri_(space.triangulation()), s_(s), g_(g) {
    times_.assign(tri_.triangles.size(), 0);
    first_ = space.locate(s).triangle;
    last_ = space.locate(g).triangle;
  }

  /// False when there are too many.
  bool walk() {
    on(first_);
    return steps_ < kMost;
  }
  const std::map<std::vector<Point>, Length>& strings() const { return strings_; }

 private:
  static constexpr std::size_t kMost = 40'000;

  void on(std::uint32_t t) {
    if (++steps_ >= kMost || times_[t] == 3) return;
    ++times_[t];
    walk_.push_back(t);
    if (t == last_) {
      const Path path = funnel(tri_, {s_, g_, walk_});
      if (is_simple(path.points)) strings_.emplace(path.points, path.length);
    }
    for (int i = 0; i < 3; ++i) {
      if (tri_.is_constrained(t, i)) continue;
      const std::uint32_t next = tri_.neighbours[t][i];
      if (walk_.size() < 2 || walk_[walk_.size() - 2] != next) on(next);
    }
    walk_.pop_back();
    --times_[t];
  }

  const Triangulation& tri_;
  Point s_, g_;
  std::uint32_t first_, last_;
  std::vector<std::uint32_t> walk_;
  std::vector<int> times_;
  std::size_t steps_ = 0;
  std::map<std::vector<Point>, Length> strings_;
};

RC_GTEST_PROP(Alternatives, AreTheStringsOfAllSleeves, ()) {
  const SmallWorld small = test::any_world({.side = 5, .walls = 3, .solids = 1, .straight = test::any(0, 1) == 1});
  const FreeSpace space(small.bounded(Boundary::walled));
  const Point s = test::any_fine_point(5), g = test::any_fine_point(5);
  if (s == g || space.locate(s).kind != Location::Kind::triangle || space.locate(g).kind != Location::Kind::triangle)
    return;
  RC_LOG(test::show(small) + fmt::format(" s {} g {}\n", test::show(s), test::show(g)));
  Sleeves sleeves(space, s, g);
  if (!sleeves.walk()) return;
  const Alternatives found = alternatives(Gates(space), s, g, {.count = 100});
  RC_ASSERT(found.all);
  std::set<std::vector<Point>> ours, theirs;
  for (const Alternative& way : found.ways) ours.insert(way.path.points);
  for (const auto& [points, length] : sleeves.strings()) theirs.insert(points);
  const auto log_missing = [](const auto& some, const auto& others, const char* whose) {
    for (const auto& points : some) {
      std::string text = whose;
      for (const Point p : points) text += test::show(p);
      if (!others.contains(points)) RC_LOG(text + "\n");
    }
  };
  log_missing(ours, theirs, "only ours ");
  log_missing(theirs, ours, "only theirs ");
  RC_ASSERT(ours == theirs);
}

RC_GTEST_PROP(Alternatives, AreValidSortedAndAmongThemIsTheShortestAndTheWidest, ()) {
  const SmallWorld small = test::any_world({.side = 6, .walls = 5, .solids = 2});
  const FreeSpace space(small.bounded(Boundary::walled));
  const Point s = test::any_fine_point(6), g = test::any_fine_point(6);
  RC_LOG(test::show(small) + fmt::format(" s {} g {}\n", test::show(s), test::show(g)));
  if (!space.holds(s) || !space.holds(g)) return;
  const PassageIndex index(space);
  const Alternatives found = alternatives(index.gates(), s, g, {.count = 200, .most_expanded = 200'000});
  const auto shortest = shortest_path(space, s, g);
  RC_ASSERT(found.ways.empty() == !shortest.has_value());
  if (!shortest) return;
  RC_ASSERT(found.ways[0].path.length == shortest->length);
  for (std::size_t i = 0; i < found.ways.size(); ++i) {
    const Path& path = found.ways[i].path;
    RC_ASSERT(verify(path, space, s, Goal{g, {}}).valid);
    RC_ASSERT(shortened(space, path)->length == path.length);
    if (i > 0) RC_ASSERT(found.ways[i - 1].path.length <= path.length);
  }
  if (!found.all) return;
  double widest = 0;
  for (const Alternative& way : found.ways)
    widest = std::max(widest, way.gate ? way.gate->width : std::numeric_limits<double>::infinity());
  if (index.place(s).on_wall || index.place(g).on_wall) return;
  // An end on a gate is on either side of it.
  for (const Gate& gate : index.gates().gates())
    if (written::orientation(gate.end, gate.foot, s) == 0 || written::orientation(gate.end, gate.foot, g) == 0) return;
  const std::uint32_t gate = index.bottleneck(index.place(s), index.place(g));
  RC_ASSERT(widest == (gate == kNone ? std::numeric_limits<double>::infinity() : index.gates().gates()[gate].width));
}

TEST(WiderWays, AreThoseThatNoShorterOneIsAsWideAs) {
  // Past the bar's right end 3 wide, past its left end 4 wide.
  const Gates gates = room({{{4, 5}, {7, 5}}});
  const std::vector<Alternative> ways = wider_ways(gates, {6, 4}, {6, 6});
  ASSERT_EQ(ways.size(), 2U);
  EXPECT_EQ(ways[0].gate->width, 3);
  EXPECT_EQ(ways[1].gate->width, 4);
  // From the left the wider one is the shorter one.
  EXPECT_EQ(wider_ways(gates, {5, 4}, {5, 6}).size(), 1U);
  // Ends beside a wall change nothing.
  EXPECT_EQ(wider_ways(gates, {6, 0.015625}, {6, 10}).size(), 2U);
}

RC_GTEST_PROP(WiderWays, AreAmongAllAlternativesThoseThatNoShorterOneIsAsWideAs, ()) {
  const SmallWorld small = test::any_world({.side = 6, .walls = 5, .solids = 2, .straight = test::any(0, 1) == 1});
  const FreeSpace space(small.bounded(Boundary::walled));
  const Point s = test::any_fine_point(6), g = test::any_fine_point(6);
  RC_LOG(test::show(small) + fmt::format(" s {} g {}\n", test::show(s), test::show(g)));
  if (space.locate(s).kind != Location::Kind::triangle || space.locate(g).kind != Location::Kind::triangle) return;
  const Gates gates(space);
  for (const Gate& gate : gates.gates())
    if (written::orientation(gate.end, gate.foot, s) == 0 || written::orientation(gate.end, gate.foot, g) == 0) return;
  const Alternatives all = alternatives(gates, s, g, {.count = 200, .most_expanded = 200'000});
  if (!all.all) return;
  std::vector<const Alternative*> front;
  const auto width = [](const Alternative& way) {
    return way.gate ? way.gate->width : std::numeric_limits<double>::infinity();
  };
  for (const Alternative& way : all.ways) {
    if (!front.empty() && width(way) <= width(*front.back())) continue;
    if (!front.empty() && way.path.length == front.back()->path.length) front.pop_back();
    front.push_back(&way);
  }
  const std::vector<Alternative> ways = wider_ways(gates, s, g);
  RC_ASSERT(ways.size() == front.size());
  for (std::size_t i = 0; i < ways.size(); ++i) {
    RC_ASSERT(ways[i].path.length == front[i]->path.length);
    RC_ASSERT(width(ways[i]) == width(*front[i]));
  }
}

TEST(Alternatives, AreFoundInAMazeWithLoops) {
  auto maze = std::make_shared<GridMaze>(generate_backtracker(21, 21, 3));
  open_walls(*maze, 0.2, 3);
  const FreeSpace space(world_of(maze));
  const Alternatives found = alternatives(Gates(space), {0.5, 0.5}, {20.5, 20.5}, {.count = 20});
  ASSERT_EQ(found.ways.size(), 20U);
  EXPECT_EQ(found.ways[0].path.length, shortest_path(space, {0.5, 0.5}, {20.5, 20.5})->length);
}

TEST(Alternatives, EndWhereAMazeHasNoLoops) {
  // Strings that turn back along a wall once kept the search for half a minute here.
  const FreeSpace space(world_of(std::make_shared<GridMaze>(generate_backtracker(25, 25, 3))));
  const Alternatives found = alternatives(Gates(space), {0.5, 0.5}, {24.5, 24.5}, {.most_expanded = 20'000});
  EXPECT_EQ(found.status, SearchStatus::found);
  EXPECT_EQ(found.ways.size(), 1U);
  EXPECT_TRUE(found.all);
}

}  // namespace
}  // namespace taut
