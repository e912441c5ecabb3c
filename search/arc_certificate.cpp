#include <taut/search/arc_certificate.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <taut/geometry/exact/exact_point.h>
#include <taut/geometry/exact/numbers.h>
#include <taut/geometry/free_space.h>
#include <taut/geometry/lattice_integers.h>
#include <taut/roadmaps/visibility_graph.h>
#include <taut/search/detail/lattice_units.h>
#include <taut/search/detail/leg_contacts.h>
#include <taut/search/detail/world_pieces.h>
#include <taut/search/disc_worlds.h>

namespace taut {

namespace {

__extension__ using Wide = __int128;
using Int = std::int64_t;
using Place = PathCertificate::Place;

constexpr double kKept = 1 - 1e-6;  // of the radius; the judge says how much

/// The legs around the outside of the path's arcs, `off` farther from their centres than they are.
class LegsOutside {
 public:
  LegsOutside(const ArcPath& path, double off, const FreeSpace& walls)
      : radius_(path.radius), off_(off), walls_(walls) {
    points.push_back(path.start);
    bool after_leg = false;
    for (const ArcPiece& piece : pieces(path)) {
      if (piece.turn == 0 && after_leg) points.push_back(piece.from);  // through a corner of openings
      after_leg = piece.turn == 0;
      if (!after_leg) add(piece);
    }
    points.push_back(path.goal);
  }

  std::vector<Point> points;

 private:
  /// Tangents at the arc's ends, where it passes a wall that leaves it no more room than it needs, and between.
  void add(const ArcPiece& arc) {
    std::vector<double> turns = passages(arc);
    turns.insert(turns.end(), {0, arc.sweep});
    std::sort(turns.begin(), turns.end());
    add(arc, radius_ + off_, 0);
    for (std::size_t i = 0; i + 1 < turns.size(); ++i) {
      const double sweep = turns[i + 1] - turns[i];
      const int count = static_cast<int>(std::ceil(sweep / (2 * std::numbers::pi / kArcSteps)));
      for (int k = 0; k < count; ++k)
        add(arc, (radius_ + off_) / std::cos(sweep / count / 2), turns[i] + sweep * (k + 0.5) / count);
    }
    add(arc, radius_ + off_, arc.sweep);
  }

  void add(const ArcPiece& arc, double distance, double turned) {
    const double angle = arc.from_angle + arc.turn * turned;
    points.push_back({arc.centre.x + distance * std::cos(angle), arc.centre.y + distance * std::sin(angle)});
  }

  std::vector<double> passages(const ArcPiece& arc) const {
    std::vector<double> turns;
    const Point c = arc.centre;
    for (const Constraint& wall : walls_.constraints()) {
      const double ux = wall.b.x - wall.a.x, uy = wall.b.y - wall.a.y;
      const double part = std::clamp(((c.x - wall.a.x) * ux + (c.y - wall.a.y) * uy) / (ux * ux + uy * uy), 0.0, 1.0);
      const double x = wall.a.x + part * ux - c.x, y = wall.a.y + part * uy - c.y;
      if (std::abs(std::hypot(x, y) / radius_ - 2) > kTight) continue;
      const double turned = std::remainder(arc.turn * (std::atan2(y, x) - arc.from_angle), 2 * std::numbers::pi);
      if (turned > 0 && turned < arc.sweep) turns.push_back(turned);
    }
    return turns;
  }

  static constexpr double kTight = 1e-3;  // in radii

