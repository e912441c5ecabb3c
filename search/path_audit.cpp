#include <taut/search/path_audit.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <taut/geometry/box.h>
#include <taut/geometry/box_index.h>
#include <taut/geometry/errors.h>
#include <taut/geometry/segment_distance.h>
#include <taut/roadmaps/bezier.h>
#include <taut/roadmaps/tangent_graph.h>
#include <taut/roadmaps/wall_index.h>
#include <taut/search/arc_search.h>
#include <taut/search/detail/leg_contacts.h>
#include <taut/search/shortest_path.h>
#include <taut/search/verify.h>

namespace taut {

namespace {

bool is_disc(const Footprint& robot) { return robot.kind() == Footprint::Kind::disc; }

Segment side(const Constraint& c) { return {c.a, c.b}; }

Point point_on(const Segment& leg, double part) {
  return {leg.a.x + part * (leg.b.x - leg.a.x), leg.a.y + part * (leg.b.y - leg.a.y)};
}

double distance_at(const Segment& leg, double part, const Segment& wall) {
  const Point p = point_on(leg, part), q = foot_on(wall, p);
  return std::hypot(q.x - p.x, q.y - p.y);
}

/// Where on the leg the wall is first nearer than r, given that it is somewhere. The distance is convex along the leg.
double entry(const Segment& leg, const Segment& wall, double r) {
  if (distance_at(leg, 0, wall) < r) return 0;
  double low = 0, high = 1;
  for (int i = 0; i < 100 && distance_at(leg, high, wall) >= r; ++i) {  // towards the least
    const double a = low + (high - low) / 3, b = high - (high - low) / 3;
    if (distance_at(leg, a, wall) <= distance_at(leg, b, wall))
      high = b;
    else
      low = a;
  }
  low = 0;
  for (int i = 0; i < 60; ++i) {
    const double middle = low + (high - low) / 2;
    (distance_at(leg, middle, wall) < r ? high : low) = middle;
  }
  return high;
}

std::vector<Segment> legs_of(const std::vector<Point>& points) {
  std::vector<Segment> legs;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) legs.push_back({points[i], points[i + 1]});
  if (legs.empty()) legs.push_back({points.front(), points.front()});
  return legs;
}

}  // namespace

struct PathAuditor::Impl {
  Impl(const World& world, const Footprint& of, std::span<const Point> places)
      : robot(of),
        space(world, is_disc(of) ? Footprint::point() : of, places),
        index(space),
        openings(opening_boxes()) {
    for (std::uint32_t c = 0; c < space.constraints().size(); ++c)
      if (!index.is_opening(c)) walls.push_back(space.constraints()[c]);
  }

  std::vector<Box> opening_boxes() const {
    std::vector<Box> boxes;
    for (std::uint32_t c = 0; c < space.constraints().size(); ++c)
      if (index.is_opening(c)) boxes.push_back(box_around(space.constraints()[c].a, space.constraints()[c].b));
    return boxes;
  }

  /// Of legs that keep a distance from all walls: they leave where they began through openings alone.
  bool stays_inside(const std::vector<Segment>& legs) const {
    bool stays = space.locate(legs.front().a).kind != Location::Kind::outside;
    for (const Segment& leg : legs)
      if (stays) openings.meeting(box_around(leg.a, leg.b), [&](std::uint32_t) { stays = false; });
    return stays;
  }

  bool is_too_near(const Segment& leg, const Segment& wall) const {
    const Point far{robot.radius(), 0};
    return compare_segment_distances(leg, wall, {}, {far, far}) < 0;
  }

  /// The first wall that the disc meets on the leg.
  std::optional<PathContact> met_on(const Segment& leg) const {
    double first = HUGE_VAL;
    std::uint32_t by = kNone;
    index.walls_meeting(widened(box_around(leg.a, leg.b), robot.radius()), [&](std::uint32_t i) {
      const Segment wall = side(space.constraints()[i]);
      if (!is_too_near(leg, wall)) return;
      const double part = entry(leg, wall, robot.radius());
      if (part > first || (part == first && i > by)) return;
      first = part;
      by = i;
    });
    if (by == kNone) return std::nullopt;
    const Point at = point_on(leg, first), on = foot_on(side(space.constraints()[by]), at);
    return PathContact{0, at, on, nearest_obstacle(space.world(), on)};
  }

