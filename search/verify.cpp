#include <taut/search/verify.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <taut/geometry/contact.h>
#include <taut/geometry/text.h>
#include <taut/geometry/written.h>
#include <taut/search/detail/leg_contacts.h>

namespace taut {

namespace {

using detail::LegContacts;

std::string named(const Constraint& c) {
  return (c.is_wall() ? "the wall " : "the outline ") + text(c.a) + " to " + text(c.b);
}

/// Where the leg crosses the constraint, as a part of the leg. Precondition: it does.
double crossing(const Segment& leg, const Constraint& c) {
  const double dx = leg.b.x - leg.a.x, dy = leg.b.y - leg.a.y, ex = c.b.x - c.a.x, ey = c.b.y - c.a.y;
  const double part = ((c.a.x - leg.a.x) * ey - (c.a.y - leg.a.y) * ex) / (dx * ey - dy * ex);
  return std::isfinite(part) ? std::clamp(part, 0.0, 1.0) : 0.0;
}

Point point_on(const Segment& leg, double part) {
  return {leg.a.x + part * (leg.b.x - leg.a.x), leg.a.y + part * (leg.b.y - leg.a.y)};
}

bool readable(Point p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::abs(p.x) <= World::kLargest &&
         std::abs(p.y) <= World::kLargest;
}

bool inside(Point p, const Polygon& polygon) {
  if (written::side_of_ring(p, polygon.outer) < 0) return false;
  return std::none_of(polygon.holes.begin(), polygon.holes.end(),
                      [p](const Ring& hole) { return written::side_of_ring(p, hole) > 0; });
}

bool inside_any(Point p, const std::vector<Polygon>& polygons) {
  return std::any_of(polygons.begin(), polygons.end(), [p](const Polygon& polygon) { return inside(p, polygon); });
}

bool lies_inside(const Box& box, Point p) {
  return box.min.x < p.x && p.x < box.max.x && box.min.y < p.y && p.y < box.max.y;
}

Point middle_of(const Box& box) {
  return {box.min.x + (box.max.x - box.min.x) / 2, box.min.y + (box.max.y - box.min.y) / 2};
}

/// One check in progress.
class Verification {
 public:
  Verification(const Path& path, const FreeSpace& space, const Goal& goal)
      : path_(path), space_(space), goal_(goal), constraints_(space.constraints()) {}

  Verdict run(Point from) {
    if (!ends_stand(from)) return verdict_;
    lay_legs();
    const detail::LegTree tree(legs_, constraints_);
    contacts_ = tree.contacts();
    measure_clearance();
    if (follow()) verdict_.valid = length_stands();
    return verdict_;
  }

 private:
  bool refuse(std::size_t leg, std::string reason) {
    verdict_.leg = leg;
    verdict_.reason = std::move(reason);
    return false;
  }

  std::size_t last_leg() const { return path_.points.size() < 2 ? 0 : path_.points.size() - 2; }
  std::string opening(std::size_t leg) const {
    return "leg " + std::to_string(leg) + ", " + text(legs_[leg].a) + " to " + text(legs_[leg].b) + ", ";
  }

  bool ends_stand(Point from);
  bool ends_in_goal();
  void lay_legs();
  void measure_clearance();
  bool starts_free(Sectors& sectors);
  bool follow();
  bool follow_leg(std::size_t leg, Sectors& sectors);
  void find_crossing(std::size_t leg);
  bool enters_room(const Sectors& sectors);
  bool length_stands();
  std::string obstruction(const LegPassage& passage) const;

  const Path& path_;
  const FreeSpace& space_;
  const Goal& goal_;
  const std::vector<Constraint>& constraints_;
  std::vector<Segment> legs_;
  LegContacts contacts_;
  Verdict verdict_;
};

bool Verification::ends_stand(Point from) {
  const auto& points = path_.points;
  if (points.empty()) return refuse(0, "the path has no points");
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!readable(points[i]))
      return refuse(i == 0 ? 0 : i - 1,
                    "point " + std::to_string(i) + ", " + text(points[i]) + ", is not a finite point in range");
  if (points.front() != from) return refuse(0, "the path starts at " + text(points.front()) + ", not at " + text(from));
  return ends_in_goal();
}

bool Verification::ends_in_goal() {
  const Point end = path_.points.back();
  if (goal_.point == end) return true;
  const auto holds = [end](const Box& box) { return box.contains(end); };
  if (std::any_of(goal_.room.begin(), goal_.room.end(), holds)) return true;
  const std::string ends = "the path ends at " + text(end);
  if (!goal_.room.empty()) return refuse(last_leg(), ends + ", outside the goal room");
  return refuse(last_leg(), goal_.point ? ends + ", not at " + text(*goal_.point) : ends + ", but there is no goal");
}

void Verification::lay_legs() {
  const auto& points = path_.points;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) legs_.push_back({points[i], points[i + 1]});
  if (legs_.empty()) legs_.push_back({points[0], points[0]});
}

