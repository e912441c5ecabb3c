#include <taut/search/roadmap_distances.h>

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <set>
#include <utility>

#include <taut/geometry/triangulation.h>

#include "support/graph_case.h"
#include "support/lattice.h"

namespace taut {
namespace {

using Vertex = Roadmap::Vertex;

double leg(const Roadmap& map, Vertex v, Vertex w) {
  return std::hypot(map.point(v).x - map.point(w).x, map.point(v).y - map.point(w).y);
}

/// A loop of one's own: an ordered set is the queue.
std::vector<double> lengths_by_a_loop(const Roadmap& map, const std::vector<RoadmapSource>& sources) {
  std::vector<double> length(map.vertex_count(), HUGE_VAL);
  std::set<std::pair<double, Vertex>> open;
  const auto reach = [&](Vertex v, double l) {
    if (l >= length[v]) return;
    open.erase({length[v], v});
    length[v] = l;
    open.insert({l, v});
  };
  for (const auto& [v, l] : sources) reach(v, l);
  while (!open.empty()) {
    const auto [l, v] = *open.begin();
    open.erase(open.begin());
    for (const Vertex w : map.neighbours(v)) reach(w, l + leg(map, v, w));
  }
  return length;
}

void expect_same(const Roadmap& map, const std::vector<RoadmapSource>& sources) {
  const RoadmapDistances found = roadmap_distances(map, sources);
  RC_ASSERT(found.length == lengths_by_a_loop(map, sources));
  for (Vertex v = 0; v < map.vertex_count(); ++v)
    if (const Vertex next = found.next[v]; next != kNone)
      RC_ASSERT(map.adjacent(v, next) && found.length[v] == found.length[next] + leg(map, next, v));
}

RC_GTEST_PROP(RoadmapDistances, AreThoseOfAPlainLoopToTheBit, ()) {
  const test::GraphCase c = test::any_graph_case();
  std::vector<RoadmapSource> sources;
  for (const Terminal& goal : c.query.goals)
    for (const Vertex v : goal.vertices) sources.push_back({v, 0.1 * static_cast<double>(sources.size())});
  expect_same(c.map, sources);
}

TEST(RoadmapDistances, LeadBackToTheNearestSource) {
  const Roadmap map = test::lattice(9);
  const RoadmapDistances found = roadmap_distances(map, std::vector<RoadmapSource>{{0, 0}, {8, 2.5}, {8, 0.5}});
  EXPECT_EQ(found.length[4], 4);
  EXPECT_EQ(found.length[5], 3.5);
  EXPECT_EQ(found.next[5], 6u);
  EXPECT_EQ(found.next[8], kNone);
}

TEST(RoadmapDistances, AreInfiniteWithoutASource) {
  const Roadmap map({{0, 0}, {1, 0}, {2, 0}}, std::vector<std::pair<Vertex, Vertex>>{{0, 1}});
  EXPECT_EQ(roadmap_distances(map, {}).length[0], HUGE_VAL);
  EXPECT_EQ(roadmap_distances(map, std::vector<RoadmapSource>{{0, 1}}).length, (std::vector<double>{1, 2, HUGE_VAL}));
}

}  // namespace
}  // namespace taut
