// Three ways to say where a disc can go, beside each other: the index of faces, the chains of gates and the Voronoi diagram share
// predicates alone. Small worlds full of coincidences; TAUT_RANDOM_WORLDS says how many.
#include <array>
#include <cmath>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <taut/search/clearance_search.h>
#include <taut/search/passage_index.h>

#include "support/small_world.h"

namespace taut {
namespace {

int worlds(int usual) {
  const char* asked = std::getenv("TAUT_RANDOM_WORLDS");
  return asked ? std::atoi(asked) : usual;
}

/// Walls and blocks between points of a lattice of `side` steps, `unit` of them to 1; ends on it or between.
class Drawn {
 public:
  explicit Drawn(unsigned seed) : engine_(seed) {
    constexpr std::array kUnits{1, 2, 10, 100};
    unit_ = kUnits[engine_() % kUnits.size()];
    side_ = between(3, 9);
    small_.area = test::box_ring(0, 0, number(side_), number(side_));
    const bool is_straight = between(0, 2) == 0;
    for (int n = between(1, 9); n > 0; --n) {
      const Point a = place();
      Point b = place();
      if (is_straight) (between(0, 1) ? b.x : b.y) = between(0, 1) ? a.x : a.y;
      if (is_straight && a.x != b.x) b.y = a.y;
      if (a != b) small_.walls.push_back({a, b});
    }
    for (int n = between(0, 2); n > 0; --n) {
      const int x = between(0, side_ - 1), y = between(0, side_ - 1);
      small_.solids.push_back(test::box_ring(number(x), number(y), number(x + 1), number(y + 1)));
    }
    boundary_ = std::array{Boundary::walled, Boundary::walled, Boundary::limit, Boundary::open}[engine_() % 4];
  }

  /// To the diagram openings are walls.
  bool is_walled() const { return boundary_ == Boundary::walled; }
  FreeSpace space() const { return FreeSpace(small_.bounded(boundary_)); }
  Point end() {
    if (between(0, 3) == 0) return place();
    const int x = between(1, 64 * side_ - 1), y = between(1, 64 * side_ - 1);
    return {x / 64.0 / unit_, y / 64.0 / unit_};
  }
  double radius() { return between(1, 60 * side_) / 100.0 / unit_; }
  int between(int first, int last) { return first + static_cast<int>(engine_() % unsigned(last - first + 1)); }

  std::string text() const {
    std::string all = fmt::format("boundary {} 0 0 {} {}", static_cast<int>(boundary_), number(side_), number(side_));
    for (const Segment& s : small_.walls) all += fmt::format("\n{} {} {} {}", s.a.x, s.a.y, s.b.x, s.b.y);
    for (const Ring& r : small_.solids) all += fmt::format("\nblock {} {} {} {}", r[0].x, r[0].y, r[2].x, r[2].y);
    return all;
  }

 private:
  double number(int steps) const { return double(steps) / unit_; }
  Point place() {
    const int x = between(0, side_), y = between(0, side_);
    return {number(x), number(y)};
  }

  std::mt19937 engine_;
  int unit_ = 1, side_ = 1;
  test::SmallWorld small_;
  Boundary boundary_ = Boundary::walled;
};

std::vector<double> radii_to_ask(Drawn& world, const PassageIndex& index, const std::optional<WidestPassage>& widest) {
  std::vector<double> radii{world.radius()};
  const auto around = [&](double r) {
    if (r > 0 && std::isfinite(r)) radii.insert(radii.end(), {std::nextafter(r, 0), r, std::nextafter(r, HUGE_VAL)});
  };
  if (widest) around(widest->radius);
  if (const auto n = static_cast<int>(index.gates().gates().size()); n > 0)
    around(index.gate_radius(static_cast<std::uint32_t>(world.between(0, n - 1))));
  return radii;
}

/// Empty, or who says what else.
std::string difference(Drawn& world, const PassageIndex& index, Point s, Point g) {
  const auto ours = index.widest(s, g), chains = widest_passage(index.gates(), s, g);
  if (ours.has_value() != chains.has_value()) return "only one of index and chains finds a way";
  if (ours && (ours->radius != chains->radius || ours->gate != chains->gate || ours->limit != chains->limit ||
               ours->constraint != chains->constraint))
    return fmt::format("the widest: index {}, chains {}", ours->radius, chains->radius);
  const bool free = index.gates().space().holds(s) && index.gates().space().holds(g);
  std::optional<ClearanceSearch> diagram;
  if (world.is_walled() && free) diagram.emplace(VoronoiRoadmap(index.gates().space()), s, g);
  // Where crossings were rounded, walls bend by an ulp, and the diagram is right within it (VoronoiRoadmap).
  const double slack = index.gates().space().report().displacement > 0 && ours ? 1e-12 * ours->radius : 0;
  if (diagram) {
    const auto widest = diagram->widest();
    if (widest.has_value() != ours.has_value()) return "only one of index and diagram finds a way";
    const double r = widest ? widest->pinch.clearance : 0;
    // The one is the nearest double, the other the largest that passes.
    if (ours && std::abs(r - ours->radius) > slack && r != ours->radius && r != std::nextafter(ours->radius, HUGE_VAL))
      return fmt::format("the widest: index {}, diagram {}", ours->radius, r);
  }
  for (const double r : radii_to_ask(world, index, ours)) {
    const DiscStatus status = index.passes(s, g, r);
    if (status != disc_passage(index.gates(), s, g, r).status) return fmt::format("index and chains of {:a}", r);
    if (slack > 0 && std::abs(r - ours->radius) <= slack) continue;
    if (diagram && diagram->shortest(r).has_value() != (status == DiscStatus::found))
      return fmt::format("index and diagram of {:a}", r);
  }
  return {};
}

TEST(AllPassages, AgreeInRandomWorlds) {
  for (int seed = 0, count = worlds(150); seed < count; ++seed) {
    Drawn world(static_cast<unsigned>(seed));
    const PassageIndex index(world.space());
    for (int n = 0; n < 2; ++n) {
      const Point s = world.end(), g = world.end();
      ASSERT_EQ(difference(world, index, s, g), "")
          << fmt::format("seed {}\n{}\nstart {} {}\ngoal {} {}", seed, world.text(), s.x, s.y, g.x, g.y);
    }
  }
}

}  // namespace
}  // namespace taut
