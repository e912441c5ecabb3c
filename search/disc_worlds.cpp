#include <taut/search/disc_worlds.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

#include <taut/geometry/box_index.h>
#include <taut/geometry/exact/exact_point.h>
#include <taut/geometry/exact/numbers.h>
#include <taut/geometry/free_space.h>
#include <taut/geometry/lattice_integers.h>
#include <taut/geometry/plain_world.h>
#include <taut/geometry/walled_world.h>
#include <taut/geometry/written.h>
#include <taut/search/detail/lattice_units.h>
#include <taut/search/detail/world_pieces.h>

namespace taut {

namespace {

__extension__ using Wide = __int128;
using Int = std::int64_t;
using Place = LatticeIntegers::Place;

constexpr double kLargest = 0x1p42;   // of coordinates
constexpr double kFine = 0x1p26;      // so many units the radius has, if there is room
constexpr Int kShrunk = 16;           // units: what the path of legs is off the arcs by, and some more
constexpr double kCoarsest = 0x1p16;  // and at least

double largest_of(const Box& box) {
  return std::max({std::abs(box.min.x), std::abs(box.min.y), std::abs(box.max.x), std::abs(box.max.y)});
}

/// Multiples of a decimal unit, of which ground's is one, too.
class FineUnit {
 public:
  FineUnit(const World& ground, double r) : integers_(ground), digits_(integers_.lattice().exponent) {
    const double largest = largest_of(ground.box()) + r;
    while (r * per_one() < kFine && largest * per_one() * 10 < kLargest) ++digits_;
    is_fine_ = r * per_one() >= kCoarsest && largest * per_one() < kLargest;
    if (is_fine_) factor_ = to_int64(numerator(Rational(all() / detail::per_one_of(integers_.lattice()))));
  }

  bool is_fine() const { return is_fine_; }

  Place place(Point p) const {
    Place place = integers_.place(p).value();
    for (Int& v : place) v *= factor_;
    return place;
  }

  Point point(Place p) const { return {written::number(p[0], digits_), written::number(p[1], digits_)}; }

  /// The most units that are less than the length.
  Int below(double length) const { return to_int64(floor_of(Rational(meaning(length) * all()))) - 1; }

 private:
  double per_one() const { return std::pow(10, digits_); }
  Rational all() const { return Rational(power(10, static_cast<unsigned>(digits_))); }

  LatticeIntegers integers_;
  int digits_;
  Int factor_ = 1;  // ground's unit is so many
  bool is_fine_ = false;
};

/// Corners of a polygon that has the symmetries of a square, none farther from (0, 0) than r.
std::vector<Place> corners_within(Int r, int count) {
  std::vector<Place> corners;
  for (int i = 0; i < count / 4; ++i) {
    const double angle = 2 * std::numbers::pi * i / count;
    Place p{static_cast<Int>(static_cast<double>(r) * std::cos(angle)),
            static_cast<Int>(static_cast<double>(r) * std::sin(angle))};
    while (Wide{p[0]} * p[0] + Wide{p[1]} * p[1] > Wide{r} * r) --p[0];
    corners.insert(corners.end(), {p, {-p[1], p[0]}, {-p[0], -p[1]}, {p[1], -p[0]}});
  }
  return corners;
}

Wide turn(Place a, Place b, Place c) { return Wide{b[0] - a[0]} * (c[1] - a[1]) - Wide{b[1] - a[1]} * (c[0] - a[0]); }

/// Counter-clockwise, corners only.
std::vector<Place> hull(std::vector<Place> points) {
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  std::vector<Place> ring;
  for (const bool is_upper : {false, true}) {
    const std::size_t first = ring.size();
    for (const Place p : points) {
      while (ring.size() > first + 1 && turn(ring[ring.size() - 2], ring.back(), p) <= 0) ring.pop_back();
      ring.push_back(p);
    }
    ring.pop_back();
    if (!is_upper) std::reverse(points.begin(), points.end());
  }
  return ring;
}

/// Is p in the convex polygon or on its border?
bool holds(const std::vector<Place>& ring, Place p) {
  if (ring.empty()) return false;
  for (std::size_t i = 0; i < ring.size(); ++i)
    if (turn(ring[i], ring[(i + 1) % ring.size()], p) < 0) return false;
  return true;
}

/// Of corners in a row that lie in one other hull those between are left out: what goes with them is in the other one,
/// too. One hull after the other, so that their union stays what it is.
class Thinned {
 public:
  explicit Thinned(std::vector<std::vector<Place>> hulls) : hulls_(std::move(hulls)), index_(boxes()) {
    for (std::uint32_t i = 0; i < hulls_.size(); ++i) thin(i);
  }

