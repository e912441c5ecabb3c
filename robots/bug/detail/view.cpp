#include <taut/robots/bug/detail/view.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <taut/geometry/triangular_expansion.h>

namespace taut::bug::detail {

namespace {

using Tri = Triangulation;

constexpr double kChord = std::numbers::pi / 45;

/// Vertices as doubles, seen from an origin that may be rational.
class SpotCoordinates {
 public:
  struct Place {
    Point at;
    const Spot* spot = nullptr;
  };

  explicit SpotCoordinates(const Tri& tri) : points_(tri.points.data()) {}
  Place at(std::uint32_t v) const { return {points_[v]}; }
  static int side(const Place& origin, const Place& b, const Place& c) { return orientation(*origin.spot, b.at, c.at); }

 private:
  const Point* points_;
};

Point as_point(const ExactPoint& p) { return {to_double(p.x), to_double(p.y)}; }

}  // namespace

SensorRange::SensorRange(double range) : value_(range), endless_(std::isinf(range)), squared_(endless_ ? 0 : range) {
  squared_ *= squared_;
}

Sight::Sight(const ContourPlaces& places, const Stand& stand, const SensorRange& range)
    : places_(places), stand_(stand), range_(range), origin_(stand.at) {
  look();
  for (std::uint32_t k = 0; k < pieces_.size(); ++k)
    by_side_.emplace_back(3 * pieces_[k].t + static_cast<std::uint32_t>(pieces_[k].i), k);
  std::sort(by_side_.begin(), by_side_.end());
  std::sort(corners_.begin(), corners_.end());
  corners_.erase(std::unique(corners_.begin(), corners_.end()), corners_.end());
}

void Sight::look() {
  if (range_.value() == 0) return;
  const Tri& tri = places_.tri();
  taut::Expansion<SpotCoordinates, Sight> expansion(tri, *this);
  const auto out_of = [&](std::uint32_t t, int i) {
    for (int k = 0; k < 3; ++k)
      if (stand_.kind != Stand::Kind::vertex || k != i) vertex(t, k);
    expansion.spread({{}, &origin_}, t, i, expansion.ray(tri.triangles[t][Tri::ccw(i)]),
                     expansion.ray(tri.triangles[t][Tri::cw(i)]));
  };
  if (stand_.kind == Stand::Kind::vertex) return each_triangle(tri, tri.sectors[stand_.sector], out_of);
  // From the corner after the side that the robot is on, so that it sees its half-plane in order.
  for (int k = 1; k <= 3; ++k)
    if (stand_.kind == Stand::Kind::open || k != 3) out_of(stand_.t, (stand_.i + k) % 3);
}

void Sight::vertex(std::uint32_t t, int k) {
  const Tri& tri = places_.tri();
  const Tri::Sector& sector = tri.sectors[tri.sector_of[3 * t + static_cast<std::uint32_t>(k)]];
  if (!sector.reflex || sector.full || origin_.doubles == point(sector.vertex) || !is_tangent(sector)) return;
  if (range_.reaches(stand_.at, ExactPoint(point(sector.vertex)))) corners_.push_back(sector.vertex);
}

bool Sight::is_tangent(const Tri::Sector& sector) const {
  const Point v = point(sector.vertex);
  return orientation(origin_, v, point(sector.right)) * orientation(origin_, v, point(sector.left)) >= 0;
}

const Sight::Piece* Sight::piece_at(const ContourPlace& from, Contours::At edge, Turn turn) const {
  const HalfEdge e = places_.contours().edges(edge.contour)[edge.edge];
  const Spot at(from.stand.at);
  const std::uint32_t side = 3 * e.t + static_cast<std::uint32_t>(e.i);
  for (auto i = std::lower_bound(by_side_.begin(), by_side_.end(), std::pair(side, 0U));
       i != by_side_.end() && i->first == side; ++i) {
    const Piece& piece = pieces_[i->second];
    const int right = orientation(origin_, at, point(piece.right)), left = orientation(origin_, at, point(piece.left));
    if (turn == Turn::left ? right <= 0 && left > 0 : right < 0 && left >= 0) return &piece;
  }
  return nullptr;
}

Sight::Step Sight::step(const ContourPlace& from, Turn turn) const {
  const Contours::At edge = places_.ahead(from, turn);
  const Point tail = places_.contours().tail(edge), head = places_.contours().head(edge);
  const ContourPlace whole = places_.next_vertex(from, turn);
  // Seen edge-on.
  if (orientation(origin_, tail, head) == 0) return within_range(from, edge, {Step::Kind::vertex, whole, kNone});
  Step step{Step::Kind::shadow, from, kNone};
  // Several pieces in a row: what is between them is seen edge-on.
  while (const Piece* piece = piece_at(step.end, edge, turn)) {
    const std::uint32_t ray = turn == Turn::left ? piece->left : piece->right;
    if (orientation(origin_, point(ray), turn == Turn::left ? head : tail) == 0)
      return within_range(from, edge, {Step::Kind::vertex, whole, kNone});
    step.end = places_.side(edge, crossing(origin_, Spot(point(ray)), tail, head));
    step.corner = ray;
  }
  return within_range(from, edge, std::move(step));
}

Sight::Step Sight::within_range(const ContourPlace& from, Contours::At edge, Step step) const {
  if (range_.reaches(stand_.at, step.end.stand.at)) return step;
  const ExactPoint &a = from.stand.at, &b = step.end.stand.at;
  const Point x = as_point(stand_.at), p = as_point(a), q = as_point(b);
  const double dx = q.x - p.x, dy = q.y - p.y, whole = dx * dx + dy * dy;
  const double along = (dx * (x.x - p.x) + dy * (x.y - p.y)) / whole;
  const double off = (dx * (x.y - p.y) - dy * (x.x - p.x)) / std::sqrt(whole);
  const double part = along + std::sqrt(std::max(0.0, (range_.value() - off) * (range_.value() + off) / whole));
  step.kind = Step::Kind::range;
  if (part > 0)
    for (double less = 0x1p-45; less <= 0x1p-30; less *= 8) {
      const Rational t = std::clamp(part - less, 0.0, 1.0);
      const ExactPoint end{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
      if (t == 0 || !range_.reaches(stand_.at, end)) continue;
      step.end = places_.side(edge, end);
      return step;
    }
  step.end = from;
  return step;
}

// ---- the picture -------------------------------------------------------------------------------------------------

Point Sight::ray_end(const Piece& piece, std::uint32_t ray) const {
  const auto& corners = places_.tri().triangles[piece.t];
  const Point a = point(corners[Tri::ccw(piece.i)]), b = point(corners[Tri::cw(piece.i)]);
  for (const Point p : {a, b})
    if (orientation(origin_, point(ray), p) == 0) return p;
  return as_point(crossing(origin_, Spot(point(ray)), a, b));
}

void Sight::clip(Point a, Point b, Ring& ring) const {
  const Point x = as_point(stand_.at);
  const double r = range_.value();
  const double dx = b.x - a.x, dy = b.y - a.y, whole = std::max(dx * dx + dy * dy, 1e-300);
  const double along = (dx * (x.x - a.x) + dy * (x.y - a.y)) / whole;
  const double off = (dx * (x.y - a.y) - dy * (x.x - a.x)) / std::sqrt(whole);
  const double half = std::isinf(r) ? 2 + std::abs(along) : std::sqrt(std::max(0.0, (r - off) * (r + off) / whole));
  const auto at = [&](double t) { return Point{a.x + t * dx, a.y + t * dy}; };
  const auto arc = [&](Point p, Point q) {
    const double from = std::atan2(p.y - x.y, p.x - x.x);
    const double turn = std::remainder(std::atan2(q.y - x.y, q.x - x.x) - from, 2 * std::numbers::pi);
    const int n = std::max(1, static_cast<int>(std::ceil(turn / kChord)));
    for (int k = 0; k <= n; ++k)
      ring.push_back({x.x + r * std::cos(from + turn * k / n), x.y + r * std::sin(from + turn * k / n)});
  };
  const double first = std::clamp(along - half, 0.0, 1.0), last = std::clamp(along + half, 0.0, 1.0);
  if (first > 0) arc(a, at(first));
  if (first < last) ring.insert(ring.end(), {at(first), at(last)});
  if (last < 1 && last > first) arc(at(last), b);
  if (first == 0 && last == 0) arc(a, b);
}

Ring Sight::ring() const {
  Ring ring;
  for (const Piece& piece : pieces_) clip(ray_end(piece, piece.right), ray_end(piece, piece.left), ring);
  if (stand_.kind != Stand::Kind::open) ring.push_back(as_point(stand_.at));
  return ring;
}

}  // namespace taut::bug::detail
