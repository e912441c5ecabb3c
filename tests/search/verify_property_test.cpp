// Planner and check share nothing: every answer of the one must pass the other.
#include <taut/search/verify.h>

#include <algorithm>

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <taut/geometry/segment_distance.h>
#include <taut/search/shortest_path.h>

#include "support/constraint_walk.h"
#include "support/random_world.h"

namespace taut {
namespace {

using test::any;
using test::any_world;
using test::RandomWorld;

Point any_point(int side) {
  const int x = any(0, 4 * side), y = any(0, 4 * side);
  return {x / 4.0, y / 4.0};
}

FreeSpace any_space(int& side) {
  const RandomWorld kinds[] = {
      {}, {.side = 4, .walls = 14, .solids = 2, .straight = true}, {.walls = 5, .solids = 2, .thickness = 0.5}};
  const RandomWorld& kind = kinds[any(0, 2)];
  side = kind.side;
  const auto world = any_world(kind);
  RC_LOG() << test::show(world) << '\n';
  return world.space();
}

RC_GTEST_PROP(Verify, AcceptsShortestPaths, ()) {
  int side = 0;
  const FreeSpace space = any_space(side);
  const VisibilityGraph graph(space), full(space, VisibilityKind::full);
  for (int i = 0; i < 5; ++i) {
    const Point p = any_point(side), q = any_point(side);
    if (space.locate(p).kind == Location::Kind::outside || space.locate(q).kind == Location::Kind::outside) continue;
    RC_LOG() << test::show(p) << ' ' << test::show(q) << '\n';
    const Goal goal{q, {}};
    const auto result = shortest_path(graph, p, goal);
    const auto second = shortest_path(full, p, goal);
    RC_ASSERT(result.status == second.status);
    if (result.status != SearchStatus::found) continue;
    RC_ASSERT(verify(result.path, space, p, goal).reason == "");
    RC_ASSERT(verify(second.path, space, p, goal).reason == "");
    RC_ASSERT(result.path.length == second.path.length);
  }
}

RC_GTEST_PROP(Verify, JudgesAnyPathAsTheConstraintsDoWithoutAnIndex, ()) {
  int side = 0;
  const FreeSpace space = any_space(side);
  for (int i = 0; i < 20; ++i) {
    Path path;
    for (int n = any(1, 4); n > 0; --n) path.points.push_back(any_point(side));
    path.length = Length(path.points);
    const Point from = path.points.front();
    if (space.locate(from).kind == Location::Kind::outside) continue;
    const Verdict verdict = verify(path, space, from, {path.points.back(), {}});
    RC_ASSERT(verdict.valid == test::follows(path.points, space.constraints()));
    RC_ASSERT(verdict.valid == verdict.reason.empty());
  }
}

/// The least distance of the path to a constraint and the lowest that has it, one pair after the other.
std::uint32_t nearest_constraint(const std::vector<Point>& path, const std::vector<Constraint>& constraints,
                                 double& distance) {
  std::uint32_t nearest = 0;
  Segment nearest_leg{path[0], path[0]};
  for (std::uint32_t i = 0; i < constraints.size(); ++i)
    for (std::size_t k = 0; k < path.size(); ++k) {
      const Segment leg{path[k], path[std::min(k + 1, path.size() - 1)]};
      const Constraint &c = constraints[i], &best = constraints[nearest];
      if (compare_segment_distances(leg, {c.a, c.b}, nearest_leg, {best.a, best.b}) >= 0) continue;
      nearest = i;
      nearest_leg = leg;
    }
  distance = segment_distance(nearest_leg, {constraints[nearest].a, constraints[nearest].b});
  return nearest;
}

RC_GTEST_PROP(Verify, FindsTheNearestConstraint, ()) {
  int side = 0;
  const FreeSpace space = any_space(side);
  RC_PRE(!space.constraints().empty());
  for (int i = 0; i < 20; ++i) {
    // Short paths: the others touch something.
    Path path{{any_point(side)}, {}};
    for (int n = any(0, 2); n > 0; --n)
      path.points.push_back({path.points.back().x + any(-1, 1) / 4.0, path.points.back().y + any(-1, 1) / 4.0});
    const Verdict verdict = verify(path, space, path.points.front(), {path.points.back(), {}});
    double distance = 0;
    RC_ASSERT(verdict.nearest == nearest_constraint(path.points, space.constraints(), distance));
    RC_ASSERT(verdict.clearance == distance);
  }
}

}  // namespace
}  // namespace taut