void Verification::measure_clearance() {
  for (std::size_t leg = 0; leg < legs_.size(); ++leg) {
    const auto& touching = contacts_.touching[leg];
    verdict_.nearest =
        std::min({verdict_.nearest, contacts_.crossed[leg], touching.empty() ? kNone : touching.front()});
  }
  if (verdict_.nearest != kNone) return;
  const auto nearest = detail::LegTree(legs_, constraints_).nearest();
  verdict_.clearance = nearest.distance;
  verdict_.nearest = nearest.constraint;
}

bool Verification::starts_free(Sectors& sectors) {
  const Point start = path_.points.front();
  sectors = star_at(start, constraints_, contacts_.touching[0]).free_sectors();
  if (sectors.empty()) return refuse(0, "the path starts at " + text(start) + ", where obstacles leave no room");
  // Everything after it is reached without crossing a constraint, so only the start is located.
  if (!inside_any(start, space_.polygons()))
    return refuse(0, "the path starts at " + text(start) + ", inside an obstacle or outside the world");
  return true;
}

bool Verification::follow() {
  Sectors sectors;
  if (!starts_free(sectors)) return false;
  for (std::size_t leg = 0; leg < legs_.size(); ++leg)
    if (!follow_leg(leg, sectors)) return false;
  return enters_room(sectors);
}

bool Verification::follow_leg(std::size_t leg, Sectors& sectors) {
  if (contacts_.crossed[leg] != kNone) {
    find_crossing(leg);
    return refuse(leg, opening(leg) + "crosses " + named(constraints_[verdict_.blocker]));
  }
  LegPassage passage = pass(legs_[leg], sectors, constraints_, contacts_.touching[leg]);
  if (passage.blocked) {
    verdict_.at = passage.at;
    if (!passage.pieces.empty()) verdict_.blocker = passage.pieces.front();
    return refuse(leg, opening(leg) + obstruction(passage));
  }
  sectors = std::move(passage.sectors);
  return true;
}

void Verification::find_crossing(std::size_t leg) {
  double first = HUGE_VAL;
  for (std::uint32_t i = contacts_.crossed[leg]; i < constraints_.size(); ++i) {
    if (contact(legs_[leg], constraints_[i]) != Contact::cross) continue;
    const double part = crossing(legs_[leg], constraints_[i]);
    if (part < first) verdict_.blocker = i;
    first = std::min(first, part);
  }
  verdict_.at = point_on(legs_[leg], first);
}

bool Verification::enters_room(const Sectors& sectors) {
  const Point end = path_.points.back();
  if (goal_.point == end) return true;
  const Star star = star_at(end, constraints_, contacts_.touching.back());
  for (const Box& box : goal_.room)
    if (box.contains(end) && (lies_inside(box, end) || star.leave(sectors, middle_of(box)) != kNoSide)) return true;
  return refuse(last_leg(),
                "the path ends at " + text(end) + ", on the rim of the goal room, but cannot enter it from there");
}

bool Verification::length_stands() {
  const Length exact(path_.points);
  if (path_.length == exact) return true;
  return refuse(last_leg(), "the claimed length " + text(path_.length.value()) + " is not the length of the points, " +
                                text(exact.value()));
}

std::string Verification::obstruction(const LegPassage& passage) const {
  const auto& pieces = passage.pieces;
  if (pieces.empty()) return "has no room at " + text(passage.at);
  if (pieces.size() == 1) return "passes through " + named(constraints_[pieces[0]]) + " at " + text(passage.at);
  const std::string more = pieces.size() > 2 ? " and " + std::to_string(pieces.size() - 2) + " more" : "";
  return "slips through the joint " + text(passage.at) + " of " + named(constraints_[pieces[0]]) + " and " +
         named(constraints_[pieces[1]]) + more;
}

}  // namespace

Verdict verify(const Path& path, const FreeSpace& space, Point from, const Goal& to) {
  return Verification(path, space, to).run(from);
}

}  // namespace taut
