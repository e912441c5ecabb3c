// Looks planned as one tour.
#include <taut/robots/micromouse/detail/look_tour.h>

#include <gtest/gtest.h>

#include <taut/robots/micromouse/detail/scout.h>
#include <taut/robots/micromouse/steps.h>
#include <taut/robots/micromouse/trial.h>

#include "robots/micromouse/support.h"

namespace taut::micromouse::detail {
namespace {

constexpr int kWidth = 24, kRow = 4;
constexpr MousePose kMiddle{{10, kRow}, Side::north};

/// A corridor from west to east, nothing known of the walls beside it.
WallMap corridor() {
  Task task;
  task.width = kWidth, task.height = 10;
  WallMap map(task);
  for (int x = 0; x + 1 < kWidth; ++x) map.learn({x, kRow}, Side::east, false);
  return map;
}

struct Boards {
  WallBoard weights{std::vector<float>(kWidth * 10), std::vector<float>(kWidth * 10)}, open = weights;
  /// The wall to the north of a cell of the corridor.
  void weigh(int x, float weight) { weights.north[kRow * kWidth + x] = weight; }
};

constexpr double kLater = 0.5;

TourTuning of(int looks) { return {.looks = looks, .discount = kLater}; }

TEST(LookTour, CountsAWallOnce) {
  Boards boards;
  boards.weigh(11, 1);
  const auto tour = best_tour(corridor(), kMiddle, boards.weights, boards.open, of(4));
  ASSERT_TRUE(tour);
  EXPECT_EQ(tour->looks, 1);
  EXPECT_EQ(tour->way.size(), 1U);
  EXPECT_NEAR(tour->value, kLater, 1e-6);
}

TEST(LookTour, GoesOnToFurtherLooks) {
  Boards boards;
  boards.weigh(9, 0.5);
  boards.weigh(11, 0.4F);
  boards.weigh(12, 0.4F);
  const auto alone = best_tour(corridor(), kMiddle, boards.weights, boards.open, of(1));
  const auto all = best_tour(corridor(), kMiddle, boards.weights, boards.open, of(3));
  ASSERT_TRUE(alone && all);
  EXPECT_NEAR(alone->value, 0.5 * kLater, 1e-6);
  EXPECT_NEAR(all->value, (0.5 + 0.4 * kLater + 0.4 * kLater * kLater) * kLater, 1e-6);
  EXPECT_EQ(all->looks, 3);
}

TEST(LookTour, CountsWhatShowsOnTheWay) {
  Boards boards;
  boards.weigh(16, 0.8F);
  boards.weigh(19, 0.8F);
  const auto tour = best_tour(corridor(), kMiddle, boards.weights, boards.open, of(1));
  ASSERT_TRUE(tour);
  EXPECT_EQ(tour->way.size(), 3U);
  EXPECT_NEAR(tour->value, 0.8 * (0.25 + 0.125), 1e-6);
}

TEST(LookTour, IsAbsentWhereNothingIsToBeSeen) {
  const Boards boards;
  EXPECT_FALSE(best_tour(corridor(), kMiddle, boards.weights, boards.open));
}

TEST(LookTour, ProvesToo) {
  for (const GridMaze& maze : {generated(12, 3), generated(14, 4)}) {
    Scout robot(task_of(maze), ScoutGoal::proof);
    const Record record = run_trial(maze, robot);
    ASSERT_TRUE(record.score());
    const WallMap known = known_after_run1(record);
    EXPECT_EQ(optimum(known.possible(), record.task), optimum(known.certain(), record.task));
    EXPECT_EQ(record.run2, *optimum(passages_of(maze), record.task));
  }
}

}  // namespace
}  // namespace taut::micromouse::detail
