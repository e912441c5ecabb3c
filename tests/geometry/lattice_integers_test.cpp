// A world's coordinates as integers.
#include <taut/geometry/lattice_integers.h>

#include <gtest/gtest.h>

#include <array>
#include <optional>

#include "support/small_world.h"

namespace taut {
namespace {

using Place = LatticeIntegers::Place;

World tenths() { return World(test::SmallWorld{.walls = {{{0.1, 0.2}, {3.7, 4}}}}.parts()); }

TEST(LatticeIntegers, AreMultiplesOfTheWorldsUnit) {
  const LatticeIntegers integers(tenths());
  EXPECT_EQ(integers.scale(), 1);
  EXPECT_EQ(integers.place({3.7, 4}), (Place{37, 40}));
  EXPECT_EQ(integers.place({0.25, 0}), std::nullopt);
}

TEST(LatticeIntegers, AreCountedFinerWhereAPlaceNeedsIt) {
  const LatticeIntegers integers(tenths(), std::array{Point{0.25, 0.125}, Point{1, 1}});
  EXPECT_EQ(integers.scale(), 4);
  EXPECT_EQ(integers.place({0.25, 0.125}), (Place{10, 5}));
  EXPECT_EQ(integers.place({3.7, 4}), (Place{148, 160}));
}

TEST(LatticeIntegers, CountBinaryFractionsToo) {
  const LatticeIntegers integers(World(test::SmallWorld{.walls = {{{0x1p-20, 0}, {1, 1}}}}.parts()));
  EXPECT_EQ(integers.place({1, 0x1p-20}), (Place{1 << 20, 1}));
}

TEST(LatticeIntegers, AreRefusedWhereThereAreNone) {
  const World computed(test::SmallWorld{.walls = {{{0.1, 0.3000000000000001}, {0.70000000000000007, 1}}}}.parts());
  EXPECT_THROW(LatticeIntegers{computed}, InputError);
  EXPECT_THROW(LatticeIntegers(tenths(), std::array{Point{1.0 / 3, 0}}), InputError);
}

}  // namespace
}  // namespace taut
