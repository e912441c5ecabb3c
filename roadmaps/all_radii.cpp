#include <taut/roadmaps/all_radii.h>

#include <algorithm>
#include <numeric>

#include <taut/geometry/expects.h>
#include <taut/roadmaps/detail/leg_radii.h>
#include <taut/roadmaps/detail/site_reach.h>
#include <taut/roadmaps/exact/all_radii_parts.h>

namespace taut {

namespace {

/// No coordinate is larger, and no distance in the world.
double scale_of(const FreeSpace& space) {
  double scale = 1e-6;
  for (const Point p : space.triangulation().points) scale = std::max({scale, std::abs(p.x), std::abs(p.y)});
  return 4 * scale;
}

double extent_of(const FreeSpace& space) {
  const std::vector<Point>& points = space.triangulation().points;
  if (points.empty()) return 1;
  const auto [left, right] =
      std::minmax_element(points.begin(), points.end(), [](Point p, Point q) { return p.x < q.x; });
  const auto [low, high] =
      std::minmax_element(points.begin(), points.end(), [](Point p, Point q) { return p.y < q.y; });
  return std::max(right->x - left->x, high->y - low->y);
}

}  // namespace

AllRadiiParts::AllRadiiParts(const FreeSpace& space, const TellProgress& tell)
    : ground(std::make_shared<const TangentGround>(space)) {
  find_legs(tell);
  measure_legs();
}

AllRadiiParts::AllRadiiParts(std::shared_ptr<const TangentGround> common, std::vector<TangentName> names,
                             std::vector<std::uint32_t> first, std::vector<RadiusSpan> all)
    : ground(std::move(common)), legs(std::move(names)), first_span(std::move(first)), spans(std::move(all)) {
  measure_legs();
}

void AllRadiiParts::measure_legs() {
  const double extent = extent_of(ground->walls.space());
  least_radius = 0x1p-20 * extent;
  most_radius = 3.9 * extent;
  if (sites.empty())
    for (const TangentSite& site : ground->sites)
      sites.push_back(detail::site_radii(*ground, site, detail::site_reach(*ground, site, extent)));
  vectors_.reserve(legs.size());
  for (const TangentName& leg : legs) {
    const TangentFrame<Interval> frame({ground->sites[leg.from].at, 0}, {ground->sites[leg.to].at, 0}, 0);
    vectors_.push_back({frame.dx / frame.D, frame.dy / frame.D, frame.D});
  }
  first_end_.assign(sites.size() + 1, 0);
  for (const TangentName& leg : legs)
    for (const std::uint32_t site : {leg.from, leg.to}) ++first_end_[site + 1];
  std::partial_sum(first_end_.begin(), first_end_.end(), first_end_.begin());
  std::vector<std::uint32_t> next(first_end_.begin(), first_end_.end() - 1);
  ends_.resize(2 * legs.size());
  for (std::uint32_t i = 0; i < legs.size(); ++i) {
    ends_[next[legs[i].from]++] = 2 * i;
    ends_[next[legs[i].to]++] = 2 * i + 1;
  }
}

void AllRadiiParts::find_legs(const TellProgress& tell) {
  const double scale = scale_of(ground->walls.space()), extent = extent_of(ground->walls.space());
  const std::vector<TangentSite>& all = ground->sites;
  for (const TangentSite& site : all)
    sites.push_back(detail::site_radii(*ground, site, detail::site_reach(*ground, site, extent)));
  // Some room below the least radius that is asked about: ends of ranges are rounded.
  detail::LegRadii radii(*ground, scale, 0x1p-21 * extent);
  first_span.push_back(0);
  const auto sides = [](const TangentSite& site) { return site.round ? std::vector<int>{1, -1} : std::vector<int>{0}; };
  ProgressCount done("corners", all.size(), tell);
  for (std::uint32_t i = 0; i < all.size(); ++i, done.add()) {
    const TautCones cones = all[i].cones.reaching(sites[i].reach);
    for (const std::uint32_t v : ground->walls.seen_from_vertex(all[i].vertex, cones)) {
      const std::uint32_t j = ground->site_at[v];
      if (j == kNone || j <= i || all[j].vertex == all[i].vertex) continue;
      const Point back{all[i].at.x - all[j].at.x, all[i].at.y - all[j].at.y};
      if (!all[j].cones.reaching(sites[j].reach).may_lead(back)) continue;
      for (const int s : sides(all[i]))
        for (const int t : sides(all[j])) {
          const TangentName name{i, j, s, t};
          const std::vector<RadiusSpan> found = radii.spans(name, std::min(sites[i].reach, sites[j].reach));
          if (found.empty()) continue;
          legs.push_back(name);
          spans.insert(spans.end(), found.begin(), found.end());
          first_span.push_back(static_cast<std::uint32_t>(spans.size()));
        }
    }
  }
}

bool AllRadiiParts::has(std::size_t leg, double r) const {
  bool asks = false;
  for (std::uint32_t i = first_span[leg]; i < first_span[leg + 1]; ++i) {
    if (r < spans[i].from || r > spans[i].to) continue;
    if (spans[i].certain) return true;
    asks = true;
  }
  return asks && is_free_tangent(*ground, legs[leg], r);
}

FoundTangent AllRadiiParts::tangent(std::size_t leg, double r) const {
  const TangentName& name = legs[leg];
  const Vector& d = vectors_[leg];
  const Interval k = meant<Interval>(r) * Interval(double(name.to_side - name.from_side));
  const Interval length = root(d.squared - k * k);
  const TangentEnd from{ground->sites[name.from].at, name.from_side}, to{ground->sites[name.to].at, name.to_side};
  // The line's normal, to its left.
  const Interval x = k * d.x - length * d.y, y = k * d.y + length * d.x;
  const auto turned = [](const Interval& v, int side) { return side == 0 ? Interval(0) : side > 0 ? -v : v; };
  return {name,
          {TangentPoint(from, to, r, turned(x, from.side), turned(y, from.side)),
           TangentPoint({to.centre, -to.side}, {from.centre, -from.side}, r, turned(x, to.side), turned(y, to.side)),
           length}};
}

void AllRadiiParts::look_around(std::uint32_t site, double r, CircleObstacles& result) const {
  result.forbidden.clear();
  result.crossings.clear();
  const Point centre = ground->sites[site].at;
  const Interval wanted = meant<Interval>(r);
  const auto is_near = [&](const SiteRadii::Forbidden& forbidden) {
    if (forbidden.half.hi < wanted.lo) return true;
    const Segment s = ground->walls.walls().segment(forbidden.wall);
    return direction_forbidden(centre, r, s.a, s.b).has_value();
  };
  for (const SiteRadii::Forbidden& forbidden : sites[site].forbidden) {
    if (forbidden.half.lo >= wanted.hi) break;
    if (is_near(forbidden)) result.forbidden.push_back(forbidden.direction);
  }
  ground->walls.add_crossings(centre, r, result);
}

TangentGraph AllRadiiParts::at_radius(double r) const {
  if (!covers(r)) return TangentGraph(std::make_shared<const TangentParts>(ground, r));
  std::vector<FoundTangent> tangents;
  tangents.reserve(legs.size());
  for (std::size_t i = 0; i < legs.size(); ++i)
    if (has(i, r)) tangents.push_back(tangent(i, r));
  CircleObstacles obstacles;
  const auto around = [&](std::uint32_t site) -> const CircleObstacles& {
    look_around(site, r, obstacles);
    return obstacles;
  };
  return TangentGraph(std::make_shared<const TangentParts>(ground, r, tangents, around));
}

AllRadii::AllRadii(const FreeSpace& space, const TellProgress& tell) {
  TAUT_EXPECTS(space.footprint().kind() == Footprint::Kind::point);
  parts_ = std::make_shared<const AllRadiiParts>(space, tell);
}

const FreeSpace& AllRadii::space() const { return parts_->ground->walls.space(); }
double AllRadii::least_radius() const { return parts_->least_radius; }
std::size_t AllRadii::corner_count() const { return parts_->sites.size(); }
std::size_t AllRadii::leg_count() const { return parts_->legs.size(); }
std::size_t AllRadii::span_count() const { return parts_->spans.size(); }

TangentGraph AllRadii::at_radius(double r) const {
  TAUT_EXPECTS(r > 0 && r <= World::kLargest);
  return parts_->at_radius(r);
}

RadiiLeg AllRadii::leg(std::size_t i) const {
  const TangentName& name = parts_->legs[i];
  const auto first = parts_->spans.begin();
  return {parts_->ground->sites[name.from].at,
          parts_->ground->sites[name.to].at,
          name.from_side,
          name.to_side,
          {first + parts_->first_span[i], first + parts_->first_span[i + 1]}};
}

}  // namespace taut
