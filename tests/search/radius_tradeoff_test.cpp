#include <taut/search/radius_tradeoff.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <memory>

#include <taut/geometry/maze_generator.h>
#include <taut/search/arc_search.h>
#include <taut/search/verify_arcs.h>

#include "support/random_world.h"
#include "support/small_world.h"

namespace taut {
namespace {

using End = TradeoffStretch::End;

double after(double r) { return std::nextafter(r, std::numeric_limits<double>::infinity()); }

struct Asked {
  explicit Asked(const World& world) : space(world), index(space), radii(space) {}

  RadiusTradeoff tradeoff(Point s, Point g) const { return radius_tradeoff(radii, index, s, g); }
  bool is_followed(const TradeoffStretch& stretch, double r) const {
    return verify_arcs(stretch.path(r), index.gates(), stretch.start, stretch.goal).valid;
  }

  FreeSpace space;
  PassageIndex index;
  AllRadii radii;
};

/// The same length as that of a search for this radius alone.
void agrees_at(const Asked& asked, const TradeoffStretch& stretch, double r) {
  RC_LOG(fmt::format("r {} of {} to {}, end {}\n", r, stretch.from, stretch.to, int(stretch.end)));
  const ArcSearchResult alone = arc_search(TangentGraph(asked.space, r), stretch.start, stretch.goal);
  RC_ASSERT(alone.status == DiscStatus::found);
  const Interval length = stretch.path(r).length;
  RC_ASSERT(std::abs(length.middle() - alone.path.value()) < 1e-10 + (length.hi - length.lo));
  const auto v = verify_arcs(stretch.path(r), asked.index.gates(), stretch.start, stretch.goal);
  if (!v.valid) {
    std::string w;
    for (auto& b : stretch.bends) w += fmt::format("({},{},{}) ", b.corner.x, b.corner.y, b.turn);
    std::string u;
    for (auto& b : alone.path.bends) u += fmt::format("({},{},{}) ", b.corner.x, b.corner.y, b.turn);
    RC_LOG(v.reason + " ours " + w + " theirs " + u + "\n");
  }
  RC_ASSERT(asked.is_followed(stretch, r));
  RC_ASSERT(std::abs(stretch.formula()(r) - stretch.length(r)) < 1e-9 + (length.hi - length.lo));
}

/// Where one ends and the other begins something changes.
void changes_between(const Asked& asked, const TradeoffStretch& stretch, const TradeoffStretch& next) {
  const double jump = next.at_from.middle() - stretch.at_to.middle();
  RC_LOG(fmt::format("{} -> {}, end {}, jump {}\n", stretch.to, next.from, int(stretch.end), jump));
  RC_ASSERT(next.from > stretch.to);
  if (stretch.end != End::shorter) RC_ASSERT(next.from == after(stretch.to));
  if (stretch.end == End::left) return;
  RC_ASSERT(next.bends != stretch.bends);
  RC_ASSERT(jump > -1e-9);
  if (stretch.end != End::closed) RC_ASSERT(jump < 1e-6);
  if (stretch.end == End::closed) RC_ASSERT(!asked.is_followed(stretch, next.from));
  if (stretch.end != End::shorter) return;
  RC_ASSERT(next.from - stretch.to < 1e-6);
  RC_ASSERT(stretch.at_to.lo <= next.path(stretch.to).length.hi + next.aside);
  RC_ASSERT(next.at_from.lo <= stretch.path(next.from).length.hi + stretch.aside);
}

void holds_for(const World& world, Point s, Point g) {
  const Asked asked(world);
  const RadiusTradeoff found = asked.tradeoff(s, g);
  const double least = asked.radii.least_radius();
  const auto widest = asked.index.widest(s, g);
  RC_ASSERT((found.status == DiscStatus::found) ||
            (asked.index.passes(s, g, least) != DiscStatus::found && found.stretches.empty()));
  if (found.stretches.empty()) return;
  RC_ASSERT(found.stretches.front().from == least);
  RC_ASSERT(found.stretches.back().end == End::last);
  if (!found.start_left && !found.goal_left)
    RC_ASSERT(found.stretches.back().to == std::min(widest->radius, World::kLargest));
  RC_ASSERT(found.stretches.back().to >= std::min(widest->radius, World::kLargest));
  for (std::size_t i = 0; i < found.stretches.size(); ++i) {
    const TradeoffStretch& stretch = found.stretches[i];
    if (stretch.start == stretch.goal) continue;
    for (const double part : {0.0, 0.5, test::any(1, 99) / 100.0, 1.0})
      agrees_at(asked, stretch, part == 1 ? stretch.to : stretch.from + part * (stretch.to - stretch.from));
    if (i + 1 < found.stretches.size()) changes_between(asked, stretch, found.stretches[i + 1]);
  }
}

RC_GTEST_PROP(RadiusTradeoff, AgreesWithSearchesOfOneRadiusInMessyWorlds, ()) {
  const test::SmallWorld small =
      test::any_world({.side = 6, .walls = 7, .solids = 2, .straight = test::any(0, 1) == 1});
  const Boundary boundary = std::array{Boundary::walled, Boundary::limit, Boundary::open}[test::any(0, 2)];
  const Point s = test::any_fine_point(6), g = test::any_fine_point(6);
  RC_LOG(test::show(small) + fmt::format(" boundary {} {} {}\n", int(boundary), test::show(s), test::show(g)));
  if (s == g) return;
  holds_for(small.bounded(boundary), s, g);
}

RC_GTEST_PROP(RadiusTradeoff, AgreesWithSearchesOfOneRadiusInMazes, ()) {
  const int width = test::any(2, 6), height = test::any(2, 6), seed = test::any(0, 1 << 20);
  auto maze = std::make_shared<GridMaze>(generate_backtracker(width, height, seed));
  open_walls(*maze, test::any(0, 8) / 10.0, seed);
  RC_LOG(fmt::format("{} x {} seed {}\n", width, height, seed));
  if (getenv("SHOW")) fmt::print(stderr, "{} x {} seed {}\n", width, height, seed);
  holds_for(world_of(maze), {0.5, 0.5}, {width - 0.5, height - 0.5});
}

}  // namespace
}  // namespace taut
