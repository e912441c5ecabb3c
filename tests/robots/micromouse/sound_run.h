// What holds of any speed run, and random mazes for them.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <taut/geometry/maze_generator.h>

#include "robots/micromouse/slow_speed_run.h"

namespace taut::micromouse {

inline GridMaze random_maze(int width, int height, std::uint64_t seed, double share) {
  GridMaze maze = generate_backtracker(width, height, seed);
  open_walls(maze, share, seed);
  open_centre_room(maze);
  return maze;
}

/// A line in cells to one in half cells, with a point every few hundredths.
inline void append_finely(std::vector<Point>& line, const std::vector<Point>& part) {
  for (std::size_t i = 1; i < part.size(); ++i) {
    const Point a = part[i - 1], b = part[i];
    const int pieces = 1 + static_cast<int>(std::hypot(b.x - a.x, b.y - a.y) / 0.03);
    for (int k = 0; k <= pieces; ++k)
      line.push_back({2 * (a.x + (b.x - a.x) * k / pieces), 2 * (a.y + (b.y - a.y) * k / pieces)});
  }
}

/// Everything a run says about itself holds.
inline void expect_sound(const SpeedRun& run, const GridMaze& maze, const SpeedModel& model) {
  const Task task = task_of(maze);
  double seconds = 0, metres = 0, speed = 0;
  Spot at{2 * task.start.x + 1, 2 * task.start.y + 1};
  Eighth heading = 0;
  std::vector<Point> line;
  for (const Drive& d : run.drives) {
    EXPECT_EQ(d.from, at);
    EXPECT_EQ(d.heading, heading);
    EXPECT_EQ(d.speed_in, speed);
    const bool diagonal = d.heading % 2 == 1;
    if (d.kind == Drive::Kind::straight) {
      EXPECT_NEAR(d.seconds,
                  *integrated_seconds(diagonal ? model.diagonal : model.straight, d.speed_in, d.speed_out, d.metres),
                  1e-5);
    }
    double traced = 0;
    const auto part = trace(d, 0.01);
    for (std::size_t i = 1; i < part.size(); ++i)
      traced += std::hypot(part[i].x - part[i - 1].x, part[i].y - part[i - 1].y);
    EXPECT_NEAR(traced * model.cell, d.metres, 1e-3 * std::max(d.metres, 0.1)) << name(d);
    append_finely(line, part);
    at = d.to, heading = d.after, speed = d.speed_out;
    seconds += d.seconds, metres += d.metres;
  }
  EXPECT_EQ(speed, 0);
  EXPECT_TRUE(task.in_goal({at.x / 2, at.y / 2}));
  EXPECT_DOUBLE_EQ(seconds, run.seconds);
  EXPECT_DOUBLE_EQ(metres, run.metres);
  const auto cells = passed(maze, line);
  ASSERT_TRUE(cells.has_value());
  if (run.metres > 0) {
    EXPECT_EQ(*cells, run.cells);
  }
}

}  // namespace taut::micromouse
