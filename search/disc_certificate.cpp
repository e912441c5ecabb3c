#include <taut/search/disc_certificate.h>

#include <taut/geometry/exact/numbers.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <taut/geometry/exact/exact_point.h>
#include <taut/geometry/plain_world.h>
#include <taut/geometry/segment_distance.h>
#include <taut/search/detail/leg_contacts.h>
#include <taut/search/detail/place_grid.h>

namespace taut {

namespace {

__extension__ using Wide = __int128;
using Int = std::int64_t;
using Place = DiscCertificate::Place;

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

using detail::PlaceGrid;

Segment segment(const FreeSpace& space, std::uint32_t constraint) {
  const Constraint& c = space.constraints()[constraint];
  return {c.a, c.b};
}

/// The walls and sides that the judge knows, which no crossing splits.
class Edges {
 public:
  Edges(const FreeSpace& space, const World& plain, const PlaceGrid& grid) : space_(space), grid_(grid) {
    for (const Wall& wall : plain.walls()) edges_.push_back({wall.a, wall.b});
    for (const std::vector<Area>* areas : {&plain.areas(), &plain.solids()})
      for (const Area& area : *areas) {
        add(area.polygon.outer);
        for (const Ring& hole : area.polygon.holes) add(hole);
      }
  }

  /// The place nearest to p on the edge that the constraint is a piece of.
  std::optional<Place> on(std::uint32_t constraint, Point p) const {
    const Segment piece = segment(space_, constraint);
    if ((p == piece.a || p == piece.b) && grid_.exactly(p)) return grid_.exactly(p);
    return grid_.on(grid_.exactly(piece.a) && grid_.exactly(piece.b) ? piece : whole(piece), p);
  }

 private:
  void add(const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) edges_.push_back({ring[i], ring[(i + 1) % ring.size()]});
  }

  Segment whole(const Segment& piece) const {
    const auto away = [&](const Segment& edge) {
      return std::max(segment_distance_interval({piece.a, piece.a}, edge).hi,
                      segment_distance_interval({piece.b, piece.b}, edge).hi);
    };
    return *std::min_element(edges_.begin(), edges_.end(),
                             [&](const Segment& s, const Segment& t) { return away(s) < away(t); });
  }

  const FreeSpace& space_;
  const PlaceGrid& grid_;
  std::vector<Segment> edges_;
};

/// The chain as places where one piece ends and the next begins; where that is no place of the grid, as a crossing, the
/// nearest on either: next to nothing apart.
class Chain {
 public:
  Chain(const Gates& gates, const Edges& edges, const std::vector<BarrierPiece>& pieces)
      : gates_(gates), edges_(edges) {
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const BarrierPiece &before = pieces[(i + pieces.size() - 1) % pieces.size()], &piece = pieces[i],
                         &after = pieces[(i + 1) % pieces.size()];
      if (piece.gate != kNone)
        add_gate(before, gates_.gates()[piece.gate], after);
      else
        add_piece(before, piece.constraint, after);
    }
    if (places_.size() > 1 && places_.front() == places_.back()) {
      places_.pop_back();
      is_link_.pop_back();
    }
    for (std::size_t i = 0; i < places_.size(); ++i)
      if (is_link_[i]) widest_ = std::max(widest_, squared(places_[i], places_[(i + 1) % places_.size()]));
  }

  bool is_exact() const { return is_exact_; }
  std::vector<Place> take() { return std::move(places_); }
  Wide widest() const { return widest_; }  ///< link that is no piece, squared

 private:
  void add(const std::optional<Place>& place, bool is_link) {
    is_exact_ &= place.has_value();
    if (!place) return;
    if (!places_.empty() && places_.back() == *place) {
      is_link_.back() = is_link;
      return;
    }
    places_.push_back(*place);
    is_link_.push_back(is_link);
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
    const auto end = edges_.on(gate.constraint, gate.end), foot = edges_.on(gate.facing, gate.foot);
    const bool forward = holds(before, gate, false) && holds(after, gate, true);
    add(forward ? end : foot, true);
    add(forward ? foot : end, true);
  }

