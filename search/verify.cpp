#include <taut/search/verify.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <taut/geometry/box.h>
#include <taut/geometry/cell_plan.h>
#include <taut/geometry/contact.h>
#include <taut/geometry/text.h>
#include <taut/geometry/written.h>
#include <taut/search/detail/met_pieces.h>

namespace taut {

namespace {

using detail::AllPieces;
using detail::Pieces;
using detail::PiecesAlong;

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

bool lies_inside(const Box& box, Point p) {
  return box.min.x < p.x && p.x < box.max.x && box.min.y < p.y && p.y < box.max.y;
}

Point middle_of(const Box& box) {
  return {box.min.x + (box.max.x - box.min.x) / 2, box.min.y + (box.max.y - box.min.y) / 2};
}

/// Does one of the sectors lead into the box, on whose rim the star is? The one with the middle, if no piece leads into
/// the box from there; else those on both sides of such a piece, too.
bool leads_into(const Box& box, const Star& star, const Sectors& sectors) {
  const Point p = star.centre();
  const auto points_into = [&](Point q) {
    return (p.x != box.min.x || q.x > p.x) && (p.x != box.max.x || q.x < p.x) && (p.y != box.min.y || q.y > p.y) &&
           (p.y != box.max.y || q.y < p.y);
  };
  if (star.leave(sectors, middle_of(box)) != kNoSide) return true;
  return std::any_of(star.rays().begin(), star.rays().end(), [&](const Star::Ray& ray) {
    return points_into(ray.towards) && star.leave(sectors, ray.towards) != kNoSide;
  });
}

/// One check in progress.
class Verification {
 public:
  Verification(const Path& path, const FreeSpace& space, const Goal& goal) : path_(path), space_(space), goal_(goal) {}

  /// Against all constraints, or where there are cells against those along the path.
  Verdict run(Point from, bool along) {
    if (!ends_stand(from)) return verdict_;
    lay_legs();
    if (along)
      pieces_ = std::make_unique<PiecesAlong>(*space_.cells(), legs_);
    else
      pieces_ = std::make_unique<AllPieces>(space_, legs_);
    const bool followed = follow();
    measure_clearance();
    if (followed) verdict_.valid = length_stands();
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
  bool follow_leg(std::size_t leg, const Pieces::Met& met, Sectors& sectors);
  std::uint32_t first_crossed(std::size_t leg, const Pieces::Met& met);
  void blame(const Pieces::Met& met, std::uint32_t piece) { verdict_.blocker = met.are_all ? piece : kNone; }
  bool enters_room(const Sectors& sectors, const Pieces::Met& met);
  bool length_stands();
  static std::string obstruction(const LegPassage& passage, const Pieces::Met& met);

  const Path& path_;
  const FreeSpace& space_;
  const Goal& goal_;
  std::vector<Segment> legs_;
  std::unique_ptr<Pieces> pieces_;
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
  verdict_.nearest = pieces_->any_met();
  if (verdict_.nearest != kNone) return;
  const auto nearest = pieces_->nearest();
  verdict_.clearance = nearest.distance;
  verdict_.nearest = nearest.constraint;
}

bool Verification::starts_free(Sectors& sectors) {
  const Point start = path_.points.front();
  const Pieces::Met met = pieces_->met(0);
  sectors = star_at(start, met.pieces, met.touching).free_sectors();
  if (sectors.empty()) return refuse(0, "the path starts at " + text(start) + ", where obstacles leave no room");
  // Everything after it is reached without crossing a constraint, so only the start is located.
  if (!pieces_->holds(start))
    return refuse(0, "the path starts at " + text(start) + ", inside an obstacle or outside the world");
  return true;
}

bool Verification::follow() {
  Sectors sectors;
  if (!starts_free(sectors)) return false;
  Pieces::Met met;
  for (std::size_t leg = 0; leg < legs_.size(); ++leg)
    if (met = pieces_->met(leg); !follow_leg(leg, met, sectors)) return false;
  return enters_room(sectors, met);
}

bool Verification::follow_leg(std::size_t leg, const Pieces::Met& met, Sectors& sectors) {
  if (met.crossed != kNone) {
    const std::uint32_t crossed = first_crossed(leg, met);
    blame(met, crossed);
    return refuse(leg, opening(leg) + "crosses " + named(met.pieces[crossed]));
  }
  LegPassage passage = pass(legs_[leg], sectors, met.pieces, met.touching);
  if (passage.blocked) {
    verdict_.at = passage.at;
    if (!passage.pieces.empty()) blame(met, passage.pieces.front());
    return refuse(leg, opening(leg) + obstruction(passage, met));
  }
  sectors = std::move(passage.sectors);
  return true;
}

std::uint32_t Verification::first_crossed(std::size_t leg, const Pieces::Met& met) {
  std::uint32_t piece = met.crossed;
  double first = HUGE_VAL;
  for (std::uint32_t i = met.crossed; i < met.pieces.size(); ++i) {
    if (contact(legs_[leg], met.pieces[i]) != Contact::cross) continue;
    const double part = crossing(legs_[leg], met.pieces[i]);
    if (part < first) piece = i;
    first = std::min(first, part);
  }
  verdict_.at = point_on(legs_[leg], first);
  return piece;
}

bool Verification::enters_room(const Sectors& sectors, const Pieces::Met& met) {
  const Point end = path_.points.back();
  if (goal_.point == end) return true;
  const Star star = star_at(end, met.pieces, met.touching);
  for (const Box& box : goal_.room)
    if (box.contains(end) && (lies_inside(box, end) || leads_into(box, star, sectors))) return true;
  return refuse(last_leg(),
                "the path ends at " + text(end) + ", on the rim of the goal room, but cannot enter it from there");
}

bool Verification::length_stands() {
  const Length exact(path_.points);
  if (path_.length == exact) return true;
  return refuse(last_leg(), "the claimed length " + text(path_.length.value()) + " is not the length of the points, " +
                                text(exact.value()));
}

std::string Verification::obstruction(const LegPassage& passage, const Pieces::Met& met) {
  const auto& pieces = passage.pieces;
  if (pieces.empty()) return "has no room at " + text(passage.at);
  if (pieces.size() == 1) return "passes through " + named(met.pieces[pieces[0]]) + " at " + text(passage.at);
  const std::string more = pieces.size() > 2 ? " and " + std::to_string(pieces.size() - 2) + " more" : "";
  return "slips through the joint " + text(passage.at) + " of " + named(met.pieces[pieces[0]]) + " and " +
         named(met.pieces[pieces[1]]) + more;
}

}  // namespace

Verdict verify(const Path& path, const FreeSpace& space, Point from, const Goal& to) {
  return Verification(path, space, to).run(from, false);
}

Verdict verify_along(const Path& path, const FreeSpace& space, Point from, const Goal& to) {
  if (!space.cells()) return verify(path, space, from, to);
  const Verdict verdict = Verification(path, space, to).run(from, true);
  return verdict.valid ? verdict : verify(path, space, from, to);
}

}  // namespace taut