  const std::vector<std::vector<Place>>& hulls() const { return hulls_; }

 private:
  static Box box(const std::vector<Place>& hull) {
    Box box{{HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL}};
    for (const Place p : hull) {
      const Point q{static_cast<double>(p[0]), static_cast<double>(p[1])};
      box = {{std::min(box.min.x, q.x), std::min(box.min.y, q.y)},
             {std::max(box.max.x, q.x), std::max(box.max.y, q.y)}};
    }
    return box;
  }

  std::vector<Box> boxes() const {
    std::vector<Box> all;
    for (const auto& hull : hulls_) all.push_back(box(hull));
    return all;
  }

  void thin(std::uint32_t i) {
    std::vector<std::uint32_t> near;
    index_.meeting(box(hulls_[i]), [&](std::uint32_t j) {
      if (j != i) near.push_back(j);
    });
    std::sort(near.begin(), near.end());
    for (const std::uint32_t j : near) {
      std::vector<Place>& hull = hulls_[i];
      const std::size_t n = hull.size();
      std::vector<bool> in(n);
      for (std::size_t k = 0; k < n; ++k) in[k] = holds(hulls_[j], hull[k]);
      std::vector<Place> left;
      for (std::size_t k = 0; k < n; ++k)
        if (!(in[(k + n - 1) % n] && in[k] && in[(k + 1) % n])) left.push_back(hull[k]);
      if (left.size() < 3) left.clear();  // all of it is in the other one
      hull = std::move(left);
      if (hull.empty()) return;
    }
  }

  std::vector<std::vector<Place>> hulls_;
  BoxIndex index_;
};

WorldParts outline_of(const World& ground) {
  WorldParts parts;
  parts.source = ground.source();
  parts.areas = ground.areas();
  parts.boundary = ground.boundary();
  parts.solids = ground.solids();
  return parts;
}

}  // namespace

World disc_ground(const World& world, Point start, Point goal) {
  if (is_plain(world)) return world;
  return plain_world(FreeSpace(walled_world(world, {start, goal})));
}

std::optional<World> inner_world(const World& ground, double r) {
  const FineUnit unit(ground, r);
  if (!unit.is_fine()) return std::nullopt;
  std::vector<Segment> pieces;
  const auto add = [&](Point a, Point b) { pieces.push_back({a, b}); };
  for (const Wall& wall : ground.walls()) add(wall.a, wall.b);
  detail::each_side(ground.solids(), add);
  if (ground.boundary() == Boundary::walled) detail::each_side(ground.areas(), add);
  const std::vector<Place> disc = corners_within(unit.below(r) - kShrunk, pieces.size() > kManyPieces ? 32 : 64);
  std::vector<std::vector<Place>> hulls;
  for (const Segment& piece : pieces) {
    std::vector<Place> points;
    for (const Place end : {unit.place(piece.a), unit.place(piece.b)})
      for (const Place p : disc) points.push_back({end[0] + p[0], end[1] + p[1]});
    hulls.push_back(hull(std::move(points)));
  }
  WorldParts parts = outline_of(ground);
  const Thinned thinned(std::move(hulls));
  for (const std::vector<Place>& places : thinned.hulls()) {
    Ring ring;
    for (const Place p : places) ring.push_back(unit.point(p));
    if (!ring.empty()) parts.solids.push_back({Polygon{std::move(ring), {}}, 0});
  }
  return World(std::move(parts));
}

World bare_world(const World& ground, double r) {
  WorldParts parts = outline_of(ground);
  parts.walls = ground.walls();
  if (ground.boundary() == Boundary::walled) return World(std::move(parts));
  // By whole units of the world.
  const NumberLattice lattice = LatticeIntegers(ground).lattice();
  const double per_one = std::pow(lattice.base, lattice.exponent), beyond = std::ceil(1.5 * r * per_one);
  const auto number = [&](double n) {
    return lattice.base == 10 ? written::number(static_cast<Int>(n), lattice.exponent)
                              : std::ldexp(n, -lattice.exponent);
  };
  const Box box = ground.box();
  const double x0 = number(std::floor(box.min.x * per_one) - beyond);
  const double y0 = number(std::floor(box.min.y * per_one) - beyond);
  const double x1 = number(std::ceil(box.max.x * per_one) + beyond);
  const double y1 = number(std::ceil(box.max.y * per_one) + beyond);
  parts.areas = {{Polygon{{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, {}}, 0}};
  parts.boundary = Boundary::limit;
  return World(std::move(parts));
}

}  // namespace taut
