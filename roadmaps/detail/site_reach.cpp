#include <taut/roadmaps/detail/site_reach.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <taut/geometry/segment_distance.h>

namespace taut::detail {

namespace {

constexpr int kAngles = 16;

/// The discs that touch a corner from within an angle around a direction.
struct Angle {
  Point middle;
  double cosine, sine;  // of half the angle
  double most = std::numeric_limits<double>::infinity();

  /// No disc of the angle may hold w, which is relative to the corner, in its inside.
  void bound(Point w) {
    const double along = middle.x * w.x + middle.y * w.y, off = std::abs(middle.x * w.y - middle.y * w.x);
    const double least = along * cosine - off * sine;
    if (least > 0) most = std::min(most, (w.x * w.x + w.y * w.y) / (2 * least));
  }
  void bound(Point w, Point v) {
    bound(w);
    bound(v);
    const Point f{v.x - w.x, v.y - w.y};
    const double all = f.x * f.x + f.y * f.y, foot = -(f.x * w.x + f.y * w.y) / all;
    if (foot > 0 && foot < 1) bound({w.x + foot * f.x, w.y + foot * f.y});
    const double turn = middle.x * f.y - middle.y * f.x, hit = -(middle.x * w.y - middle.y * w.x) / turn;
    if (turn != 0 && hit > 0 && hit < 1) bound({w.x + hit * f.x, w.y + hit * f.y});
  }
};

/// Away from the walls that end in the corner.
std::array<Angle, kAngles> angles_of(const TangentSite& site) {
  const Point first = site.cones.first(), last = site.cones.last();
  const double begin = std::atan2(first.y, first.x);
  const double wide = std::atan2(first.x * last.y - first.y * last.x, first.x * last.x + first.y * last.y);
  const double from = begin + std::max(0.0, wide) + M_PI / 2, to = begin + 3 * M_PI / 2;
  const double half = (to - from) / (2 * kAngles) + 1e-9;
  std::array<Angle, kAngles> angles{};
  for (int i = 0; i < kAngles; ++i) {
    const double at = from + (2 * i + 1) * (to - from) / (2 * kAngles);
    angles[i] = {{std::cos(at), std::sin(at)}, std::cos(half), std::sin(half)};
  }
  return angles;
}

Box around(Point p, double reach) { return {{p.x - reach, p.y - reach}, {p.x + reach, p.y + reach}}; }

}  // namespace

double site_reach(const TangentGround& ground, const TangentSite& site, double extent) {
  const WallIndex& walls = ground.walls.walls();
  double size = extent * 0x1p-8;
  while (true) {
    std::array<Angle, kAngles> angles{};
    if (site.round) angles = angles_of(site);
    double nearest = std::numeric_limits<double>::infinity();
    walls.walls_meeting(around(site.at, size), [&](std::uint32_t c) {
      const Segment s = walls.segment(c);
      if (!site.round) nearest = std::min(nearest, segment_distance_interval({site.at, site.at}, s).hi);
      if (!site.round || s.a == site.at || s.b == site.at) return;
      const Point w{s.a.x - site.at.x, s.a.y - site.at.y}, v{s.b.x - site.at.x, s.b.y - site.at.y};
      for (Angle& angle : angles) angle.bound(w, v);
    });
    if (site.round)
      nearest = std::max_element(angles.begin(), angles.end(), [](const Angle& a, const Angle& b) {
                  return a.most < b.most;
                })->most;
    if (nearest <= size || size >= 4 * extent)
      return std::min(nearest * (1 + 1e-9) + (extent + std::abs(site.at.x) + std::abs(site.at.y)) * 0x1p-40,
                      4 * extent);
    size *= 2;
  }
}

SiteRadii site_radii(const TangentGround& ground, const TangentSite& site, double reach) {
  SiteRadii result{reach};
  if (!site.round) return result;
  const WallIndex& walls = ground.walls.walls();
  walls.walls_meeting(around(site.at, 2.001 * reach), [&](std::uint32_t c) {
    const Segment s = walls.segment(c);
    if (s.a == site.at || s.b == site.at) return;
    const Interval distance = segment_distance_interval({site.at, site.at}, s);
    const auto direction = direction_forbidden(site.at, distance.hi, s.a, s.b);
    if (direction) result.forbidden.push_back({*direction, {distance.lo / 2, distance.hi / 2}, c});
  });
  std::sort(result.forbidden.begin(), result.forbidden.end(),
            [](const SiteRadii::Forbidden& a, const SiteRadii::Forbidden& b) {
              return a.half.lo != b.half.lo ? a.half.lo < b.half.lo : a.wall < b.wall;
            });
  return result;
}

}  // namespace taut::detail
