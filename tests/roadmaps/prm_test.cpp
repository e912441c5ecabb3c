#include <taut/geometry/exact/exact_point.h>
#include <taut/roadmaps/prm.h>

#include <taut/geometry/exact/numbers.h>

#include <algorithm>
#include <cmath>
#include <set>

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <taut/geometry/maze_generator.h>
#include <taut/search/verify.h>

#include "support/random_world.h"

namespace taut {
namespace {

using test::any;
using test::any_world;
using test::box_ring;
using test::SmallWorld;

using Rule = PrmConnection::Rule;

constexpr PrmSampler kSamplers[] = {PrmSampler::uniform, PrmSampler::lattice, PrmSampler::gaussian, PrmSampler::bridge,
                                    PrmSampler::medial,  PrmSampler::corners, PrmSampler::sobol};

PrmOptions lattice(double spacing, double clearance = 0) {
  PrmOptions options;
  options.sampler = PrmSampler::lattice;
  options.lattice = PrmLattice{{0, 0}, spacing};
  options.clearance = clearance;
  return options;
}

PrmOptions any_options() {
  PrmOptions options;
  options.sampler = kSamplers[any(0, 6)];
  options.samples = 40;
  options.seed = static_cast<std::uint64_t>(any(0, 1000));
  options.clearance = any(0, 1) * any(0, 4) / 8.0;
  options.connection.rule = Rule(any(0, 4));
  options.connection.count = static_cast<std::size_t>(any(1, 8));
  options.lattice = PrmLattice{{0.25, 0.5}, any(1, 4) / 4.0};
  return options;
}

bool joins(const Roadmap& graph, Point p, Point q) {
  for (Roadmap::Vertex v = 0; v < graph.vertex_count(); ++v)
    for (const auto w : graph.neighbours(v))
      if (graph.point(v) == p && graph.point(w) == q) return true;
  return false;
}

/// The squared distance of p and the segment a b, as a fraction.
Rational squared_distance(Point p, Point a, Point b) {
  const ExactPoint at(p), from(a), to(b);
  const Rational ux = to.x - from.x, uy = to.y - from.y;
  const Rational length = ux * ux + uy * uy;
  Rational t = length == 0 ? Rational(0) : Rational(((at.x - from.x) * ux + (at.y - from.y) * uy) / length);
  t = t < 0 ? Rational(0) : t > 1 ? Rational(1) : t;
  const Rational dx = from.x + t * ux - at.x, dy = from.y + t * uy - at.y;
  return dx * dx + dy * dy;
}

/// Of segments that do not cross.
Rational squared_distance(const Segment& s, const Constraint& c) {
  return std::min({squared_distance(s.a, c.a, c.b), squared_distance(s.b, c.a, c.b), squared_distance(c.a, s.a, s.b),
                   squared_distance(c.b, s.a, s.b)});
}

Verdict check_leg(const FreeSpace& space, Point p, Point q) {
  return verify(Path{{p, q}, Length(std::vector{p, q})}, space, p, Goal{q, {}});
}

RC_GTEST_PROP(Prm, HasOnlyEdgesThatTheCheckAcceptsAndThatKeepTheClearance, ()) {
  const SmallWorld world = any_world();
  RC_LOG() << test::show(world) << '\n';
  const FreeSpace space = world.space();
  const PrmOptions options = any_options();
  const Roadmap graph = prm(space, options);
  const Rational least = meaning(options.clearance) * meaning(options.clearance);
  for (Roadmap::Vertex v = 0; v < graph.vertex_count(); ++v) {
    const Point p = graph.point(v);
    for (const Constraint& c : space.constraints()) {
      const Rational squared = squared_distance(Segment{p, p}, c);
      RC_ASSERT(squared > 0 && squared >= least);
    }
    for (const auto w : graph.neighbours(v)) {
      const Segment leg{p, graph.point(w)};
      RC_ASSERT(check_leg(space, leg.a, leg.b).valid);
      if (v > w || least == 0) continue;
      for (const Constraint& c : space.constraints()) RC_ASSERT(squared_distance(leg, c) >= least);
    }
  }
}

RC_GTEST_PROP(Prm, IsTheSameForTheSameSeed, ()) {
  const FreeSpace space = any_world().space();
  const PrmOptions options = any_options();
  RC_ASSERT(prm(space, options) == prm(space, options));
}

/// All pairs that the rule names, found by sorting all vertices; equally far ones by index.
std::set<std::pair<Roadmap::Vertex, Roadmap::Vertex>> named_pairs(const std::vector<Point>& points,
                                                                  const PrmConnection& connection) {
  std::set<std::pair<Roadmap::Vertex, Roadmap::Vertex>> pairs;
  const double n = std::max(2.0, static_cast<double>(points.size()));
  const std::size_t count = connection.rule == Rule::star
                                ? static_cast<std::size_t>(std::ceil(std::exp(1.0) * 1.5 * std::log(n)))
                                : connection.count;
  for (Roadmap::Vertex v = 0; v < points.size(); ++v) {
    std::vector<std::pair<double, Roadmap::Vertex>> others;
    for (Roadmap::Vertex w = 0; w < points.size(); ++w) {
      const double dx = points[v].x - points[w].x, dy = points[v].y - points[w].y;
      if (v != w) others.emplace_back(dx * dx + dy * dy, w);
    }
    std::sort(others.begin(), others.end());
    const double reach = connection.radius * connection.radius;
    for (std::size_t i = 0; i < others.size(); ++i)
      if (connection.rule == Rule::radius ? others[i].first <= reach : i < count)
        pairs.emplace(std::min(v, others[i].second), std::max(v, others[i].second));
  }
  return pairs;
}

RC_GTEST_PROP(Prm, JoinsTheNeighboursThatItsRuleNamesAndNoOthers, ()) {
  const FreeSpace space = any_world().space();
  PrmOptions options = any_options();
  options.clearance = 0;
  options.connection.rule = std::vector{Rule::nearest, Rule::radius, Rule::star}[static_cast<std::size_t>(any(0, 2))];
  const Roadmap graph = prm(space, options);
  const auto pairs = named_pairs(graph.points(), options.connection);
  std::size_t edges = 0;
  for (const auto& [v, w] : pairs) {
    const bool is_free = check_leg(space, graph.point(v), graph.point(w)).valid;
    RC_ASSERT(graph.adjacent(v, w) == is_free);
    edges += is_free;
  }
  RC_ASSERT(graph.edge_count() == edges);
}

TEST(Prm, DrawsTheSamePointsOnEveryPlatform) {
  const FreeSpace space = SmallWorld{.walls = {{{5, 0}, {5, 6}}}, .solids = {}}.space();
  const auto last = [&](PrmSampler sampler) {
    return prm(space, {.sampler = sampler, .samples = 100, .seed = 7}).points().back();
  };
  EXPECT_EQ(last(PrmSampler::uniform), (Point{7.905708940563879, 0.09820952776255498}));
  EXPECT_EQ(last(PrmSampler::gaussian), (Point{3.7857529060823825, 9.510271598499019}));
  EXPECT_EQ(last(PrmSampler::bridge), (Point{2.154512440608347, 0.8793020757947156}));
  EXPECT_EQ(last(PrmSampler::medial), (Point{7.905708940563879, 2.0942909057723664}));
  EXPECT_EQ(last(PrmSampler::corners), (Point{6.899753348169542, 3.8868820468321}));
  EXPECT_EQ(last(PrmSampler::sobol), (Point{0.27822803822346032, 8.3211370266508311}));
}

TEST(Prm, DrawsOtherPointsForAnotherSeed) {
  const FreeSpace space = SmallWorld{.walls = {}, .solids = {}}.space();
  EXPECT_FALSE(prm(space, {.seed = 1}) == prm(space, {.seed = 2}));
  const PrmOptions spread{.sampler = PrmSampler::sobol, .samples = 8};
  PrmOptions other = spread;
  other.seed = 2;
  EXPECT_FALSE(prm(space, spread) == prm(space, other));
}

TEST(Prm, KeepsVerticesExactlyAsFarAwayAsTheClearance) {
  const FreeSpace space = SmallWorld{.walls = {}, .solids = {}}.space();
  EXPECT_EQ(prm(space, lattice(1)).vertex_count(), 81u) << "those on the outline touch it";
  EXPECT_EQ(prm(space, lattice(1, 1)).vertex_count(), 81u);
  EXPECT_EQ(prm(space, lattice(1, std::nextafter(1.0, 2.0))).vertex_count(), 49u);
}

TEST(Prm, KeepsEdgesExactlyAsFarAwayAsTheClearance) {
  // The wall's free end is 1 from the leg that passes over it.
  const FreeSpace space = SmallWorld{.walls = {{{4, 0}, {4, 3}}}, .solids = {}}.space();
  PrmOptions options = lattice(4, 1);
  options.lattice->origin = {2, 0};
  EXPECT_TRUE(joins(prm(space, options), {2, 4}, {6, 4}));
  options.clearance = std::nextafter(1.0, 2.0);
  EXPECT_FALSE(joins(prm(space, options), {2, 4}, {6, 4}));
}

TEST(Prm, RefusesEdgesThroughTheInsideOfAWallAndThroughAJoint) {
  const auto is_joined = [](std::vector<Segment> walls, double clearance) {
    PrmOptions options = lattice(2, clearance);
    return joins(prm(SmallWorld{.walls = std::move(walls), .solids = {}}.space(), options), {4, 4}, {6, 4});
  };
  EXPECT_TRUE(is_joined({}, 0));
  EXPECT_TRUE(is_joined({{{5, 0}, {5, 4}}}, 0)) << "it touches a free end";
  EXPECT_FALSE(is_joined({{{5, 0}, {5, 4}}}, 1e-300)) << "touching is no clearance at all";
  EXPECT_FALSE(is_joined({{{5, 0}, {5, 6}}}, 0)) << "through a wall";
  EXPECT_FALSE(is_joined({{{5, 0}, {5, 4}}, {{5, 4}, {5, 10}}}, 0)) << "through a joint";
  EXPECT_FALSE(is_joined({{{5, 0}, {5, 4}}, {{5, 4}, {3, 10}}}, 0)) << "through a crooked joint";
}

RC_GTEST_PROP(Prm, IsAForestThatJoinsWhatItsNeighboursCouldJoin, ()) {
  const FreeSpace space = any_world().space();
  PrmOptions options = any_options();
  options.connection.rule = Rule::forest;
  PrmCounts forest, nearest;
  prm(space, options, &forest);
  options.connection.rule = Rule::nearest;
  options.connection.count *= 4;
  prm(space, options, &nearest);
  RC_ASSERT(forest.edges + forest.components == forest.kept);
  RC_ASSERT(forest.components == nearest.components);
  RC_ASSERT(forest.edges_tested <= 2 * nearest.edges_tested);
}

TEST(Prm, RefusesEdgesThatGrazeAWallAndPassAJoint) {
  // Each of these legs runs along a wall first: that is allowed. Where another wall leaves from it on the side it
  // needs, it is not.
  const auto is_joined = [](std::vector<Segment> walls) {
    PrmOptions options = lattice(2);
    options.connection = {.rule = Rule::radius, .radius = 8};
    return joins(prm(SmallWorld{.walls = std::move(walls), .solids = {}}.space(), options), {2, 4}, {8, 4});
  };
  const Segment along{{4.5, 4}, {5.5, 4}};
  EXPECT_TRUE(is_joined({along})) << "along a wall";
  EXPECT_TRUE(is_joined({along, {{5, 4}, {5, 8}}})) << "below it there is room";
  EXPECT_FALSE(is_joined({along, {{5, 4}, {5, 8}}, {{5.25, 4}, {5.25, 0}}})) << "a wall on either side";
  EXPECT_FALSE(is_joined({{{5, 0}, {5, 4}}, {{5, 4}, {5.5, 4}}, {{5.5, 4}, {5.5, 8}}})) << "through two joints";
  EXPECT_FALSE(is_joined({{{5, 3.999}, {5, 8}}})) << "through the inside of a wall, just beside its end";
}

TEST(Prm, CountsWhatItDid) {
  const FreeSpace space = SmallWorld{.walls = {{{5, 0}, {5, 10}}}, .solids = {}}.space();
  PrmCounts counts;
  const Roadmap graph = prm(space, lattice(1), &counts);
  EXPECT_EQ(counts.drawn, 121u);
  EXPECT_EQ(counts.kept, 72u);
  EXPECT_EQ(counts.kept, graph.vertex_count());
  EXPECT_EQ(counts.edges, graph.edge_count());
  EXPECT_EQ(counts.components, 2u);
  EXPECT_GT(counts.edges_tested, counts.edges);
}

TEST(Prm, PutsTheLatticeOnTheCellCentresOfAGrid) {
  const World maze = world_of(std::make_shared<GridMaze>(generate_biased_maze(5, 7, 1)));
  const Roadmap graph = prm(FreeSpace(maze), {.sampler = PrmSampler::lattice, .clearance = 0.5});
  EXPECT_EQ(graph.vertex_count(), 35u);
  EXPECT_EQ(graph.point(0), (Point{0.5, 0.5}));
  EXPECT_GE(graph.edge_count(), 34u) << "a perfect maze hangs together, with straight legs only";
}

TEST(Prm, RefusesALatticeThatIsTooFine) {
  const FreeSpace space = SmallWorld{.walls = {}, .solids = {}}.space();
  EXPECT_THROW(prm(space, lattice(1e-5)), InputError);
}

double distance_to_outline(Point p, double side) { return std::min({p.x, p.y, side - p.x, side - p.y}); }

TEST(Prm, SamplesTheMedialAxis) {
  const FreeSpace space = SmallWorld{.walls = {}, .solids = {}}.space();
  const Roadmap graph = prm(space, {.sampler = PrmSampler::medial, .samples = 200});
  EXPECT_EQ(graph.vertex_count(), 200u);
  for (const Point p : graph.points()) {
    EXPECT_NEAR(std::min(p.x, 10 - p.x), std::min(p.y, 10 - p.y), 1e-4);
  }
}

TEST(Prm, FindsNarrowPassagesWithTheBridgeTest) {
  const FreeSpace space = SmallWorld{.walls = {}, .solids = {box_ring(2, 0, 8, 4.8), box_ring(2, 5.2, 8, 10)}}.space();
  const auto share_inside = [&](PrmSampler sampler) {
    const Roadmap graph = prm(space, {.sampler = sampler, .samples = 4000, .spread = 0.5});
    const auto& points = graph.points();
    const auto inside = std::count_if(points.begin(), points.end(), [](Point p) { return 2 < p.x && p.x < 8; });
    return static_cast<double>(inside) / static_cast<double>(points.size());
  };
  EXPECT_GT(share_inside(PrmSampler::bridge), 3 * share_inside(PrmSampler::uniform));
}

TEST(Prm, DrawsGaussianSamplesNearObstaclesAndCornersNearBends) {
  const FreeSpace space = SmallWorld{.walls = {{{5, 0}, {5, 5}}}, .solids = {}}.space();
  const auto mean = [&](PrmSampler sampler, auto distance) {
    const Roadmap graph = prm(space, {.sampler = sampler, .samples = 2000, .spread = 0.5});
    double sum = 0;
    for (const Point p : graph.points()) sum += distance(p);
    return sum / static_cast<double>(graph.vertex_count());
  };
  const auto to_outline = [](Point p) { return std::min(distance_to_outline(p, 10), std::abs(p.x - 5)); };
  const auto to_bend = [](Point p) { return std::hypot(p.x - 5, p.y - 5); };
  EXPECT_LT(mean(PrmSampler::gaussian, to_outline), 0.7 * mean(PrmSampler::uniform, to_outline));
  EXPECT_LT(mean(PrmSampler::corners, to_bend), 0.7 * mean(PrmSampler::uniform, to_bend));
}

TEST(Prm, JoinsAnEndToTheNearestVerticesItSees) {
  const FreeSpace space = SmallWorld{.walls = {{{5, 0}, {5, 9}}}, .solids = {}}.space();
  const Roadmap graph = prm(space, lattice(2));
  std::vector<Point> joined;
  for (const auto v : nearest_visible(space, graph, {4.75, 4}, 3)) joined.push_back(graph.point(v));
  EXPECT_EQ(joined, (std::vector<Point>{{4, 4}, {4, 2}, {4, 6}})) << "not (6, 4), behind the wall";
}

}  // namespace
}  // namespace taut
