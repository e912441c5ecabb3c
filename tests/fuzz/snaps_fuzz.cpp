// Walls that nearly touch, joined: nothing moves farther than the tolerance, nothing is lost and nothing comes from nowhere, twice gives
// the same, and in what comes out the shortest paths there and back agree.
#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include <taut/geometry/segment_distance.h>
#include <taut/geometry/snap.h>
#include <taut/search/shortest_path.h>
#include <taut/search/verify.h>

#include "fuzz/fuzzed.h"
#include "support/small_world.h"

namespace {

using namespace taut;

constexpr double kSide = 10, kStep = 0.0005;

struct Drawn {
  test::SmallWorld world;
  Point from, to;
  double tolerance = 0;
};

/// A whole number, often but for a few steps.
double nearly_whole(FuzzedDataProvider& bytes) {
  const double v = bytes.ConsumeIntegralInRange(0, 10);
  const int steps = std::max(0, bytes.ConsumeIntegralInRange(-5, 5));
  return std::min(kSide, v + steps * kStep);
}

Point nearly_on_lattice(FuzzedDataProvider& bytes) {
  const double x = nearly_whole(bytes), y = nearly_whole(bytes);
  return {x, y};
}

Drawn draw(FuzzedDataProvider& bytes) {
  Drawn drawn;
  constexpr double kTolerances[] = {0.0004, 0.0005, 0.001, 0.0025, 0.01};
  drawn.tolerance = bytes.PickValueInArray(kTolerances);
  drawn.world.area = test::box_ring(0, 0, kSide, kSide);
  drawn.from = {bytes.ConsumeIntegralInRange(0, 9) + 0.5, bytes.ConsumeIntegralInRange(0, 9) + 0.25};
  drawn.to = {bytes.ConsumeIntegralInRange(0, 9) + 0.25, bytes.ConsumeIntegralInRange(0, 9) + 0.5};
  while (bytes.remaining_bytes() > 4 && drawn.world.walls.size() < 10) {
    const Point a = nearly_on_lattice(bytes), b = nearly_on_lattice(bytes);
    if (a != b) drawn.world.walls.push_back({a, b});  // a point hinders nobody, and is dropped
  }
  return drawn;
}

std::string words(const Drawn& drawn) {
  std::string text = fmt::format("tolerance {}\nboundary 0 0 {} {}\nstart {} {}\ngoal {} {}\n", drawn.tolerance, kSide,
                                 kSide, drawn.from.x, drawn.from.y, drawn.to.x, drawn.to.y);
  for (const Segment& wall : drawn.world.walls)
    text += fmt::format("{} {} {} {}\n", wall.a.x, wall.a.y, wall.b.x, wall.b.y);
  return text;
}

std::vector<Segment> with_sides(std::vector<Segment> walls) {
  const Ring box = test::box_ring(0, 0, kSide, kSide);
  for (int i = 0; i < 4; ++i) walls.push_back({box[i], box[(i + 1) % 4]});
  return walls;
}

std::vector<Segment> walls_of(const World& world) {
  std::vector<Segment> result;
  for (const Wall& wall : world.walls()) result.push_back({wall.a, wall.b});
  return result;
}

/// How far the farthest end of these walls is from the nearest of those.
double farthest(const std::vector<Segment>& walls, const std::vector<Segment>& from) {
  double result = 0;
  for (const Segment& wall : walls)
    for (const Point end : {wall.a, wall.b}) {
      double nearest = HUGE_VAL;
      for (const Segment& other : from) nearest = std::min(nearest, segment_distance({end, end}, other));
      result = std::max(result, nearest);
    }
  return result;
}

void judge(const Drawn& drawn, const Snapped& joined) {
  const double limit = drawn.tolerance * (1 + 1e-12);
  fuzz::require(joined.report.displacement <= limit, "moved by more than the tolerance\n" + words(drawn));
  fuzz::require(joined.report.remaining.empty(), "something remains\n" + words(drawn));
  const std::vector<Segment> before = with_sides(drawn.world.walls), after = with_sides(walls_of(joined.world));
  fuzz::require(farthest(before, after) <= limit, "an end is lost\n" + words(drawn));
  fuzz::require(farthest(after, before) <= limit, "an end from nowhere\n" + words(drawn));
}

void judge_paths(const Drawn& drawn, const World& world) {
  const FreeSpace space(world);
  for (const Point end : {drawn.from, drawn.to})
    if (space.locate(end).kind == Location::Kind::outside) return;
  const auto ahead = shortest_path(space, drawn.from, drawn.to), back = shortest_path(space, drawn.to, drawn.from);
  fuzz::require(ahead.has_value() == back.has_value(), "one way only\n" + words(drawn));
  if (!ahead) return;
  fuzz::require(ahead->length == back->length ||
                    std::abs(ahead->length.value() - back->length.value()) <= 1e-12 * ahead->length.value(),
                fmt::format("there {}, back {}\n{}", ahead->length.value(), back->length.value(), words(drawn)));
  const Verdict verdict = verify(*ahead, space, drawn.from, Goal{drawn.to, {}});
  fuzz::require(verdict.valid, "a path that is none: " + verdict.reason + "\n" + words(drawn));
}

void snap_and_judge(const Drawn& drawn) {
  const Snap snap{Snap::What::within, drawn.tolerance};
  const std::array ends{drawn.from, drawn.to};
  const Snapped joined = snapped_world(drawn.world.parts(), snap, ends);
  const Snapped again = snapped_world(drawn.world.parts(), snap, ends);
  fuzz::require(walls_of(joined.world) == walls_of(again.world), "twice is not the same\n" + words(drawn));
  judge(drawn, joined);
  judge_paths(drawn, joined.world);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  FuzzedDataProvider bytes(data, size);
  const Drawn drawn = draw(bytes);
  fuzz::read([&] { snap_and_judge(drawn); });
  return 0;
}
