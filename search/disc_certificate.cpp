#include <taut/search/disc_certificate.h>

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <taut/geometry/exact/exact_point.h>
#include <taut/geometry/plain_world.h>
#include <taut/search/detail/leg_contacts.h>

namespace taut {

namespace {

__extension__ using Wide = __int128;
using Int = std::int64_t;
using Place = DiscCertificate::Place;

constexpr int kMostFiner = 32;             // times a half
constexpr double kLargest = 0x1p50;        // of coordinates
constexpr double kRounding = 1 - 0x1p-45;  // of distances in doubles

Wide squared(Place p, Place q) {
  const Wide x = q[0] - p[0], y = q[1] - p[1];
  return x * x + y * y;
}

Int root_up(Wide square) {
  auto root = static_cast<Int>(std::sqrt(static_cast<long double>(square)));
  while (Wide{root} * root < square) ++root;
  while (root > 0 && Wide{root - 1} * (root - 1) >= square) --root;
  return root;
}

/// A finer grid over the lattice of a world and both ends.
class Grid {
 public:
  Grid(const World& world, std::span<const Point> places) : integers_(world, places) {
    const Box box = world.box();
    double largest = 1;
    for (const double v : {box.min.x, box.min.y, box.max.x, box.max.y}) largest = std::max(largest, std::abs(v));
    const double multiples = largest * units().get_d();
    while (finer_ < kMostFiner && multiples * std::ldexp(1, finer_ + 1) < kLargest) ++finer_;
  }

  Int scale() const { return integers_.scale() << finer_; }
  /// So many make 1.
  mpz_class units() const {
    mpz_class power;
    mpz_ui_pow_ui(power.get_mpz_t(), static_cast<unsigned long>(integers_.lattice().base),
                  static_cast<unsigned long>(integers_.lattice().exponent));
    return power * mpz_class(static_cast<long>(scale()));
  }

  std::optional<Place> exactly(Point p) const {
    const auto place = integers_.place(p);
    if (!place) return std::nullopt;
    return Place{(*place)[0] << finer_, (*place)[1] << finer_};
  }
  Int down(const mpq_class& v) const {
    const mpq_class n = v * units();
    return mpz_class(n.get_num() / n.get_den()).get_si();  // of what is not negative
  }
  Place nearest(Point p) const { return {rounded(p.x), rounded(p.y)}; }
  Point point(Place p) const {
    const double n = units().get_d();
    return {static_cast<double>(p[0]) / n, static_cast<double>(p[1]) / n};
  }
  /// On the piece, whose ends are on the coarse lattice: the nearest of 2^finer parts to its foot.
  std::optional<Place> on(const Segment& piece, Point foot) const {
    const auto a = exactly(piece.a), b = exactly(piece.b);
    if (!a || !b) return std::nullopt;
    const Int x = ((*b)[0] - (*a)[0]) >> finer_, y = ((*b)[1] - (*a)[1]) >> finer_;
    if (x == 0 || y == 0) {  // every multiple is on it
      const Place p = nearest(foot);
      return x == 0 ? Place{(*a)[0], p[1]} : Place{p[0], (*a)[1]};
    }
    const double ux = piece.b.x - piece.a.x, uy = piece.b.y - piece.a.y;
    const double part = ((foot.x - piece.a.x) * ux + (foot.y - piece.a.y) * uy) / (ux * ux + uy * uy);
    const auto steps = static_cast<Int>(std::llround(std::ldexp(std::clamp(part, 0.0, 1.0), finer_)));
    return Place{(*a)[0] + x * steps, (*a)[1] + y * steps};
  }

 private:
  Int rounded(double v) const {
    const mpq_class n = meaning(v) * units() * 2 + 1;  // floor((2 v + 1) / 2)
    mpz_class down;
    mpz_fdiv_q(down.get_mpz_t(), n.get_num_mpz_t(), mpz_class(n.get_den() * 2).get_mpz_t());
    return down.get_si();
  }

  LatticeIntegers integers_;
  int finer_ = 0;
};

Segment segment(const FreeSpace& space, std::uint32_t constraint) {
  const Constraint& c = space.constraints()[constraint];
  return {c.a, c.b};
}

/// The chain as places where one piece ends and the next begins.
class Chain {
 public:
  Chain(const Gates& gates, const Grid& grid, const std::vector<BarrierPiece>& pieces)
      : gates_(gates), grid_(grid), pieces_(pieces) {
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      const BarrierPiece &before = pieces_[(i + pieces_.size() - 1) % pieces_.size()], &piece = pieces_[i],
                         &after = pieces_[(i + 1) % pieces_.size()];
      if (piece.gate != kNone)
        add_gate(before, gates_.gates()[piece.gate], after);
      else if (after.gate == kNone)
        add_joint(segment(gates_.space(), piece.constraint), segment(gates_.space(), after.constraint));
    }
  }

  bool is_exact() const { return is_exact_; }
  std::vector<Place> take() { return std::move(places_); }
  Wide widest() const { return widest_; }  ///< gate, squared

 private:
  void add(const std::optional<Place>& place) {
    is_exact_ &= place.has_value();
    if (place) places_.push_back(*place);
  }

  bool holds(const BarrierPiece& piece, const Gate& gate, bool foot) const {
    const Point p = foot ? gate.foot : gate.end;
    if (piece.gate != kNone) {
      const Gate& other = gates_.gates()[piece.gate];
      return other.end == p || other.foot == p;
    }
    const Segment s = segment(gates_.space(), piece.constraint);
    return s.a == p || s.b == p || (foot && gate.facing == piece.constraint);
  }

