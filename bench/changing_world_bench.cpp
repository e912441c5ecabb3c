// Walls that come and go on a prepared world of cells: a change alone, a query after each change, and the same from
// scratch. The grid map is 514 x 514 cells: corridors 8 wide, a fifth of the walls opened; a change closes or opens a
// corridor from side to side. The maze of thin walls is 57 x 57. Before anything is timed each way gives equally long
// paths.
#include <benchmark/benchmark.h>

#include <cstdlib>
#include <vector>

#include <taut/geometry/draws.h>
#include <taut/search/changing_world.h>
#include <taut/search/polyanya.h>

#include "mazes.h"

namespace taut::bench {
namespace {

constexpr int kCells = 57, kSide = 9 * kCells + 1;

/// Across corridors of the map, or sides of cells of the maze.
std::vector<Segment> doors(bool is_map) {
  Draws draws(1);
  std::vector<Segment> all;
  for (int i = 0; i < 1000; ++i) {
    const double a = 1 + draws.below(kCells - 2), b = 1 + draws.below(kCells - 2);
    const Segment s = is_map ? Segment{{9 * a + 5, 9 * b + 1}, {9 * a + 5, 9 * b + 9}} : Segment{{a, b}, {a, b + 1}};
    all.push_back(draws.below(2) == 0 ? s : Segment{{s.a.y, s.a.x}, {s.b.y, s.b.x}});
  }
  return all;
}

std::vector<Point> ends(bool is_map) {
  Draws draws(2);
  std::vector<Point> all;
  for (int i = 0; i < 1000; ++i) {
    const double a = draws.below(kCells), b = draws.below(kCells);
    all.push_back(is_map ? Point{9 * a + 2.5, 9 * b + 4.5} : Point{a + 0.25, b + 0.5});
  }
  return all;
}

/// Walls come until 500 stand, then the oldest goes for each that comes.
class Doors {
 public:
  Doors(const FreeSpace& space, bool is_map) : world(space), doors_(doors(is_map)) {
    while (next_ < 500) change();
  }

  void change() {
    if (next_ % 2 == 1 && next_ > 500)
      world.remove(doors_[(next_ - 500) / 2 % doors_.size()]);
    else
      world.add({doors_[next_ / 2 % doors_.size()].a, doors_[next_ / 2 % doors_.size()].b});
    ++next_;
  }

  ChangingWorld world;

 private:
  std::vector<Segment> doors_;
  std::size_t next_ = 0;
};

FreeSpace space(bool is_map) {
  return FreeSpace(is_map ? opened_block_maze(kCells, 8, 0.2) : opened_maze(kCells, 0.2));
}

void require_same(const FreeSpace& at_first, bool is_map) {
  Doors doors(at_first, is_map);
  const std::vector<Point> all = ends(is_map);
  for (std::size_t i = 0; i + 1 < 20; i += 2) {
    doors.change();
    const auto expected = shortest_path(Polyanya(doors.world.space()), all[i], {all[i + 1], {}});
    if (doors.world.find(all[i], all[i + 1]) != expected.status ||
        (expected.status == SearchStatus::found && Length(doors.world.points()) != expected.path.length))
      std::abort();
  }
}

void change(benchmark::State& state) {
  const FreeSpace at_first = space(state.range(0) != 0);
  require_same(at_first, state.range(0) != 0);
  Doors doors(at_first, state.range(0) != 0);
  for (auto _ : state) doors.change();
}
BENCHMARK(change)->ArgName("map")->Arg(1)->Arg(0);

void query_after_change(benchmark::State& state) {
  Doors doors(space(state.range(0) != 0), state.range(0) != 0);
  const std::vector<Point> all = ends(state.range(0) != 0);
  std::size_t i = 0;
  for (auto _ : state) {
    doors.change();
    benchmark::DoNotOptimize(doors.world.find(all[i], all[i + 1]));
    i = (i + 2) % all.size();
  }
}
BENCHMARK(query_after_change)->ArgName("map")->Arg(1)->Arg(0)->Unit(benchmark::kMicrosecond);

void query_only(benchmark::State& state) {
  Doors doors(space(state.range(0) != 0), state.range(0) != 0);
  const std::vector<Point> all = ends(state.range(0) != 0);
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(doors.world.find(all[i], all[i + 1]));
    i = (i + 2) % all.size();
  }
}
BENCHMARK(query_only)->ArgName("map")->Arg(1)->Arg(0)->Unit(benchmark::kMicrosecond);

void from_scratch(benchmark::State& state) {
  Doors doors(space(state.range(0) != 0), state.range(0) != 0);
  const std::vector<Point> all = ends(state.range(0) != 0);
  std::size_t i = 0;
  for (auto _ : state) {
    doors.change();
    PolyanyaSearch search{Polyanya(doors.world.space())};
    benchmark::DoNotOptimize(search.find(all[i], all[i + 1]));
    i = (i + 2) % all.size();
  }
}
BENCHMARK(from_scratch)->ArgName("map")->Arg(1)->Arg(0)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace taut::bench
