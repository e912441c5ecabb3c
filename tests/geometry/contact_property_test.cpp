// The exact contact rules against pixels: a path of a robot that is thin, but not vanishing, on a fine raster.
#include <algorithm>
#include <cmath>
#include <deque>
#include <set>
#include <tuple>
#include <utility>

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "support/constraint_walk.h"

namespace taut {
namespace {

using test::Constraints;
using test::wall;

constexpr int kCells = 3;                              // a scene is kCells x kCells unit cells
constexpr int kPixels = 32;                            // a unit
constexpr double kTube = 4;                            // pixels that the robot may be off the path
enum Cell { free_cell, solid_cell, rising, falling };  // the last two hold a diagonal wall

struct Scene {
  std::vector<int> cells, upright, flat;  // walls on the sides where two free cells meet

  int cell(int x, int y) const {
    return x < 0 || y < 0 || x >= kCells || y >= kCells ? static_cast<int>(free_cell) : cells[y * kCells + x];
  }
  bool solid(int x, int y) const { return cell(x, y) == solid_cell; }
};

Point at(int x, int y) { return {double(x), double(y)}; }

void add_side(Constraints& to, Point a, Point b, bool solid_left, bool solid_right, bool walled) {
  if (solid_left != solid_right || (walled && !solid_left)) to.push_back({a, b, solid_left, solid_right, kNone});
}

Constraints constraints_of(const Scene& scene) {
  Constraints result;
  for (int y = 0; y <= kCells; ++y)
    for (int x = 0; x <= kCells; ++x) {
      const int i = y * (kCells + 1) + x;
      if (y < kCells)
        add_side(result, at(x, y), at(x, y + 1), scene.solid(x - 1, y), scene.solid(x, y), scene.upright[i]);
      if (x < kCells) add_side(result, at(x + 1, y), at(x, y), scene.solid(x, y - 1), scene.solid(x, y), scene.flat[i]);
      if (scene.cell(x, y) == rising) result.push_back(wall(at(x, y), at(x + 1, y + 1)));
      if (scene.cell(x, y) == falling) result.push_back(wall(at(x, y + 1), at(x + 1, y)));
    }
  return result;
}

/// Whole range at once: RapidCheck starts with small values, and small paths show nothing.
int any(int first, int last) { return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(first, last + 1)); }

Scene any_scene() {
  const auto one_in = [](std::size_t n) {
    return rc::gen::container<std::vector<int>>((kCells + 1) * (kCells + 1),
                                                rc::gen::weightedElement<int>({{n - 1, 0}, {1, 1}}));
  };
  Scene scene;
  scene.cells = *rc::gen::container<std::vector<int>>(
      kCells * kCells, rc::gen::weightedElement<int>({{4, free_cell}, {2, solid_cell}, {1, rising}, {1, falling}}));
  const auto sparseness = static_cast<std::size_t>(any(2, 4));
  scene.upright = *one_in(sparseness);
  scene.flat = *one_in(sparseness);
  return scene;
}

/// A path of legs that cross no piece (but may slip through anything), in directions that keep well apart: multiples of
/// (1, 0), (1, 1), (2, 1) and their mirror images between half-integer points, so that a thin tube around a leg meets
/// only what it touches.
std::vector<Point> any_path(const Constraints& constraints) {
  const std::vector<std::pair<int, int>> directions{{1, 0}, {0, 1}, {1, 1}, {1, -1}, {2, 1}, {2, -1}, {1, 2}, {1, -2}};
  const double side = kCells;
  std::vector<Point> path{{any(0, 2 * kCells) / 2.0, any(0, 2 * kCells) / 2.0}};
  for (int tries = any(1, 12); tries > 0; --tries) {
    const auto [dx, dy] = directions[static_cast<std::size_t>(any(0, 7))];
    const double times = any(-4, 4) / 2.0;
    const Point p{path.back().x + dx * times, path.back().y + dy * times};
    if (Box{{0, 0}, {side, side}}.contains(p) && test::touched({path.back(), p}, constraints)) path.push_back(p);
  }
  return path;
}

double distance(double x, double y, Point a, Point b) {
  const double ux = b.x - a.x, uy = b.y - a.y, squared = ux * ux + uy * uy;
  const double t = squared > 0 ? std::clamp(((x - a.x) * ux + (y - a.y) * uy) / squared, 0.0, 1.0) : 0.0;
  return std::hypot(x - a.x - t * ux, y - a.y - t * uy);
}

/// Pixel (x, y) stands for the point (x, y) / kPixels; around the scene is a free margin.
class Raster {
 public:
  explicit Raster(const Scene& scene) : constraints_(constraints_of(scene)), open_(kWidth * kWidth) {
    for (int y = kLow; y <= kHigh; ++y)
      for (int x = kLow; x <= kHigh; ++x) open_[index(x, y)] = free(scene, x, y);
  }

  bool open(int x, int y) const { return x >= kLow && y >= kLow && x <= kHigh && y <= kHigh && open_[index(x, y)]; }
  static bool near(int x, int y, Point a, Point b) {
    return distance(double(x) / kPixels, double(y) / kPixels, a, b) * kPixels <= kTube;
  }

 private:
  static constexpr int kLow = -8, kHigh = kCells * kPixels + 8, kWidth = kHigh - kLow + 1;
  static std::size_t index(int x, int y) { return static_cast<std::size_t>((y - kLow) * kWidth + x - kLow); }

  bool free(const Scene& scene, int x, int y) const {
    const auto cell = [](int v) { return v < 0 ? -1 : v / kPixels; };
    if (scene.solid(cell(x), cell(y))) return false;
    const double px = double(x) / kPixels, py = double(y) / kPixels;
    return std::none_of(constraints_.begin(), constraints_.end(),
                        [&](const Constraint& c) { return distance(px, py, c.a, c.b) * kPixels < 0.1; });
  }

