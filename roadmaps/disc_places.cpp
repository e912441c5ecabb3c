#include <taut/roadmaps/disc_places.h>

#include <taut/geometry/exact/numbers.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <taut/geometry/exact/exact_point.h>
#include <taut/geometry/expects.h>
#include <taut/geometry/segment_distance.h>
#include <taut/geometry/written.h>
#include <taut/roadmaps/detail/disc_search.h>
#include <taut/roadmaps/wall_index.h>

namespace taut {

namespace {

using detail::DiscCandidate;

bool is_nearer(Point p, const Segment& s, double r) {
  const Interval distance = segment_distance_interval({p, p}, s), wanted = written::enclosure(r);
  if (distance.lo >= wanted.hi) return false;
  if (distance.hi < wanted.lo) return true;
  const ExactPoint a(s.a), b(s.b), q(p);
  const Rational ux = b.x - a.x, uy = b.y - a.y, vx = q.x - a.x, vy = q.y - a.y, uu = ux * ux + uy * uy;
  const Rational along = vx * ux + vy * uy, off = ux * vy - uy * vx, r2 = meaning(r) * meaning(r);
  if (along <= 0) return vx * vx + vy * vy < r2;
  if (along < uu) return off * off < r2 * uu;
  return (vx - ux) * (vx - ux) + (vy - uy) * (vy - uy) < r2;
}

double distance_of(Point p, Point q) { return segment_distance({p, p}, {q, q}); }

}  // namespace

struct DiscPlaces::Impl {
  WallIndex walls;
  double r;
  DecimalUnit unit;

  bool is_free(Point p) const {
    if (walls.space().locate(p).kind == Location::Kind::outside) return false;
    const double more = 1e-12 * (std::abs(p.x) + std::abs(p.y) + r), reach = r + more;
    bool free = true;
    walls.walls_meeting({{p.x - reach, p.y - reach}, {p.x + reach, p.y + reach}}, [&](std::uint32_t c) {
      if (free && is_nearer(p, walls.segment(c), r)) free = false;
    });
    return free;
  }

  /// The free decimals beside a candidate: those around it, the nearest first, then further and further outwards.
  std::optional<Point> free_beside(Point p, const DiscCandidate& candidate) const {
    const Rational x = meaning(p.x) + Rational(candidate.at.x), y = meaning(p.y) + Rational(candidate.at.y);
    const Point centre{unit.nearest(x), unit.nearest(y)};
    if (is_free(centre)) return centre;
    if (const auto q = free_around(centre, {x, y})) return q;
    const double first = std::abs(unit.step(centre.x, 1) - centre.x);
    for (double step = 2 * first; step < 1e-3 * r; step *= 2) {
      const Point q{unit.nearest(x + Rational(step * candidate.outwards.x)),
                    unit.nearest(y + Rational(step * candidate.outwards.y))};
      if (is_free(q)) return q;
    }
    return std::nullopt;
  }

  std::optional<Point> free_around(Point centre, const ExactPoint& exact) const {
    std::vector<std::pair<double, Point>> around;
    for (int i = -2; i <= 2; ++i)
      for (int j = -2; j <= 2; ++j) {
        const Point q{unit.step(centre.x, i), unit.step(centre.y, j)};
        around.emplace_back(displacement(exact, q), q);
      }
    std::sort(around.begin(), around.end());
    for (const auto& [distance, q] : around)
      if (is_free(q)) return q;
    return std::nullopt;
  }

  std::uint32_t nearest_constraint(Point p) const { return walls.space().clearance(p).constraint; }
};

DiscPlaces::DiscPlaces(const FreeSpace& space, double r)
    : impl_(std::make_shared<const Impl>(Impl{WallIndex(space), r, DecimalUnit(space.world().box())})) {
  TAUT_EXPECTS(space.footprint().kind() == Footprint::Kind::point && r > 0);
}

const FreeSpace& DiscPlaces::space() const { return impl_->walls.space(); }
double DiscPlaces::radius() const { return impl_->r; }
bool DiscPlaces::is_free(Point p) const { return impl_->is_free(p); }

std::optional<FreePlace> DiscPlaces::nearest(Point p) const {
  if (is_free(p)) return FreePlace{p, 0, 0, kNone};
  std::optional<Point> best;
  double distance = std::numeric_limits<double>::infinity(), least = distance;
  detail::DiscSearch(impl_->walls, impl_->r, p).run([&](const DiscCandidate& candidate) {
    least = std::min(least, candidate.distance);
    const std::optional<Point> q = impl_->free_beside(p, candidate);
    if (!q) return distance;
    const double far = distance_of(p, *q);
    if (far < distance || (far == distance && *q < *best)) {
      best = q;
      distance = far;
    }
    return distance;
  });
  if (!best) return std::nullopt;
  const double rounding = distance > least ? std::nextafter(std::nextafter(distance, HUGE_VAL) - least, HUGE_VAL) : 0;
  return FreePlace{*best, distance, rounding, impl_->nearest_constraint(*best)};
}

}  // namespace taut