  /// Where the piece touches its neighbour.
  Point joint(std::uint32_t constraint, const BarrierPiece& other) const {
    const Segment s = segment(gates_.space(), constraint);
    if (other.gate == kNone) {
      const Segment t = segment(gates_.space(), other.constraint);
      return s.a == t.a || s.a == t.b ? s.a : s.b;
    }
    const Gate& gate = gates_.gates()[other.gate];
    for (const Point p : {gate.end, gate.foot})
      if (p == s.a || p == s.b) return p;
    return gate.foot;
  }

  void add_piece(const BarrierPiece& before, std::uint32_t constraint, const BarrierPiece& after) {
    add(edges_.on(constraint, joint(constraint, before)), false);
    add(edges_.on(constraint, joint(constraint, after)), true);
  }

  const Gates& gates_;
  const Edges& edges_;
  std::vector<Place> places_;
  std::vector<bool> is_link_;  ///< what follows each place is no piece
  Wide widest_ = 0;
  bool is_exact_ = true;
};

/// Points of the curve behind its beginning. A parabola is nearest to its walls at its apex: a leg between two points
/// on one side of it comes no nearer if the one is less than 5.8 times as far from the apex as the other.
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

std::vector<Place> on_grid(const PlaceGrid& grid, std::span<const Bezier> way, Place start, Place goal) {
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
Int distance(const PlaceGrid& grid, const std::vector<Place>& path, const FreeSpace& space) {
  std::vector<Segment> legs;
  for (std::size_t i = 0; i < path.size(); ++i)
    legs.push_back({grid.point(path[i]), grid.point(path[std::min(i + 1, path.size() - 1)])});
  const detail::LegTree tree(legs, space.constraints());
  const detail::LegContacts contacts = tree.contacts();
  for (std::size_t i = 0; i < legs.size(); ++i)
    if (contacts.crossed[i] != kNone || !contacts.touching[i].empty()) return 0;
  const double least = tree.nearest().distance * kRounding - 2 * space.report().displacement;
  return least > 0 ? std::max<Int>(0, grid.down(Rational(least)) - 1) : 0;
}

}  // namespace

std::optional<DiscCertificate> widest_certificate(const Gates& gates, const WidestPassage& widest, Point s, Point g,
                                                  std::span<const Bezier> way) {
  const World plain = plain_world(gates.space());
  const PlaceGrid grid(plain, std::array{s, g});
  const Edges edges(gates.space(), plain, grid);
  const auto start = grid.exactly(s), goal = grid.exactly(g);
  if (!start || !goal || widest.limit == WidestPassage::Limit::none) return std::nullopt;
  DiscCertificate certificate{.scale = grid.scale(), .is_found = true};
  if (widest.limit == WidestPassage::Limit::gate) {
    Chain chain(gates, edges, widest.barrier);
    if (!chain.is_exact()) return std::nullopt;
    certificate.chain = chain.take();
    certificate.width = root_up(chain.widest());
  } else {
    const Point end = widest.limit == WidestPassage::Limit::start ? s : g;
    const Segment wall = segment(gates.space(), widest.constraint);
    const double ux = wall.b.x - wall.a.x, uy = wall.b.y - wall.a.y;
    const double part = std::clamp(((end.x - wall.a.x) * ux + (end.y - wall.a.y) * uy) / (ux * ux + uy * uy), 0.0, 1.0);
    const auto foot = edges.on(widest.constraint, {wall.a.x + part * ux, wall.a.y + part * uy});
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
  const World plain = plain_world(gates.space());
  const PlaceGrid grid(plain, std::array{s, g, Point{r, r}});  // on which the radius is a multiple
  const Edges edges(gates.space(), plain, grid);
  const auto start = grid.exactly(s), goal = grid.exactly(g);
  Chain chain(gates, edges, passage.barrier);
  if (!start || !goal || !chain.is_exact()) return std::nullopt;
  return DiscCertificate{
      .scale = grid.scale(), .path = {*start, *goal}, .chain = chain.take(), .width = grid.down(2 * meaning(r))};
}

}  // namespace taut