  Constraints constraints_;
  std::vector<char> open_;
};

/// Breadth first through (leg, pixel): pixels within the leg's tube, from one leg to the next near the bend.
bool pixels_connect(const Raster& raster, const std::vector<Point>& path) {
  using Place = std::tuple<std::size_t, int, int>;
  std::set<Place> seen;
  std::deque<Place> queue;
  const auto reach = [&](std::size_t leg, int x, int y) {
    if (raster.open(x, y) && Raster::near(x, y, path[leg], path[leg + 1]) && seen.insert({leg, x, y}).second)
      queue.emplace_back(leg, x, y);
  };
  for (int dx = -4; dx <= 4; ++dx)
    for (int dy = -4; dy <= 4; ++dy) {
      const int x = static_cast<int>(path[0].x * kPixels) + dx, y = static_cast<int>(path[0].y * kPixels) + dy;
      if (Raster::near(x, y, path[0], path[0])) reach(0, x, y);
    }
  while (!queue.empty()) {
    const auto [leg, x, y] = queue.front();
    queue.pop_front();
    if (Raster::near(x, y, path[leg + 1], path[leg + 1])) {
      if (leg + 2 == path.size()) return true;
      reach(leg + 1, x, y);
    }
    for (const auto& [dx, dy] : {std::pair(1, 0), std::pair(-1, 0), std::pair(0, 1), std::pair(0, -1)})
      reach(leg, x + dx, y + dy);
  }
  return false;
}

void show(const Constraints& constraints, const std::vector<Point>& path) {
  for (const Constraint& c : constraints)
    RC_LOG() << "constraint (" << c.a.x << ", " << c.a.y << ") (" << c.b.x << ", " << c.b.y << ") " << c.solid_left
             << c.solid_right << '\n';
  for (const Point p : path) RC_LOG() << "path (" << p.x << ", " << p.y << ")\n";
}

/// Calls f(constraints, path) for several paths among the same constraints.
template <class F>
void for_paths_among(const Constraints& c, F f) {
  for (int i = 0; i < 20; ++i) {
    const auto path = any_path(c);
    if (path.size() > 1) f(path);
  }
}

RC_GTEST_PROP(PathAmongConstraints, FollowsWhatPixelsFollow, ()) {
  const Scene scene = any_scene();
  const Constraints c = constraints_of(scene);
  const Raster raster(scene);
  for_paths_among(c, [&](const std::vector<Point>& path) {
    // In the middle of a solid no constraint tells where the path is.
    const Point start = path[0];
    if (test::star(start, c).rays().empty() && !raster.open(int(start.x * kPixels), int(start.y * kPixels))) return;
    const bool follows = test::follows(path, c);
    if (follows == pixels_connect(raster, path)) return;
    show(c, path);
    RC_FAIL(follows ? "the pixels do not connect" : "the pixels connect");
  });
}

RC_GTEST_PROP(PathAmongConstraints, MayBeWalkedBackwards, ()) {
  const Constraints c = constraints_of(any_scene());
  for_paths_among(c, [&](const std::vector<Point>& path) {
    RC_ASSERT(test::follows(path, c) == test::follows({path.rbegin(), path.rend()}, c));
  });
}

Point middle(Point a, Point b) { return {(a.x + b.x) / 2, (a.y + b.y) / 2}; }

Constraints halved(const Constraints& constraints) {
  Constraints result;
  for (const Constraint& c : constraints) {
    result.push_back({c.a, middle(c.a, c.b), c.solid_left, c.solid_right, kNone});
    result.push_back({c.b, middle(c.a, c.b), c.solid_right, c.solid_left, kNone});
  }
  return result;
}

RC_GTEST_PROP(PathAmongConstraints, DoesNotDependOnHowLegsAndPiecesAreDivided, ()) {
  const Constraints c = constraints_of(any_scene()), halves = halved(c);
  for_paths_among(c, [&](const std::vector<Point>& path) {
    std::vector<Point> refined{path[0]};
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
      refined.push_back(middle(path[i], path[i + 1]));
      refined.push_back(path[i + 1]);
    }
    const bool follows = test::follows(path, c);
    RC_ASSERT(follows == test::follows(refined, c));
    RC_ASSERT(follows == test::follows(path, halves));
    RC_ASSERT(follows == test::follows(refined, halves));
  });
}

RC_GTEST_PROP(PathAmongConstraints, IsTheSameAfterAQuarterTurn, ()) {
  const Constraints c = constraints_of(any_scene());
  const auto turned = [](Point p) { return Point{-p.y, p.x}; };
  Constraints turned_c = c;
  for (Constraint& piece : turned_c) piece.a = turned(piece.a), piece.b = turned(piece.b);
  for_paths_among(c, [&](std::vector<Point> path) {
    const bool follows = test::follows(path, c);
    for (Point& p : path) p = turned(p);
    RC_ASSERT(follows == test::follows(path, turned_c));
  });
}

RC_GTEST_PROP(PathAmongConstraints, StaysOpenWhenAWallIsTakenAway, ()) {
  Constraints c = constraints_of(any_scene());
  for_paths_among(c, [&](const std::vector<Point>& path) {
    if (!test::follows(path, c)) return;
    for (std::size_t i = 0; i < c.size(); ++i) {
      if (!c[i].is_wall()) continue;
      const Constraint taken = c[i];
      c.erase(c.begin() + static_cast<std::ptrdiff_t>(i));
      RC_ASSERT(test::follows(path, c));
      c.insert(c.begin() + static_cast<std::ptrdiff_t>(i), taken);
    }
  });
}

}  // namespace
}  // namespace taut
