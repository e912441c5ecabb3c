// The Voronoi diagram and the gates share nothing but predicates: they have to say the same about every disc. In walled
// worlds, for what is an opening to the gates is a wall to the diagram.
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include <taut/geometry/maze_generator.h>
#include <taut/roadmaps/cell_graph.h>
#include <taut/roadmaps/visibility_graph.h>
#include <taut/search/cell_search.h>
#include <taut/search/clearance_search.h>
#include <taut/search/disc_passage.h>
#include <taut/search/prm_planner.h>
#include <taut/search/shortest_path.h>
#include <taut/search/verify.h>
#include <taut/search/voronoi_search.h>

#include "support/random_world.h"
#include "support/small_world.h"

namespace taut {
namespace {

using test::SmallWorld;

/// What is said of every disc, between two points.
class Both {
 public:
  Both(const FreeSpace& space, Point s, Point g)
      : gates_(space), s_(s), g_(g), query_(VoronoiRoadmap(space), s, g), widest_(query_.widest()) {}

  /// Empty when diagram and gates agree about the widest disc.
  std::string fault_of_widest(double slack) const {
    const auto other = widest_passage(gates_, s_, g_);
    if (bool(widest_) != bool(other)) return "only one finds a way";
    if (!widest_) return {};
    const Pinch& pinch = widest_->pinch;
    if ((other->limit == WidestPassage::Limit::gate) && pinch.where != Pinch::Where::gate) return "an end, not a gate";
    if (std::abs(pinch.clearance - other->radius) <= slack * other->radius) return {};
    // One is the nearest double, the other the largest that passes.
    if (pinch.clearance != other->radius && pinch.clearance != std::nextafter(other->radius, HUGE_VAL))
      return fmt::format("{} against {}", pinch.clearance, other->radius);
    return {};
  }

  bool diagram_passes(double r) const { return query_.shortest(r).has_value(); }
  bool gates_pass(double r) const { return disc_passage(gates_, s_, g_, r).status == DiscStatus::found; }

  /// Radii below, at and above half of each gate's width; with slack only below and above.
  std::vector<double> critical_radii(double slack) const {
    std::vector<double> radii;
    for (const Gate& gate : gates_.gates()) {
      const double half = gate.width / 2;
      if (slack > 0)
        radii.insert(radii.end(), {half * (1 - slack), half * (1 + slack)});
      else
        radii.insert(radii.end(), {std::nextafter(half, 0.0), half, std::nextafter(half, 99.0)});
    }
    return radii;
  }

