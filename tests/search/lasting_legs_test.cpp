#include <taut/search/detail/lasting_legs.h>

#include <algorithm>
#include <set>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "support/random_world.h"

namespace taut::detail {
namespace {

using namespace test;

std::vector<std::size_t> next_of(const TautLegs& legs, std::size_t leg) {
  std::vector<std::size_t> next;
  for (const TautLegs::Range range : {legs.right_of(leg), legs.left_of(leg)})
    for (std::size_t e = range.first; e < range.last; ++e) next.push_back(e);
  return next;
}

/// By its meaning: can a string go on for more legs than there are? Round after round.
std::vector<bool> lasting_by_walking(const TautLegs& legs) {
  std::vector<bool> lasts(legs.size(), true);
  for (std::size_t round = 0; round <= legs.size(); ++round) {
    std::vector<bool> now(legs.size());
    for (std::size_t e = 0; e < legs.size(); ++e) {
      const auto next = next_of(legs, e);
      now[e] = std::any_of(next.begin(), next.end(), [&](std::size_t n) { return lasts[n]; });
    }
    if (now == lasts) break;
    lasts = now;
  }
  return lasts;
}

RC_GTEST_PROP(LastingLegs, AreThoseThatAStringGoesOnFromForEver, ()) {
  const FreeSpace space = any_world({.walls = 6}).space();
  const VisibilityGraph graph(space, VisibilityKind::reduced);
  const TautLegs legs(graph);
  const LastingLegs lasting(legs);
  const std::vector<bool> expected = lasting_by_walking(legs);
  for (std::size_t e = 0; e < legs.size(); ++e) {
    RC_ASSERT(lasting.lasts(e) == expected[e]);
    for (const LastingLegs::Arrival before : lasting.before(e)) {
      const auto next = next_of(legs, before.leg);
      RC_ASSERT(!expected[before.leg] && std::count(next.begin(), next.end(), e) > 0);
      RC_ASSERT(legs.of(before.from).first <= before.leg && before.leg < legs.of(before.from).last);
    }
  }
}

RC_GTEST_PROP(LastingLegs, AreLedToByAllOthersThatMayPrecedeThem, ()) {
  const FreeSpace space = any_world({.walls = 6}).space();
  const TautLegs legs(VisibilityGraph(space, VisibilityKind::reduced));
  const LastingLegs lasting(legs);
  for (std::size_t e = 0; e < legs.size(); ++e) {
    if (lasting.lasts(e)) continue;
    for (const std::size_t next : next_of(legs, e)) {
      const auto before = lasting.before(next);
      RC_ASSERT(std::any_of(before.begin(), before.end(), [&](const auto& a) { return a.leg == e; }));
    }
    const auto arriving = lasting.arriving_at(legs[e].to);
    RC_ASSERT(std::any_of(arriving.begin(), arriving.end(), [&](const auto& a) { return a.leg == e; }));
  }
}

TEST(LastingLegs, GoRoundABlock) {
  const TautLegs legs(VisibilityGraph(SmallWorld{.solids = {box_ring(4, 4, 6, 6)}}.space(), VisibilityKind::reduced));
  const LastingLegs lasting(legs);
  std::set<std::uint32_t> reached;
  for (std::size_t e = 0; e < legs.size(); ++e)
    if (lasting.lasts(e)) reached.insert(legs[e].to);
  EXPECT_EQ(reached.size(), 4u);
}

}  // namespace
}  // namespace taut::detail
