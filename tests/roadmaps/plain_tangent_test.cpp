#include <taut/roadmaps/exact/plain_tangent.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>

#include "support/random_world.h"
#include "support/small_world.h"

namespace taut {
namespace {

std::vector<int> sides_of(const TangentSite& site) { return site.round ? std::vector{1, -1} : std::vector{0}; }

struct Count {
  std::size_t all = 0, known = 0, free = 0;
};

/// What doubles tell is what the exact test says.
Count agrees_at(const TangentGround& ground, double r) {
  Count count;
  for (std::uint32_t i = 0; i < ground.sites.size(); ++i)
    for (std::uint32_t j = i + 1; j < ground.sites.size(); ++j) {
      if (ground.sites[i].at == ground.sites[j].at) continue;
      for (const int s : sides_of(ground.sites[i]))
        for (const int t : sides_of(ground.sites[j])) {
          const auto known = plainly_free(ground.walls, r, ground.sites[i], s, ground.sites[j], t);
          ++count.all;
          if (!known) continue;
          ++count.known;
          count.free += *known;
          if (*known != is_free_tangent(ground, {i, j, s, t}, r))
            RC_FAIL(fmt::format("{} {} to {} {} r {}", test::show(ground.sites[i].at), s,
                                test::show(ground.sites[j].at), t, r));
        }
    }
  return count;
}

RC_GTEST_PROP(PlainTangent, NeverContradictsTheExactTest, ()) {
  const test::SmallWorld small =
      test::any_world({.side = 6, .walls = 7, .solids = 2, .straight = test::any(0, 1) == 1});
  const Boundary boundary = std::array{Boundary::walled, Boundary::limit, Boundary::open}[test::any(0, 2)];
  RC_LOG(test::show(small) + fmt::format(" boundary {}\n", int(boundary)));
  const TangentGround ground{FreeSpace(small.bounded(boundary))};
  for (const double r : {0.5, 0.1, std::sqrt(0.5), 1.0, test::any(1, 2000) / 1000.0}) agrees_at(ground, r);
}

TEST(PlainTangent, TellsNearlyAllWhereNothingTouches) {
  const World world =
      test::SmallWorld{.walls = {{{1, 5}, {4, 5.5}}, {{6, 4.75}, {9, 5}}, {{3, 2}, {5, 1}}}, .solids = {}}.bounded(
          Boundary::walled);
  const Count count = agrees_at(TangentGround{FreeSpace(world)}, 0.37);
  EXPECT_EQ(count.known, count.all);
  EXPECT_GT(count.free, 10u);
}

}  // namespace
}  // namespace taut