 private:
  Gates gates_;
  Point s_, g_;
  ClearanceSearch query_;
  std::optional<ClearancePath> widest_;
};

/// Exactly, or but for a slack in proportion.
void expect_agreement(const FreeSpace& space, Point s, Point g, double slack = 0) {
  if (space.locate(s).kind == Location::Kind::outside || space.locate(g).kind == Location::Kind::outside) return;
  const Both both(space, s, g);
  RC_LOG(fmt::format(" s {} g {}\n", test::show(s), test::show(g)));
  RC_ASSERT(both.fault_of_widest(slack) == std::string());
  for (const double r : both.critical_radii(slack)) {
    RC_LOG(fmt::format(" r {:a}\n", r));
    RC_ASSERT(both.diagram_passes(r) == both.gates_pass(r));
  }
}

RC_GTEST_PROP(ClearanceAgreement, OfDiagramAndGatesInMessyWorlds, ()) {
  const SmallWorld small = test::any_world({.side = 6, .walls = 7, .solids = 2, .straight = test::any(0, 1) == 1});
  RC_LOG(test::show(small));
  const FreeSpace space(small.bounded(Boundary::walled));
  for (int n = 0; n < 3; ++n) expect_agreement(space, test::any_fine_point(6), test::any_fine_point(6));
}

/// Slanting bars have corners that were rounded, and a foot as near to an edge's end as that counts as on it
/// (VoronoiRoadmap, guarantee 4).
RC_GTEST_PROP(ClearanceAgreement, OfDiagramAndGatesWithThickWalls, ()) {
  const bool straight = test::any(0, 1) == 1;
  const SmallWorld small =
      test::any_world({.side = 6, .walls = 6, .solids = 2, .thickness = 0.3125, .straight = straight});
  RC_LOG(test::show(small));
  const FreeSpace space(small.bounded(Boundary::walled));
  for (int n = 0; n < 2; ++n)
    expect_agreement(space, test::any_fine_point(6), test::any_fine_point(6), straight ? 0 : 1e-12);
}

RC_GTEST_PROP(ClearanceAgreement, OfDiagramAndGatesInMazes, ()) {
  const int cells = test::any(2, 6), seed = test::any(0, 1 << 20);
  auto maze = std::make_shared<GridMaze>(generate_backtracker(cells, cells, seed));
  open_walls(*maze, test::any(0, 8) / 10.0, seed);
  auto world = world_of(maze).with_wall_thickness(test::any(0, 1) / 8.0);
  expect_agreement(FreeSpace(std::move(world)), test::any_fine_point(cells), test::any_fine_point(cells));
}

/// The widest way through points of a grid and the straight steps between neighbours, by a flood in the order of
/// clearance.
double widest_on_grid(const FreeSpace& space, Point s, Point g, int side, int steps) {
  const double step = double(side) / steps;
  const int row = steps + 1;
  std::vector<double> room(std::size_t(row) * row, -1);
  std::vector<std::uint32_t> part(room.size(), kNone);
  for (int y = 0; y < row; ++y)
    for (int x = 0; x < row; ++x) {
      const Point p{x * step, y * step};
      const Location at = space.locate(p);
      if (at.kind == Location::Kind::triangle) room[std::size_t(y) * row + x] = space.clearance(p).distance;
    }
  const auto node = [&](Point p) { return int(std::lround(p.y / step)) * row + int(std::lround(p.x / step)); };
  std::vector<double> best(room.size(), -1);
  std::vector<std::pair<double, int>> open{{room[node(s)], node(s)}};
  while (!open.empty()) {
    std::pop_heap(open.begin(), open.end());
    const auto [width, at] = open.back();
    open.pop_back();
    if (best[at] >= 0 || width < 0) continue;
    best[at] = width;
    if (at == node(g)) return width;
    const int x = at % row, y = at / row;
    for (const auto& [dx, dy] : {std::pair(1, 0), {-1, 0}, {0, 1}, {0, -1}}) {
      if (x + dx < 0 || x + dx > steps || y + dy < 0 || y + dy > steps) continue;
      const int next = at + dy * row + dx;
      // Wide enough at both ends, the step crosses no wall.
      if (room[next] > step / 2 && room[at] > step / 2) {
        open.push_back({std::min(width, room[next]), next});
        std::push_heap(open.begin(), open.end());
      }
    }
  }
  return 0;
}

RC_GTEST_PROP(ClearanceAgreement, OfTheWidestWayAndAGrid, ()) {
  const SmallWorld small = test::any_world({.side = 4, .walls = 5, .solids = 1});
  RC_LOG(test::show(small));
  const FreeSpace space(small.bounded(Boundary::walled));
  const int steps = 64;
  const double step = 4.0 / steps;
  const auto node = [&] { return Point{test::any(1, steps - 1) * step, test::any(1, steps - 1) * step}; };
  const Point s = node(), g = node();
  for (const Point p : {s, g}) RC_PRE(space.locate(p).kind == Location::Kind::triangle);
  const auto widest = ClearanceSearch(VoronoiRoadmap(space), s, g).widest();
  const double on_grid = widest_on_grid(space, s, g, 4, steps);
  // Along a step clearance falls by at most half of it; any way can be followed over nodes within 0.71 steps of it.
  if (!widest) return RC_ASSERT(on_grid == 0);
  RC_ASSERT(widest->pinch.clearance >= on_grid - 0.5 * step - 1e-9);
  if (widest->pinch.clearance > 1.5 * step) RC_ASSERT(on_grid >= widest->pinch.clearance - 0.72 * step - 1e-9);
}

/// No planner's path keeps farther away from the walls than the widest.
void expect_nothing_wider(const FreeSpace& space, Point s, Point g, const GraphSearchResult& other) {
  if (other.status != SearchStatus::found) return;
  const auto widest = ClearanceSearch(VoronoiRoadmap(space), s, g).widest();
  RC_ASSERT(widest);
  const Verdict verdict = verify(other.path, space, s, Goal{g, {}});
  RC_ASSERT(verdict.valid);
  RC_ASSERT(verdict.clearance <= widest->pinch.clearance * (1 + 1e-12));
}

RC_GTEST_PROP(ClearanceAgreement, NoOtherRoadmapHasAWiderPath, ()) {
  const int cells = test::any(2, 6), seed = test::any(0, 1 << 20);
  auto maze = std::make_shared<GridMaze>(generate_backtracker(cells, cells, seed));
  open_walls(*maze, test::any(0, 8) / 10.0, seed);
  const FreeSpace space(world_of(maze));
  const auto middle = [&] { return Point{test::any(0, cells - 1) + 0.5, test::any(0, cells - 1) + 0.5}; };
  const Point s = middle(), g = middle();
  const Goal goal{g, {}};
  expect_nothing_wider(space, s, g, shortest_path(VisibilityGraph(space), s, goal));
  expect_nothing_wider(space, s, g, cell_search(CellGraph(space, CellNeighbours::eight), s, goal));
  PrmPlan plan;
  plan.roadmap.connection.rule = PrmConnection::Rule::visible;
  const Roadmap milestones = prm_path(space, s, goal, plan).roadmap;
  expect_nothing_wider(space, s, g, graph_search(milestones, prm_query(space, milestones, s, goal, 0)));
}

/// As legs the way along the diagram is a path like any other: valid, and no longer than its arcs.
RC_GTEST_PROP(VoronoiSearch, GivesPathsThatAreValid, ()) {
  const SmallWorld small = test::any_world({.side = 6, .walls = 7, .solids = 2});
  RC_LOG(test::show(small));
  const FreeSpace space = small.space();
  const VoronoiRoadmap map(space);
  for (int n = 0; n < 3; ++n) {
    const bool on_lattice = test::any(0, 2) == 0;  // at walls, ends and corners
    const Point s = on_lattice ? test::any_lattice_point(6) : test::any_fine_point(6), g = test::any_fine_point(6);
    if (space.locate(s).kind == Location::Kind::outside || space.locate(g).kind == Location::Kind::outside) continue;
    RC_LOG(fmt::format(" s {} g {}\n", test::show(s), test::show(g)));
    const auto arcs = ClearanceSearch(map, s, g).shortest(0);
    const GraphSearchResult legs = voronoi_search(map, s, Goal{g, {}}, 1e-3);
    RC_ASSERT((legs.status == SearchStatus::found) == arcs.has_value());
    if (!arcs) continue;
    const Verdict verdict = verify(legs.path, space, s, Goal{g, {}});
    if (!verdict.valid) RC_FAIL(verdict.reason);
    RC_ASSERT(legs.path.length.value() <= arcs->length * (1 + 1e-9) + 1e-12);
    RC_ASSERT(legs.path.length.value() >= 0.99 * arcs->length);
    RC_ASSERT(verdict.clearance >= arcs->pinch.clearance - 1e-3 - 1e-12);
  }
}

TEST(VoronoiSearch, EndsWhereItFirstEntersTheRoom) {
  // Two rooms with a door from (10, 4) to (10, 6); the goal is the right one.
  auto parts =
      SmallWorld{.walls = {{{10, 0}, {10, 4}}, {{10, 6}, {10, 10}}}, .solids = {}, .area = test::box_ring(0, 0, 20, 10)}
          .parts();
  parts.goal.room = {{{10, 0}, {20, 10}}};
  const FreeSpace space{World(parts)};
  const GraphSearchResult found = voronoi_search(VoronoiRoadmap(space), {3, 5}, space.world().goal(), 1e-3);
  ASSERT_EQ(found.status, SearchStatus::found);
  EXPECT_EQ(found.path.points.back(), (Point{10, 5}));
  EXPECT_TRUE(verify(found.path, space, {3, 5}, space.world().goal()).valid);
}

}  // namespace
}  // namespace taut
