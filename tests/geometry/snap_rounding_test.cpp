// CGAL's snap rounding of the walls as they are, and the free space of the joined ones: the same pieces.
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Snap_rounding_2.h>
#include <CGAL/Snap_rounding_traits_2.h>
#include <gtest/gtest.h>

#include <cmath>
#include <list>
#include <random>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include <support/small_world.h>
#include <support/turned.h>
#include <taut/geometry/snap.h>

namespace taut {
namespace {

using test::Turn;
using test::turns;

/// A piece between two places of the lattice that the walls stood on before they were turned.
using Place = std::pair<long, long>;
using Pieces = std::set<std::pair<Place, Place>>;

constexpr double kPixel = 1e-3;
constexpr int kSize = 12;

class Lattice {
 public:
  explicit Lattice(double degrees) : back_(-degrees) {}
  Place operator()(Point p) const { return {std::lround(back_(p).x), std::lround(back_(p).y)}; }
  /// Pixels may round one place to two neighbours: a piece between these is none.
  void add(Pieces& pieces, Point a, Point b) const {
    const Place p = (*this)(a), q = (*this)(b);
    if (p != q) pieces.emplace(std::min(p, q), std::max(p, q));
  }

 private:
  Turn back_;
};

/// No two along one line have more than a point in common: turned, those cross anywhere along it.
std::vector<Wall> walls(unsigned seed) {
  std::mt19937 engine(seed);
  const auto upto = [&](int n) { return static_cast<int>(engine() % static_cast<unsigned>(n + 1)); };
  std::set<std::tuple<bool, int, int>> taken;  // units
  std::vector<Wall> walls;
  for (int i = 0; i < 60; ++i) {
    const bool upright = upto(1) == 0;
    const int x = upto(kSize - 1), y = upto(kSize - 1), from = upright ? y : x, line = upright ? x : y;
    int to = from;
    for (const int end = std::min(kSize, from + 1 + upto(6)); to < end; ++to)
      if (!taken.emplace(upright, line, to).second) break;
    const double a = from, b = to, at = line;
    if (to > from) walls.push_back(upright ? Wall{{at, a}, {at, b}} : Wall{{a, at}, {b, at}});
  }
  return walls;
}

Pieces pieces_of(const World& world, const Lattice& lattice) {
  Pieces pieces;
  const FreeSpace space(world);
  for (const Constraint& c : space.constraints())
    if (c.is_wall()) lattice.add(pieces, c.a, c.b);
  return pieces;
}

Pieces snap_rounded(const std::vector<Wall>& walls, const Lattice& lattice) {
  using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
  using Polyline = std::list<Kernel::Point_2>;
  std::list<Kernel::Segment_2> segments;
  for (const Wall& w : walls) segments.emplace_back(Kernel::Point_2(w.a.x, w.a.y), Kernel::Point_2(w.b.x, w.b.y));
  std::list<Polyline> rounded;
  CGAL::snap_rounding_2<CGAL::Snap_rounding_traits_2<Kernel>, std::list<Kernel::Segment_2>::const_iterator,
                        std::list<Polyline>>(segments.begin(), segments.end(), rounded, kPixel, true, false, 1);
  Pieces pieces;
  for (const Polyline& line : rounded)
    for (auto a = line.begin(), b = std::next(a); b != line.end(); ++a, ++b)
      lattice.add(pieces, {CGAL::to_double(a->x()), CGAL::to_double(a->y())},
                  {CGAL::to_double(b->x()), CGAL::to_double(b->y())});
  return pieces;
}

/// Each piece divided at the ends of others that lie on it: CGAL leaves one whole now and then, as addresses have it.
Pieces divided(const Pieces& pieces) {
  std::set<Place> ends;
  for (const auto& [a, b] : pieces) ends.insert({a, b});
  Pieces parts;
  for (const auto& [a, b] : pieces) {
    const auto [x, y] = a;
    const long dx = b.first - x, dy = b.second - y;
    Place from = a;
    for (const Place& p : ends) {  // in the order along the piece
      if (p <= a || p > b || (p.first - x) * dy != (p.second - y) * dx) continue;
      parts.emplace(std::exchange(from, p), p);
    }
  }
  return parts;
}

Pieces without(Pieces pieces, const Pieces& others) {
  for (const auto& piece : others) pieces.erase(piece);
  return pieces;
}

TEST(SnapRounding, FindsThePiecesThatJoiningFinds) {
  for (int seed = 0; seed < turns(6); ++seed) {
    SCOPED_TRACE(seed);
    const double degrees = 7 + 11.3 * seed;
    WorldParts parts;
    parts.areas.push_back({{test::box_ring(-1, -1, kSize + 1, kSize + 1), {}}, 0});
    parts.walls = walls(static_cast<unsigned>(seed));
    const WorldParts turned = Turn(degrees)(parts);
    const Lattice lattice(degrees);
    const Pieces rounded = snap_rounded(turned.walls, lattice);
    const Pieces joined = pieces_of(snapped_world(turned).world, lattice);
    EXPECT_EQ(without(divided(joined), divided(rounded)), Pieces{});
    EXPECT_EQ(without(divided(rounded), divided(joined)), Pieces{});
    EXPECT_GT(joined.size(), 40U);
  }
}

}  // namespace
}  // namespace taut
