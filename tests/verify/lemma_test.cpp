// The lemmas behind certificates (docs/certificates.md, "What makes it a proof"), each asked of random worlds.
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include <taut/io/worlds/write_world.h>
#include <taut/search/shortest_path.h>
#include <taut/verify/world.h>

#include "support/random_world.h"

namespace taut {
namespace {

using proof::Corner;
using proof::Place;
using test::any;

constexpr std::int64_t kScale = 4;

struct Case {
  FreeSpace space;
  proof::World judged;
  Point start, goal;
};

/// Ends that are places, in a world in which no crossing was rounded.
std::optional<Case> any_case() {
  const test::RandomWorld kinds[] = {
      {}, {.side = 4, .walls = 14, .solids = 2, .straight = true}, {.side = 5, .walls = 0, .solids = 6}};
  const test::RandomWorld& kind = kinds[any(0, 2)];
  const FreeSpace space(World(test::any_world(kind).parts()));
  const auto place = [&] { return Point{any(0, 4 * kind.side) / 4.0, any(0, 4 * kind.side) / 4.0}; };
  const Point p = place(), q = place();
  const auto is_place = [&](Point r) { return space.locate(r).kind != Location::Kind::outside; };
  if (space.report().displacement > 0 || !is_place(p) || !is_place(q) || p == q) return std::nullopt;
  return Case{space, proof::World(write_integers(space.world()), kScale), p, q};
}

Place place_of(Point p) { return {static_cast<std::int64_t>(p.x * kScale), static_cast<std::int64_t>(p.y * kScale)}; }

const Corner* corner_at(const proof::World& world, Place p) {
  const auto found = world.corners.find(p);
  return found == world.corners.end() ? nullptr : &found->second;
}

/// The bends of a shortest path between its ends, for as many cases as RapidCheck takes.
template <class Ask>
void for_each_bend(Ask ask) {
  const auto found = any_case();
  if (!found) return;
  const auto path = shortest_path(found->space, found->start, found->goal);
  for (std::size_t i = 1; path && i + 1 < path->points.size(); ++i) {
    const Place before = place_of(path->points[i - 1]), at = place_of(path->points[i]),
                after = place_of(path->points[i + 1]);
    if (proof::side(before, at, after) != 0) ask(*found, before, at, after);
  }
}

RC_GTEST_PROP(Lemma, AShortestPathBendsAtCornersAlone, ()) {
  for_each_bend([](const Case& c, Place, Place at, Place) { RC_ASSERT(corner_at(c.judged, at) != nullptr); });
}

RC_GTEST_PROP(Lemma, LegsOfAShortestPathAreTangentAtItsBends, ()) {
  for_each_bend([](const Case& c, Place before, Place at, Place after) {
    const Corner* const corner = corner_at(c.judged, at);
    RC_ASSERT(corner != nullptr);
    RC_ASSERT(corner->is_tangent(at - before) && corner->is_tangent(after - at));
  });
}

RC_GTEST_PROP(Lemma, ALegIsOpenWhereNoComponentOfContactsClosesBothSides, ()) {
  const auto found = any_case();
  if (!found) return;
  const bool is_open = !found->judged.leg(Corner{place_of(found->start)}, Corner{place_of(found->goal)});
  RC_ASSERT(is_open == found->space.sees(found->start, found->goal));
}

RC_GTEST_PROP(Lemma, NoLegIsOpenIntoABoxThatAChainOfEdgesHides, ()) {
  const auto found = any_case();
  if (!found) return;
  const Place u = place_of(found->start), v = place_of(found->goal);
  std::vector<proof::Edge> edges;
  for (const proof::Edge& e : found->judged.edges.items)
    if (const int at_u = proof::side(e.a, e.b, u); at_u != 0)
      edges.push_back(at_u > 0 ? e : proof::Edge{e.b, e.a, false});
  const proof::Box box{proof::least(v, v), proof::most(v, v)};
  if (proof::is_hidden(box, u, edges)) RC_ASSERT(found->judged.leg(Corner{u}, Corner{v}) != nullptr);
}

TEST(Lemma, EdgesHideABoxTogetherWhereTheyMeetOrOverlapAsSeenFromThePlace) {
  using proof::Edge;
  const Edge right{{4, -4}, {4, 0}}, left{{4, 0}, {5, 4}}, apart{{4, 1}, {5, 4}}, behind{{6, -1}, {6, 9}};
  const proof::Box box{{9, -2}, {10, 2}}, before{{3, -2}, {4, 2}};
  EXPECT_TRUE(proof::is_hidden(box, {0, 0}, {right, left}));
  EXPECT_TRUE(proof::is_hidden(box, {0, 0}, {left, right}));
  EXPECT_TRUE(proof::is_hidden(box, {0, 0}, {right, behind})) << "one farther away than the other";
  EXPECT_FALSE(proof::is_hidden(box, {0, 0}, {right})) << "half of it is seen";
  EXPECT_FALSE(proof::is_hidden(box, {0, 0}, {left}));
  EXPECT_FALSE(proof::is_hidden(box, {0, 0}, {right, apart})) << "through the gap";
  EXPECT_FALSE(proof::is_hidden(before, {0, 0}, {right, left})) << "before them";
  EXPECT_FALSE(proof::is_hidden({{6, -2}, {10, 2}}, {0, 0}, {right, behind})) << "in front of the farther one";
}

RC_GTEST_PROP(Lemma, APathThatTurnsAtACornerKeepsToTheSideThatItTurnsTo, ()) {
  for_each_bend([](const Case& c, Place before, Place at, Place after) {
    const int turn = proof::side(before, at, after) > 0 ? 1 : 2;  // the side that is closed
    const Corner end{at, Place{1, 0}};                            // no end of the path
    RC_ASSERT(!c.judged.leg(Corner{before, before == place_of(c.start) ? Place{} : Place{1, 0}}, end, 0, turn));
    RC_ASSERT(!c.judged.leg(end, Corner{after, after == place_of(c.goal) ? Place{} : Place{1, 0}}, turn, 0));
  });
}

}  // namespace
}  // namespace taut
