#include <taut/robots/micromouse/speed_model.h>

#include <gtest/gtest.h>

#include "robots/micromouse/slow_speed_run.h"

namespace taut::micromouse {
namespace {

TEST(SpeedModel, TimesStraightsAsAnIntegratorDoes) {
  for (const Ramp& ramp : {Ramp{10, 10, 4}, Ramp{8, 12, 3}, Ramp{3, 5, 0.9}})
    for (const double from : {0.0, 0.5, 0.9})
      for (const double to : {0.0, 0.5, 0.9})
        for (const double metres : {0.02, 0.09, 0.5, 3.0}) {
          const auto exact = straight_seconds(ramp, from, to, metres);
          const auto integrated = integrated_seconds(ramp, from, to, metres);
          ASSERT_EQ(exact.has_value(), integrated.has_value()) << from << " " << to << " " << metres;
          if (exact) {
            EXPECT_NEAR(*exact, *integrated, 1e-5);
          }
        }
  EXPECT_EQ(straight_seconds({10, 10, 4}, 1, 1, 0), 0.0);
  EXPECT_EQ(straight_seconds({10, 10, 4}, 0, 0, 0), 0.0);
  EXPECT_FALSE(straight_seconds({10, 10, 4}, 0, 1, 0).has_value());
}

}  // namespace
}  // namespace taut::micromouse
