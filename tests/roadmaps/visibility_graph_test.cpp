#include <taut/roadmaps/visibility_graph.h>

#include <algorithm>
#include <string>

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <taut/geometry/written.h>

#include "support/constraint_walk.h"
#include "support/random_world.h"

namespace taut {
namespace {

using test::any;
using test::any_world;
using test::box_ring;
using test::RandomWorld;
using test::SmallWorld;

std::string difference(const Roadmap& graph, const Roadmap& reference) {
  if (graph.points() != reference.points()) return "the vertices differ";
  std::string text;
  const auto edge = [&](const char* what, Roadmap::Vertex u, Roadmap::Vertex v) {
    text += std::string(what) + std::to_string(u) + " " + test::show(graph.point(u)) + " -- " + std::to_string(v) +
            " " + test::show(graph.point(v)) + "\n";
  };
  for (Roadmap::Vertex u = 0; u < graph.vertex_count(); ++u) {
    for (const auto v : graph.neighbours(u))
      if (!reference.adjacent(u, v)) edge("too much: ", u, v);
    for (const auto v : reference.neighbours(u))
      if (!graph.adjacent(u, v)) edge("missing: ", u, v);
  }
  return text;
}

void expect_both_kinds_agree(const SmallWorld& world) {
  const FreeSpace space = world.space();
  for (const auto kind : {VisibilityKind::full, VisibilityKind::reduced}) {
    const Roadmap graph = VisibilityGraph(space, kind).roadmap();
    const Roadmap reference = visibility_graph_brute_force(space, kind);
    EXPECT_TRUE(graph == reference) << test::show(world) << '\n' << difference(graph, reference);
  }
}

std::size_t edges(const SmallWorld& world, VisibilityKind kind) {
  return visibility_graph_brute_force(world.space(), kind).edge_count();
}

TEST(VisibilityBruteForce, JoinsTheCornersOfAnEmptyBox) {
  const SmallWorld empty{.walls = {}, .solids = {}};
  EXPECT_EQ(edges(empty, VisibilityKind::full), 6u);
  EXPECT_EQ(visibility_graph_brute_force(empty.space(), VisibilityKind::reduced).vertex_count(), 0u);
}

TEST(VisibilityBruteForce, DrawsTheTangentsOfTwoWalls) {
  // Two upright walls: the outer tangents and the two sides of each wall, which coincide; the crossing ones are tangent
  // as well.
  const SmallWorld world{.walls = {{{3, 3}, {3, 7}}, {{7, 3}, {7, 7}}}, .solids = {}};
  const Roadmap graph = visibility_graph_brute_force(world.space(), VisibilityKind::reduced);
  EXPECT_EQ(graph.vertex_count(), 4u);
  EXPECT_EQ(graph.edge_count(), 6u);
}

TEST(VisibilityBruteForce, DrawsTheTangentsOfTwoBlocks) {
  const SmallWorld world{.walls = {}, .solids = {box_ring(1, 1, 3, 3), box_ring(6, 1, 8, 3)}};
  const Roadmap graph = visibility_graph_brute_force(world.space(), VisibilityKind::reduced);
  EXPECT_EQ(graph.vertex_count(), 8u);
  // Each block's four sides, one line over and one under both in three parts each of which one is new, two crossing
  // ones.
  EXPECT_EQ(graph.edge_count(), 12u);
}

TEST(VisibilityBruteForce, GivesBothSidesOfAWallTheirOwnCorners) {
  const SmallWorld world{.walls = {{{5, 0}, {5, 6}}}, .solids = {}};
  const FreeSpace space = world.space();
  const Roadmap graph = visibility_graph_brute_force(space, VisibilityKind::full);
  EXPECT_EQ(graph.vertex_count(), 7u) << "four corners, the free end, two sides of the foot";
  EXPECT_EQ(std::count(graph.points().begin(), graph.points().end(), Point{5, 0}), 2);
}

TEST(VisibilityBruteForce, SeesNothingThroughTheJointOfTwoBlocks) {
  const SmallWorld world{.walls = {}, .solids = {box_ring(2, 2, 5, 5), box_ring(5, 5, 8, 8)}};
  const Roadmap graph = visibility_graph_brute_force(world.space(), VisibilityKind::full);
  const auto at = [&](Point p) {
    return Roadmap::Vertex(std::find(graph.points().begin(), graph.points().end(), p) - graph.points().begin());
  };
  EXPECT_FALSE(graph.adjacent(at({5, 2}), at({5, 8})));
  EXPECT_FALSE(graph.adjacent(at({2, 5}), at({8, 5})));
  EXPECT_TRUE(graph.adjacent(at({2, 5}), at({5, 8})));
}

TEST(VisibilityGraph, AgreesWithBruteForceOnMessyWorlds) {
  expect_both_kinds_agree({.walls = {{{2, 2}, {8, 8}}, {{2, 8}, {8, 2}}}, .solids = {}});
  expect_both_kinds_agree({.walls = {{{1, 5}, {5, 5}}, {{3, 5}, {9, 5}}, {{5, 5}, {5, 1}}}, .solids = {}});
  expect_both_kinds_agree({.walls = {{{0, 0}, {10, 10}}}, .solids = {box_ring(2, 2, 5, 5), box_ring(5, 5, 8, 8)}});
  expect_both_kinds_agree({.walls = {{{0, 5}, {10, 5}}}, .solids = {box_ring(4, 4, 6, 6)}});
  expect_both_kinds_agree({.walls = {{{2, 1}, {2, 3}}, {{4, 1}, {4, 3}}, {{6, 3}, {6, 5}}}, .solids = {}});
  expect_both_kinds_agree({.walls = {{{1, 1}, {9, 2}}, {{1, 2}, {9, 1}}, {{1, 3}, {7, 0}}}, .solids = {}});
}

void check_graph(const RandomWorld& kind, VisibilityKind visibility) {
  const SmallWorld world = any_world(kind);
  RC_LOG() << test::show(world) << '\n';
  const FreeSpace space = world.space();
  const Roadmap graph = VisibilityGraph(space, visibility).roadmap();
  const Roadmap reference = visibility_graph_brute_force(space, visibility);
  if (!(graph == reference)) RC_FAIL(difference(graph, reference));
}

RC_GTEST_PROP(VisibilityGraph, FullEqualsBruteForceAmongRandomWalls, ()) { check_graph({}, VisibilityKind::full); }
RC_GTEST_PROP(VisibilityGraph, ReducedEqualsBruteForceAmongRandomWalls, ()) {
  check_graph({}, VisibilityKind::reduced);
}
RC_GTEST_PROP(VisibilityGraph, FullEqualsBruteForceAmongStraightWalls, ()) {
  check_graph({.side = 4, .walls = 14, .solids = 2, .straight = true}, VisibilityKind::full);
}
RC_GTEST_PROP(VisibilityGraph, ReducedEqualsBruteForceAmongStraightWalls, ()) {
  check_graph({.side = 4, .walls = 14, .solids = 2, .straight = true}, VisibilityKind::reduced);
}
RC_GTEST_PROP(VisibilityGraph, FullEqualsBruteForceAmongThickWalls, ()) {
  check_graph({.walls = 5, .solids = 2, .thickness = 0.5}, VisibilityKind::full);
}
RC_GTEST_PROP(VisibilityGraph, ReducedEqualsBruteForceAmongThickWalls, ()) {
  check_graph({.walls = 5, .solids = 2, .thickness = 0.5}, VisibilityKind::reduced);
}

Point any_point(int side) {
  const int grain = any(0, 1) ? 1 : 4, x = any(0, side * grain), y = any(0, side * grain);
  return {double(x) / grain, double(y) / grain};
}

/// The star's sectors that the vertices of a graph at one point stand for, by the direction of their first triangle.
std::uint32_t star_sector(const Star& star, const Triangulation& mesh, const Triangulation::Sector& sector) {
  const auto& corners = mesh.triangles[sector.triangle];
  const auto i = static_cast<int>(std::find(corners.begin(), corners.end(), sector.vertex) - corners.begin());
  return star.sector_left_of(mesh.points[corners[Triangulation::ccw(i)]]);
}

/// Does a corner where paths can bend hide v from p in a reduced graph?
bool hidden(const VisibilityGraph& graph, Point p, Point v) {
  const Triangulation& mesh = graph.space().triangulation();
  return std::any_of(mesh.sectors.begin(), mesh.sectors.end(), [&](const Triangulation::Sector& s) {
    const Point w = mesh.points[s.vertex];
    return s.reflex && w != p && w != v && written::on_segment(w, p, v);
  });
}

/// Can a path go straight from p to the place that v stands for, by the constraints alone; tangent there in a reduced
/// graph?
bool joins(const VisibilityGraph& graph, Point p, Roadmap::Vertex v) {
  const auto& constraints = graph.space().constraints();
  const Triangulation& mesh = graph.space().triangulation();
  const Point q = graph.roadmap().point(v);
  const Star star = test::star(q, constraints);
  if (p != q && graph.kind() == VisibilityKind::reduced && !star.tangent(p)) return false;
  const auto reached = test::follow_from(test::star(p, constraints).free_sectors(), {p, q}, constraints);
  return std::binary_search(reached.begin(), reached.end(), star_sector(star, mesh, mesh.sectors[graph.sector(v)]));
}

void check_visible_from(VisibilityKind kind) {
  const SmallWorld world = any_world();
  RC_LOG() << test::show(world) << '\n';
  const FreeSpace space = world.space();
  const VisibilityGraph graph(space, kind);
  for (int i = 0; i < 10; ++i) {
    const Point p = any_point(6);
    if (space.locate(p).kind == Location::Kind::outside) continue;
    RC_LOG() << "from " << test::show(p) << '\n';
    const auto seen = graph.visible_from(p);
    RC_ASSERT(std::is_sorted(seen.begin(), seen.end()));
    for (Roadmap::Vertex v = 0; v < graph.roadmap().vertex_count(); ++v) {
      const bool listed = std::binary_search(seen.begin(), seen.end(), v);
      // As among its edges, a reduced graph may leave out what lies behind a corner that is listed itself.
      const bool may_miss = kind == VisibilityKind::reduced && hidden(graph, p, graph.roadmap().point(v));
      if (listed == joins(graph, p, v) || (may_miss && !listed)) continue;
      RC_FAIL("vertex " + std::to_string(v) + " " + test::show(graph.roadmap().point(v)) +
              (listed ? " is not joined" : " is missing"));
    }
  }
}

RC_GTEST_PROP(VisibilityGraph, JoinsAPointToWhatTheConstraintsAllowInTheFullGraph, ()) {
  check_visible_from(VisibilityKind::full);
}
RC_GTEST_PROP(VisibilityGraph, JoinsAPointToWhatTheConstraintsAllowInTheReducedGraph, ()) {
  check_visible_from(VisibilityKind::reduced);
}

}  // namespace
}  // namespace taut
