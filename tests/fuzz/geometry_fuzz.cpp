// Small worlds full of coincidences, in whole numbers and decimals: all planners agree, both ways, their paths are paths, and where the
// walls are thin so says an exact arrangement that shares no code with them.
#include <cmath>

#include <fmt/format.h>

#include <taut/roadmaps/visibility_graph.h>
#include <taut/search/polyanya.h>
#include <taut/search/shortest_path.h>
#include <taut/search/verify.h>

#include "fuzz/fuzzed.h"
#include "support/exact_arrangement.h"
#include "support/small_world.h"

namespace {

using namespace taut;

/// A world on a lattice, and two places on it.
struct Drawn {
  test::SmallWorld world;
  Point from, to;
  int unit = 1;  ///< so many lattice steps are 1
  int side = 0;  ///< steps
  bool thin = true;
  bool asks_arrangement = true;
};

/// Beyond so many walls the arrangement, which takes ten times as long as all else, is asked in one world of so many.
constexpr std::size_t kFewWalls = 2;
constexpr int kArrangementEvery = 16;

Point lattice_point(FuzzedDataProvider& bytes, const Drawn& drawn) {
  const int x = bytes.ConsumeIntegralInRange(0, drawn.side), y = bytes.ConsumeIntegralInRange(0, drawn.side);
  return {double(x) / drawn.unit, double(y) / drawn.unit};
}

Drawn draw(FuzzedDataProvider& bytes) {
  Drawn drawn;
  constexpr int kUnits[] = {1, 1, 2, 10, 100, 3};
  drawn.unit = bytes.PickValueInArray(kUnits);
  drawn.side = bytes.ConsumeIntegralInRange(2, 12);
  const double side = double(drawn.side) / drawn.unit;
  drawn.world.area = test::box_ring(0, 0, side, side);
  drawn.from = lattice_point(bytes, drawn);
  drawn.to = lattice_point(bytes, drawn);
  const bool is_straight = bytes.ConsumeBool();
  drawn.asks_arrangement = bytes.ConsumeIntegralInRange(1, kArrangementEvery) == 1;
  while (bytes.remaining_bytes() > 4 && drawn.world.walls.size() < 10) {
    const bool is_solid = bytes.ConsumeIntegralInRange(0, 5) == 0;
    const Point a = lattice_point(bytes, drawn);
    Point b = lattice_point(bytes, drawn);
    if (is_solid && a.x < b.x && a.y < b.y) {
      drawn.world.solids.push_back(test::box_ring(a.x, a.y, b.x, b.y));
      drawn.thin = false;
    } else {
      if (is_straight) (bytes.ConsumeBool() ? b.x : b.y) = a.x;
      if (is_straight && a.x != b.x) b.y = a.y;
      drawn.world.walls.push_back({a, b});
    }
  }
  return drawn;
}

std::string words(const Drawn& drawn) {
  std::string text = fmt::format("boundary 0 0 {} {}\nstart {} {}\ngoal {} {}\n", drawn.world.area[2].x,
                                 drawn.world.area[2].y, drawn.from.x, drawn.from.y, drawn.to.x, drawn.to.y);
  for (const Segment& wall : drawn.world.walls)
    text += fmt::format("{} {} {} {}\n", wall.a.x, wall.a.y, wall.b.x, wall.b.y);
  for (const Ring& ring : drawn.world.solids)
    text += fmt::format("solid {} {} {} {}\n", ring[0].x, ring[0].y, ring[2].x, ring[2].y);
  return text;
}

mpq_class rational(double v, int unit) { return mpq_class(std::lround(v * unit)) / unit; }

test::RationalPoint rational(Point p, int unit) { return {rational(p.x, unit), rational(p.y, unit)}; }

std::optional<double> by_arrangement(const Drawn& drawn) {
  std::vector<test::RationalWall> walls;
  for (const Segment& wall : drawn.world.walls)
    walls.push_back({rational(wall.a, drawn.unit), rational(wall.b, drawn.unit)});
  const mpq_class side = mpq_class(drawn.side) / drawn.unit;
  return arrangement_path(side, side, walls, rational(drawn.from, drawn.unit), rational(drawn.to, drawn.unit));
}

bool agree(std::optional<double> a, std::optional<double> b) {
  return a.has_value() == b.has_value() && (!a || std::abs(*a - *b) <= 1e-9 * std::max(1.0, *a));
}

std::string told(std::optional<double> length) { return length ? fmt::format("{}", *length) : "none"; }

std::optional<double> length_of(const FreeSpace& space, const std::optional<Path>& path, Point from, Point to,
                                const Drawn& drawn) {
  if (!path) return std::nullopt;
  const Verdict verdict = verify(*path, space, from, Goal{to, {}});
  fuzz::require(verdict.valid, "a path that is none: " + verdict.reason + "\n" + words(drawn));
  return path->length.value();
}

void compare(const Drawn& drawn) {
  const std::array places{drawn.from, drawn.to};
  const FreeSpace space(World(drawn.world.parts()), Footprint::point(), places);
  const bool are_places = space.locate(drawn.from).kind != Location::Kind::outside &&
                          space.locate(drawn.to).kind != Location::Kind::outside;
  if (!are_places) return;
  const auto ahead = length_of(space, shortest_path(space, drawn.from, drawn.to), drawn.from, drawn.to, drawn);
  const auto back = length_of(space, shortest_path(space, drawn.to, drawn.from), drawn.to, drawn.from, drawn);
  fuzz::require(agree(ahead, back), "there " + told(ahead) + ", back " + told(back) + "\n" + words(drawn));
  const GraphSearchResult found = shortest_path(VisibilityGraph(space), drawn.from, Goal{drawn.to, {}});
  const auto in_graph = found.status == SearchStatus::found ? std::optional(found.path) : std::nullopt;
  const auto graph = length_of(space, in_graph, drawn.from, drawn.to, drawn);
  fuzz::require(agree(ahead, graph),
                "Polyanya " + told(ahead) + ", visibility graph " + told(graph) + "\n" + words(drawn));
  // Thirds are no decimals: what is written is not what is meant there.
  if (!drawn.thin || drawn.unit == 3 || drawn.world.walls.size() > 6) return;
  if (drawn.world.walls.size() > kFewWalls && !drawn.asks_arrangement) return;
  const auto exact = by_arrangement(drawn);
  fuzz::require(agree(ahead, exact),
                "Polyanya " + told(ahead) + ", exact arrangement " + told(exact) + "\n" + words(drawn));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  FuzzedDataProvider bytes(data, size);
  const Drawn drawn = draw(bytes);
  fuzz::read([&] { compare(drawn); });
  return 0;
}
