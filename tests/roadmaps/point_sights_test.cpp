#include <taut/roadmaps/point_sights.h>

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "support/random_world.h"

namespace taut {
namespace {

using namespace test;

using Vertices = std::vector<Roadmap::Vertex>;

Vertices sorted(std::span<const Roadmap::Vertex> found) {
  Vertices vertices(found.begin(), found.end());
  std::sort(vertices.begin(), vertices.end());
  return vertices;
}

/// Asked of all places in turn, on vertices, sides and lines of vertices among them.
void expect_sights(const SmallWorld& world, VisibilityKind kind, const std::vector<Point>& places) {
  const FreeSpace space = world.space();
  const VisibilityGraph graph(space, kind);
  const PointSights sights(graph);
  PointSights::Finder finder(sights);
  for (const Point p : places)
    if (space.locate(p).kind != Location::Kind::outside)
      RC_ASSERT(sorted(finder.visible_from(p)) == graph.visible_from(p));
}

RC_GTEST_PROP(PointSights, AreThoseOfTheGraph, ()) {
  const SmallWorld world = any_world({});
  std::vector<Point> places;
  for (int n = 0; n < 20; ++n) places.push_back(any(0, 1) ? any_fine_point(6) : any_lattice_point(6));
  for (int n = 0; n < 10; ++n) places.push_back({any(0, 12) / 2.0, any(0, 12) / 2.0});
  expect_sights(world, VisibilityKind::reduced, places);
  expect_sights(world, VisibilityKind::full, places);
}

RC_GTEST_PROP(PointSights, AreThoseOfTheGraphOffItsLattice, ()) {
  // Some points are on no lattice that the vertices are on, and of some worlds the vertices are on none.
  SmallWorld world = any_world({});
  if (any(0, 1)) world.walls.push_back({{1, 1 + 0x1p-45}, {2, 3}});
  std::vector<Point> places{{1, 1 + 0x1p-45}, {0x1p-40, 3}, {1.0 / 3, 2.0 / 3}, {3, 0x1p-30}};
  for (int n = 0; n < 10; ++n) places.push_back(any_fine_point(6));
  expect_sights(world, VisibilityKind::reduced, places);
}

}  // namespace
}  // namespace taut
