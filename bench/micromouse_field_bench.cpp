// How the constants of robots/micromouse/detail/wall_field.h come about: maximum pseudo-likelihood on generated mazes.
//   micromouse_field_bench
#include <Eigen/Dense>

#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

#include <taut/geometry/maze_generator.h>
#include <taut/robots/micromouse/contest_maze.h>
#include <taut/robots/micromouse/detail/wall_field.h>
#include <taut/robots/micromouse/rules.h>

namespace {

using namespace taut;
using namespace taut::micromouse;

// Posts by Quad, cells by Quad, border arms, walls.
constexpr int kPosts = 0, kCells = 6, kBorder = 12, kWall = 13, kFactors = 14;
using Vector = Eigen::Matrix<double, kFactors, 1>;
using Matrix = Eigen::Matrix<double, kFactors, kFactors>;

struct Example {
  Vector with_minus_without;
  bool stands;
};

unsigned bit(Side side) { return 1U << static_cast<unsigned>(side); }

unsigned sides_of(const GridMaze& maze, Cell c) {
  unsigned sides = 0;
  for (const Side side : kSides)
    if (maze.wall(c, side)) sides |= bit(side);
  return sides;
}

/// Of the post at the lower left of an inner cell.
unsigned arms_of(const GridMaze& maze, Cell c) {
  const Cell across{c.x - 1, c.y - 1};
  return (maze.wall(c, Side::west) ? bit(Side::north) : 0) | (maze.wall(c, Side::south) ? bit(Side::east) : 0) |
         (maze.wall(across, Side::east) ? bit(Side::south) : 0) |
         (maze.wall(across, Side::north) ? bit(Side::west) : 0);
}

void count(const GridMaze& maze, Cell c, Side side, double sign, Vector& into) {
  for (const Cell cell : {c, ahead(c, side)})
    into[kCells + static_cast<int>(detail::quad_of(sides_of(maze, cell)))] += sign;
  for (const Cell post : {side == Side::north ? Cell{c.x, c.y + 1} : Cell{c.x + 1, c.y}, Cell{c.x + 1, c.y + 1}}) {
    const bool border = post.x == 0 || post.y == 0 || post.x == maze.width() || post.y == maze.height();
    if (!border)
      into[kPosts + static_cast<int>(detail::quad_of(arms_of(maze, post)))] += sign;
    else if (sign > 0)
      into[kBorder] += 1;
  }
  if (sign > 0) into[kWall] += 1;
}

void add_examples(GridMaze maze, std::vector<Example>& examples) {
  const Task task = task_of(maze);
  for (int y = 0; y < maze.height(); ++y)
    for (int x = 0; x < maze.width(); ++x)
      for (const Side side : {Side::north, Side::east}) {
        const Cell c{x, y}, other = ahead(c, side);
        if (!maze.contains(other) || (task.in_goal(c) && task.in_goal(other))) continue;
        Example e{Vector::Zero(), maze.wall(c, side)};
        maze.set_wall(c, side, true);
        count(maze, c, side, 1, e.with_minus_without);
        maze.set_wall(c, side, false);
        count(maze, c, side, -1, e.with_minus_without);
        maze.set_wall(c, side, e.stands);
        examples.push_back(e);
      }
}

double chance(const Example& e, const Vector& factors) {
  return 1 / (1 + std::exp(-factors.dot(e.with_minus_without)));
}

/// Logistic regression with ridge 1, by Newton's method.
Vector fitted(const std::vector<Example>& examples) {
  Vector factors = Vector::Zero();
  for (int round = 0; round < 30; ++round) {
    Vector slope = -factors;
    Matrix curvature = Matrix::Identity();
    for (const Example& e : examples) {
      const double p = chance(e, factors);
      slope += (e.stands ? 1 - p : -p) * e.with_minus_without;
      curvature += p * (1 - p) * e.with_minus_without * e.with_minus_without.transpose();
    }
    factors += curvature.ldlt().solve(slope);
  }
  return factors;
}

}  // namespace

int main() {
  std::vector<Example> examples;
  for (std::uint64_t seed = 9000; seed < 9090; ++seed) {
    const int n = 12 + 2 * static_cast<int>(seed % 3);
    GridMaze maze = generate_backtracker(n, n, seed);
    open_walls(maze, 1 - kContestWalls * 2 * n / (n - 1.0), seed);
    open_centre_room(maze);
    add_examples(maze, examples);
  }
  constexpr std::array<ContestShape, 3> kShapes{{{12, 17}, {14, 22}, {16, 25}}};
  int made = 0;
  for (std::uint64_t seed = 1; made < 60; ++seed)
    if (const auto maze = contest_maze(kShapes[static_cast<std::size_t>(made) % 3], seed))
      add_examples(*maze, examples), ++made;
  const Vector factors = fitted(examples);
  double nats = 0;
  for (const Example& e : examples) {
    const double p = chance(e, factors);
    nats -= std::log(e.stands ? p : 1 - p);
  }
  std::printf("%zu walls, %.3f nats a wall\n", examples.size(), nats / static_cast<double>(examples.size()));
  const auto row = [&](const char* what, int first, int n) {
    std::printf("%-8s", what);
    for (int i = first; i < first + n; ++i) std::printf(" %6.2f", factors[i]);
    std::printf("\n");
  };
  row("posts", kPosts, 6);
  row("cells", kCells, 6);
  row("border", kBorder, 1);
  row("wall", kWall, 1);
}