  void find_contact(const std::vector<Segment>& legs, PathAudit& audit) const {
    for (std::size_t i = 0; i < legs.size(); ++i) {
      audit.contact = met_on(legs[i]);
      if (!audit.contact) continue;
      audit.contact->leg = i;
      audit.reason = fmt::format("leg {}, ({}, {}) to ({}, {}), comes nearer than {} to {}", i, legs[i].a.x,
                                 legs[i].a.y, legs[i].b.x, legs[i].b.y, robot.radius(), text(audit.contact->wall));
      return;
    }
  }

  /// Of the path of the reference point; touching is 0.
  void measure(const std::vector<Segment>& legs, PathAudit& audit) const {
    const detail::LegTree tree(legs, walls);
    const detail::LegContacts contacts = tree.contacts();
    std::uint32_t nearest = kNone;
    for (std::size_t i = 0; i < legs.size(); ++i)
      nearest =
          std::min({nearest, contacts.crossed[i], contacts.touching[i].empty() ? kNone : contacts.touching[i].front()});
    audit.clearance = 0;
    if (nearest == kNone) {
      const detail::NearestPiece piece = tree.nearest();
      audit.clearance = piece.distance;
      nearest = piece.constraint;
    }
    if (is_disc(robot)) audit.clearance = std::max(0.0, audit.clearance - robot.radius());
    if (nearest != kNone) audit.nearest = named(walls[nearest], legs);
  }

  NearObstacle named(const Constraint& wall, const std::vector<Segment>& legs) const {
    double least = HUGE_VAL;
    Point on = wall.a;
    for (const Segment& leg : legs) {
      const double distance = segment_distance_interval(leg, side(wall)).lo;
      if (distance >= least) continue;
      least = distance;
      for (const Point p : {wall.a, wall.b, foot_on(side(wall), leg.a), foot_on(side(wall), leg.b)}) {
        const Point q = foot_on(leg, p);
        if (std::hypot(q.x - p.x, q.y - p.y) <= distance * (1 + 1e-9)) on = p;
      }
    }
    return nearest_obstacle(space.world(), on);
  }

  const TangentGraph& tangents() {
    if (!graph) graph.emplace(space, robot.radius());
    return *graph;
  }

  Footprint robot;
  FreeSpace space;
  WallIndex index;
  BoxIndex openings;
  std::vector<Constraint> walls;  ///< without openings
  std::optional<TangentGraph> graph;
};

PathAuditor::PathAuditor(const World& world, const Footprint& robot, std::span<const Point> places)
    : impl_(std::make_shared<Impl>(world, robot, places)) {}

const FreeSpace& PathAuditor::space() const { return impl_->space; }

PathAudit PathAuditor::check(const std::vector<Point>& points) const {
  PathAudit audit;
  audit.length = Length(points);
  const bool is_readable = std::all_of(points.begin(), points.end(), [](Point p) {
    return std::abs(p.x) <= World::kLargest && std::abs(p.y) <= World::kLargest;
  });
  if (is_disc(impl_->robot) && is_readable && !points.empty()) {
    const std::vector<Segment> legs = legs_of(points);
    impl_->find_contact(legs, audit);
    audit.valid = audit.reason.empty() && impl_->stays_inside(legs);
    if (audit.valid || audit.contact) return audit;
  }
  const Path path{points, audit.length};
  const Point from = points.empty() ? Point{} : points.front(), to = points.empty() ? Point{} : points.back();
  const Verdict verdict = verify(path, impl_->space, from, Goal{to, {}});
  audit.valid = verdict.valid;
  audit.reason = verdict.reason;
  if (!verdict.valid && verdict.at) {
    const NearObstacle wall = nearest_obstacle(impl_->space.world(), *verdict.at);
    audit.contact = PathContact{verdict.leg, *verdict.at, *verdict.at, wall};
  }
  return audit;
}

PathAudit PathAuditor::audit(const std::vector<Point>& points) const {
  PathAudit audit = check(points);
  if (audit.valid) impl_->measure(legs_of(points), audit);
  return audit;
}

std::optional<ShortestLength> PathAuditor::shortest(Point from, Point to) const try {
  if (!is_disc(impl_->robot)) {
    const auto path = shortest_path(impl_->space, from, to);
    if (!path) return std::nullopt;
    return ShortestLength{path->length.value(), path->length.interval()};
  }
  const ArcSearchResult result = arc_search(impl_->tangents(), from, to);
  if (result.status != DiscStatus::found) return std::nullopt;
  return ShortestLength{result.path.value(), result.path.length};
} catch (const InputError&) {
  return std::nullopt;
}

}  // namespace taut
