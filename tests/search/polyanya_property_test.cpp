// Polyanya against the visibility graph: two roads to one answer.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <optional>

#include <taut/geometry/errors.h>
#include <taut/search/polyanya.h>
#include <taut/search/shortest_path.h>
#include <taut/search/verify.h>

#include "support/messy_world.h"
#include "support/random_world.h"

namespace taut {
namespace {

using namespace test;

Point any_place(int side) {
  const int fine = any(0, 2) == 0 ? 1 : 4;
  const int x = any(0, side * fine), y = any(0, side * fine);
  return {static_cast<double>(x) / fine, static_cast<double>(y) / fine};
}

/// Nothing where walls meet more sharply than doubles can say: FreeSpace refuses these.
std::optional<FreeSpace> space_of(const SmallWorld& world) {
  try {
    return world.space();
  } catch (const InputError&) {
    return std::nullopt;
  }
}

/// Both give the same status and exactly the same length, and the path passes its check.
void expect_agreement(const VisibilityGraph& graph, PolyanyaSearch& search, Point from, const Goal& to,
                      const std::string& what) {
  const GraphSearchResult expected = shortest_path(graph, from, to);
  search.find(from, to);
  const GraphSearchResult found = search.result();
  if (found.status != expected.status) RC_FAIL(what + ": one finds a path, the other none");
  if (found.status != SearchStatus::found) return;
  if (found.path.length != expected.path.length)
    RC_FAIL(
        fmt::format("{}: {} instead of {}", what, found.path.length.decimals(20), expected.path.length.decimals(20)));
  if (!to.point) return;  // walls through a room: where one may enter it is the graph's to say
  const Verdict verdict = verify(found.path, graph.space(), from, to);
  if (!verdict.valid) RC_FAIL(what + ": " + verdict.reason);
}

void agree_in(const SmallWorld& world, int queries) {
  const auto made = space_of(world);
  if (!made) return;
  const FreeSpace& space = *made;
  const VisibilityGraph graph(space);
  PolyanyaSearch merged{Polyanya(space)}, triangles{Polyanya(space, triangle_navmesh(space))},
      landmarks{Polyanya(space).with_landmarks(3)}, bends{Polyanya(space).with_graph()},
      both{Polyanya(space).with_landmarks(3).with_graph()};
  const int side = static_cast<int>(world.area[2].x);
  for (int n = 0; n < queries; ++n) {
    const Point from = any_place(side), to = any_place(side);
    if (space.locate(from).kind == Location::Kind::outside || space.locate(to).kind == Location::Kind::outside)
      continue;
    const std::string what = show(world) + " from " + show(from) + " to " + show(to);
    expect_agreement(graph, merged, from, {to, {}}, what);
    expect_agreement(graph, triangles, from, {to, {}}, what + " (triangles)");
    expect_agreement(graph, landmarks, from, {to, {}}, what + " (landmarks)");
    expect_agreement(graph, bends, from, {to, {}}, what + " (graph)");
    expect_agreement(graph, both, from, {to, {}}, what + " (graph and landmarks)");
    PolyanyaSearch between{Polyanya(space, navmesh_between(space, from, {to, {}}))};
    expect_agreement(graph, between, from, {to, {}}, what + " (mesh without dead ends)");
  }
}

RC_GTEST_PROP(PolyanyaProperty, IsAsLongAsInTheVisibilityGraph, ()) { agree_in(any_world(), 20); }

RC_GTEST_PROP(PolyanyaProperty, IsAsLongAsInTheVisibilityGraphAmongManyThinWalls, ()) {
  agree_in(any_world({.side = 5, .walls = 25, .solids = 0}), 20);
}

RC_GTEST_PROP(PolyanyaProperty, IsAsLongAsInTheVisibilityGraphWhereEverythingIsRightAngled, ()) {
  agree_in(any_world({.side = 7, .walls = 20, .solids = 4, .straight = true}), 20);
}

RC_GTEST_PROP(PolyanyaProperty, EntersARoomWhereTheVisibilityGraphDoes, ()) {
  const SmallWorld world = any_world({.side = 6, .walls = 12, .solids = 2});
  const auto made = space_of(world);
  if (!made) return;
  const FreeSpace& space = *made;
  const VisibilityGraph graph(space);
  PolyanyaSearch search{Polyanya(space)};
  for (int n = 0; n < 8; ++n) {
    const Point from = any_place(6);
    if (space.locate(from).kind == Location::Kind::outside) continue;
    Goal to;
    const int x = any(0, 4), y = any(0, 5);
    to.room = {{{double(x), double(y)}, {x + 1.0, y + 1.0}}, {{x + 1.0, double(y)}, {x + 2.0, y + 1.0}}};
    const std::string what = fmt::format("{} from {} to the room at {}, {}", show(world), show(from), x, y);
    expect_agreement(graph, search, from, to, what);
    PolyanyaSearch between{Polyanya(space, navmesh_between(space, from, to))};
    expect_agreement(graph, between, from, to, what + " (mesh without dead ends)");
  }
}

RC_GTEST_PROP(PolyanyaProperty, IsAsLongAsInTheVisibilityGraphOffEveryLattice, ()) {
  const std::uint64_t seed = *rc::gen::arbitrary<std::uint64_t>();
  MessyWorld world = messy_world(seed);
  const FreeSpace space(World(std::move(world.parts)), world.footprint);
  const VisibilityGraph graph(space);
  PolyanyaSearch search{Polyanya(space)}, bends{Polyanya(space).with_graph().with_landmarks(2)};
  std::mt19937_64 engine(seed);
  const auto coordinate = [&] { return static_cast<double>(engine() >> 11) * 0x1p-53 * 10; };
  for (int n = 0; n < 20; ++n) {
    const double x = coordinate(), y = coordinate(), u = coordinate(), v = coordinate();
    const Point from{x, y}, to{u, v};
    if (space.locate(from).kind == Location::Kind::outside || space.locate(to).kind == Location::Kind::outside)
      continue;
    expect_agreement(graph, search, from, {to, {}},
                     fmt::format("messy world {} from {} to {}", seed, show(from), show(to)));
    expect_agreement(graph, bends, from, {to, {}},
                     fmt::format("messy world {} from {} to {} (graph)", seed, show(from), show(to)));
  }
}

RC_GTEST_PROP(PolyanyaProperty, FindsTheNearestOfSeveralGoalsAndEachOfThem, ()) {
  const SmallWorld world = any_world({.side = 6, .walls = 12, .solids = 2});
  const auto made = space_of(world);
  if (!made) return;
  const FreeSpace& space = *made;
  const auto mesh = [&] { return any(0, 1) == 0 ? navmesh(space) : triangle_navmesh(space); };
  PolyanyaSearch one{Polyanya(space)}, all{Polyanya(space, mesh())};
  const Point from = any_place(6);
  if (space.locate(from).kind == Location::Kind::outside) return;
  std::vector<Point> goals;
  for (int n = any(0, 6); n > 0; --n) goals.push_back(any_place(6));
  const auto each = all.find_each(from, goals);
  std::optional<Length> least;
  for (std::size_t i = 0; i < goals.size(); ++i) {
    const bool inside = space.locate(goals[i]).kind != Location::Kind::outside;
    const bool reached = inside && one.find(from, goals[i]) == SearchStatus::found;
    RC_ASSERT(each[i].has_value() == reached);
    if (!reached) continue;
    const Length length = one.result().path.length;
    RC_ASSERT(each[i]->length == length);
    if (!least || length < *least) least = length;
  }
  RC_ASSERT((all.find_nearest(from, goals) == SearchStatus::found) == least.has_value());
  if (!least) return;
  const GraphSearchResult nearest = all.result();
  if (nearest.path.length != *least) {
    std::string places;
    for (const Point p : goals) places += show(p) + " ";
    RC_FAIL(fmt::format("{} from {} to the nearest of {}: {} instead of {}", show(world), show(from), places,
                        nearest.path.length.decimals(20), least->decimals(20)));
  }
  RC_ASSERT(nearest.path.points.back() == goals[nearest.goal]);
}

}  // namespace
}  // namespace taut