  void add_gate(const BarrierPiece& before, const Gate& gate, const BarrierPiece& after) {
    const auto end = grid_.exactly(gate.end);
    const auto foot =
        gate.foot_is_end ? grid_.exactly(gate.foot) : grid_.on(segment(gates_.space(), gate.facing), gate.foot);
    const bool forward = holds(before, gate, false) && holds(after, gate, true);
    add(forward ? end : foot);
    add(forward ? foot : end);
    if (end && foot) widest_ = std::max(widest_, squared(*end, *foot));
  }

  void add_joint(const Segment& s, const Segment& t) { add(grid_.exactly(s.a == t.a || s.a == t.b ? s.a : s.b)); }

  const Gates& gates_;
  const Grid& grid_;
  const std::vector<BarrierPiece>& pieces_;
  std::vector<Place> places_;
  Wide widest_ = 0;
  bool is_exact_ = true;
};

/// Points of the curve behind its beginning. A parabola is nearest to its walls at its apex: a leg between two points on
/// one side of it comes no nearer if the one is less than 5.8 times as far from the apex as the other.
std::vector<Point> points_on(const Bezier& curve) {
  constexpr int kHalvings = 24;
  const double ax = curve.from.x - 2 * curve.control.x + curve.to.x,
               ay = curve.from.y - 2 * curve.control.y + curve.to.y;
  const double bx = curve.control.x - curve.from.x, by = curve.control.y - curve.from.y, a2 = ax * ax + ay * ay;
  std::vector<double> parts;
  if (a2 > 1e-20 * (bx * bx + by * by)) {
    const double apex = -(ax * bx + ay * by) / a2, most = std::max(std::abs(apex), std::abs(1 - apex));
    for (int i = 0; i < kHalvings; ++i)
      for (const double part : {apex - std::ldexp(most, -i), apex + std::ldexp(most, -i)})
        if (0 < part && part < 1) parts.push_back(part);
    std::sort(parts.begin(), parts.end());
  }
  std::vector<Point> points;
  for (const double part : parts) points.push_back(curve.at(part));
  points.push_back(curve.to);
  return points;
}

std::vector<Place> on_grid(const Grid& grid, std::span<const Bezier> way, Place start, Place goal) {
  std::vector<Place> path{start};
  for (const Bezier& curve : way)
    for (const Point p : points_on(curve))
      if (const Place place = grid.nearest(p); place != path.back()) path.push_back(place);
  if (path.size() > 1 && !way.empty()) path.pop_back();
  if (path.size() > 1 && path.back() == goal) path.pop_back();
  if (goal != start || path.size() > 1) path.push_back(goal);
  return path;
}

/// How far the path is from all walls, rounded down.
Int distance(const Grid& grid, const std::vector<Place>& path, const FreeSpace& space) {
  std::vector<Segment> legs;
  for (std::size_t i = 0; i < path.size(); ++i)
    legs.push_back({grid.point(path[i]), grid.point(path[std::min(i + 1, path.size() - 1)])});
  const detail::LegTree tree(legs, space.constraints());
  const detail::LegContacts contacts = tree.contacts();
  for (std::size_t i = 0; i < legs.size(); ++i)
    if (contacts.crossed[i] != kNone || !contacts.touching[i].empty()) return 0;
  return std::max<Int>(0, grid.down(mpq_class(tree.nearest().distance * kRounding)) - 1);
}

}  // namespace

std::optional<DiscCertificate> widest_certificate(const Gates& gates, const WidestPassage& widest, Point s, Point g,
                                                  std::span<const Bezier> way) {
  const Grid grid(plain_world(gates.space()), std::array{s, g});
  const auto start = grid.exactly(s), goal = grid.exactly(g);
  if (!start || !goal || widest.limit == WidestPassage::Limit::none) return std::nullopt;
  DiscCertificate certificate{.scale = grid.scale(), .is_found = true};
  if (widest.limit == WidestPassage::Limit::gate) {
    Chain chain(gates, grid, widest.barrier);
    if (!chain.is_exact()) return std::nullopt;
    certificate.chain = chain.take();
    certificate.width = root_up(chain.widest());
  } else {
    const Point end = widest.limit == WidestPassage::Limit::start ? s : g;
    const Segment wall = segment(gates.space(), widest.constraint);
    const double ux = wall.b.x - wall.a.x, uy = wall.b.y - wall.a.y;
    const double part = std::clamp(((end.x - wall.a.x) * ux + (end.y - wall.a.y) * uy) / (ux * ux + uy * uy), 0.0, 1.0);
    const auto foot = grid.on(wall, {wall.a.x + part * ux, wall.a.y + part * uy});
    if (!foot) return std::nullopt;
    certificate.chain = {*foot};
    certificate.width = root_up(4 * squared(*foot, end == s ? *start : *goal));
  }
  certificate.path = on_grid(grid, way, *start, *goal);
  certificate.keeps = distance(grid, certificate.path, gates.space());
  return certificate;
}

std::optional<DiscCertificate> narrow_certificate(const Gates& gates, const DiscPassage& passage, Point s, Point g,
                                                  double r) {
  const Grid grid(plain_world(gates.space()), std::array{s, g, Point{r, r}});  // on which the radius is a multiple
  const auto start = grid.exactly(s), goal = grid.exactly(g);
  Chain chain(gates, grid, passage.barrier);
  if (!start || !goal || !chain.is_exact()) return std::nullopt;
  return DiscCertificate{
      .scale = grid.scale(), .path = {*start, *goal}, .chain = chain.take(), .width = grid.down(2 * meaning(r))};
}

}  // namespace taut