  double radius_, off_;
  const FreeSpace& walls_;
};

/// The least distance between the path and what stands in the world, to a few last digits too small.
double distance(const std::vector<Place>& path, double per_one, const FreeSpace& space) {
  std::vector<Segment> legs;
  double largest = 0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const auto point = [&](const Place& p) {
      return Point{static_cast<double>(p[0]) / per_one, static_cast<double>(p[1]) / per_one};
    };
    legs.push_back({point(path[i]), point(path[std::min(i + 1, path.size() - 1)])});
    largest = std::max({largest, std::abs(legs.back().a.x), std::abs(legs.back().a.y)});
  }
  const detail::LegTree tree(legs, space.constraints());
  const detail::LegContacts contacts = tree.contacts();
  for (std::size_t i = 0; i < legs.size(); ++i)
    if (contacts.crossed[i] != kNone || !contacts.touching[i].empty()) return 0;
  return tree.nearest().distance * (1 - 0x1p-45) - largest * 0x1p-51 - 2 * space.report().displacement;
}

Int root_up(Wide square) {
  auto root = static_cast<Int>(std::sqrt(static_cast<long double>(square)));
  while (Wide{root} * root < square) ++root;
  return root;
}

double largest_of(const Box& box) {
  return std::hypot(std::max(std::abs(box.min.x), std::abs(box.max.x)),
                    std::max(std::abs(box.min.y), std::abs(box.max.y)));
}

/// How often a unit, of which so many make 1, can be halved with the world's coordinates in range.
int room_for_halvings(double per_one, const World& world) {
  const double room = static_cast<double>(LatticeIntegers::kLargest) / (per_one * largest_of(world.box()));
  return std::clamp(std::ilogb(room) - 1, 0, 20);
}

/// Of the same path, in the coordinates of the other world, the unit halved if there is room.
std::optional<DiscCertificate> kept(const FreeSpace& walls, const PathCertificate& bound, const NumberLattice& lattice,
                                    double r) {
  const LatticeIntegers integers(walls.world());
  Rational per_one = detail::per_one_of(lattice) * integer(bound.scale);
  const Int finer = Int{1} << room_for_halvings(to_double(per_one), walls.world());
  per_one *= integer(finer);
  const Rational scale = per_one / detail::per_one_of(integers.lattice());
  if (denominator(scale) != 1) return std::nullopt;
  DiscCertificate certificate{.scale = to_int64(numerator(scale)), .is_found = true, .path = bound.path};
  for (Place& p : certificate.path)
    for (Int& v : p) v *= finer;
  const double least = distance(certificate.path, to_double(per_one), walls);
  if (!(least > r * kKept)) return std::nullopt;
  // Up from the radius, if there is room; else down from what is kept.
  const Integer up = -floor_of(Rational(-meaning(r) * per_one));
  const Integer down = floor_of(Rational(Rational(least) * per_one)) - 1;
  certificate.keeps = to_int64(up < down ? up : down);
  const Place start = certificate.path.front();
  Wide nearest = 0;
  detail::each_piece(walls.world(), [&](Point a, Point) {
    Place p = integers.place(a).value();
    for (Int& v : p) v *= certificate.scale;
    const Wide x = p[0] - start[0], y = p[1] - start[1], square = x * x + y * y;
    if (!certificate.chain.empty() && square >= nearest) return;
    certificate.chain = {p};
    nearest = square;
  });
  certificate.width = root_up(4 * nearest);
  return certificate;
}

}  // namespace

struct ArcProver::Impl {
  explicit Impl(World inner_world, World bare_world)
      : inner(std::move(inner_world)),
        bare(std::move(bare_world)),
        lattice(LatticeIntegers(inner).lattice()),
        graph(FreeSpace(inner)),
        walls(bare) {}

  World inner, bare;
  NumberLattice lattice;
  VisibilityGraph graph;
  FreeSpace walls;
};

ArcProver::ArcProver(const World& ground, double r) {
  if (auto inner = inner_world(ground, r)) impl_ = std::make_unique<Impl>(std::move(*inner), bare_world(ground, r));
}

ArcProver::~ArcProver() = default;
ArcProver::ArcProver(ArcProver&&) noexcept = default;
ArcProver& ArcProver::operator=(ArcProver&&) noexcept = default;

std::optional<ArcCertificate> ArcProver::certificate(const ArcPath& path) const {
  if (!impl_) return std::nullopt;
  const std::vector<Point> points = LegsOutside(path, 4 * impl_->lattice.unit(), impl_->walls).points;
  const LatticeIntegers ends(impl_->inner, std::array{path.start, path.goal});
  const auto bound = shortest_certificate(impl_->graph, Path{points, Length(points)}, Goal{path.goal, {}},
                                          room_for_halvings(ends.per_one(), impl_->bare));
  if (!bound) return std::nullopt;
  auto keeps = kept(impl_->walls, *bound, impl_->lattice, path.radius);
  if (!keeps) return std::nullopt;
  return ArcCertificate{path.radius, path.start, path.goal, *bound, std::move(*keeps)};
}

}  // namespace taut
