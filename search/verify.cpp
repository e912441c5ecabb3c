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
#include <taut/search/detail/leg_contacts.h>

namespace taut {

namespace {

using detail::LegContacts;

std::string named(const Constraint& c) {
  return (c.is_wall() ? "the wall " : "the outline ") + text(c.a) + " to " + text(c.b);
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

/// What stops a path, leg by leg.
class Pieces {
 public:
  /// What a leg meets: of a vector of pieces, those that it touches, ascending, and the lowest that it crosses.
  struct Met {
    std::span<const Constraint> pieces;
    std::span<const std::uint32_t> touching;
    std::uint32_t crossed = kNone;
  };

  virtual ~Pieces() = default;
  /// Until it is asked for another leg.
  virtual Met met(std::size_t leg) = 0;
  /// One that some leg meets: the lowest, where their numbers say more than for one leg. kNone: there is none.
  virtual std::uint32_t any_met() = 0;
  /// Can a path begin there?
  virtual bool holds(Point p) const = 0;
  /// Of legs that meet nothing.
  virtual detail::NearestPiece nearest() const = 0;
};

/// All constraints, by a tree over the legs.
class AllPieces : public Pieces {
 public:
  AllPieces(const FreeSpace& space, const std::vector<Segment>& legs)
      : space_(space), tree_(legs, space.constraints()), contacts_(tree_.contacts()) {}

  Met met(std::size_t leg) override { return {space_.constraints(), contacts_.touching[leg], contacts_.crossed[leg]}; }
  std::uint32_t any_met() override {
    std::uint32_t lowest = *std::min_element(contacts_.crossed.begin(), contacts_.crossed.end());
    for (const auto& touching : contacts_.touching)
      if (!touching.empty()) lowest = std::min(lowest, touching.front());
    return lowest;
  }
  bool holds(Point p) const override { return inside_any(p, space_.polygons()); }
  detail::NearestPiece nearest() const override { return tree_.nearest(); }

 private:
  const FreeSpace& space_;
  detail::LegTree tree_;
  LegContacts contacts_;
};

/// Those of the cells that a leg passes, nothing else of the space is looked at.
class PiecesAlong : public Pieces {
 public:
  PiecesAlong(const CellPlan& plan, const std::vector<Segment>& legs) : plan_(plan), legs_(legs) {}

  Met met(std::size_t leg) override {
    pieces_.clear();
    touching_.clear();
    std::uint32_t crossed = kNone;
    plan_.append_along(legs_[leg], pieces_);
    for (std::uint32_t i = 0; i < pieces_.size(); ++i) {
      const Contact kind = contact(legs_[leg], pieces_[i]);
      if (kind == Contact::touch) touching_.push_back(i);
      if (kind == Contact::cross) crossed = std::min(crossed, i);
    }
    return {pieces_, touching_, crossed};
  }
  std::uint32_t any_met() override {
    for (std::size_t leg = 0; leg < legs_.size(); ++leg)
      if (const Met met = this->met(leg); met.crossed != kNone || !met.touching.empty())
        return std::min(met.crossed, met.touching.empty() ? kNone : met.touching.front());
    return kNone;
  }
  bool holds(Point p) const override { return plan_.around(p).free != 0; }
  detail::NearestPiece nearest() const override;

 private:
  const CellPlan& plan_;
  const std::vector<Segment>& legs_;
  std::vector<Constraint> pieces_;
  std::vector<std::uint32_t> touching_;
};

/// In boxes around the legs that grow until one holds the nearest for sure.
detail::NearestPiece PiecesAlong::nearest() const {
  const Box all{{plan_.x(0), plan_.y(0)}, {plan_.x(plan_.columns()), plan_.y(plan_.rows())}};
  const double whole = (all.max.x - all.min.x) + (all.max.y - all.min.y);
  for (double reach = whole / 256;; reach *= 4) {
    std::vector<Constraint> near;
    for (const Segment& leg : legs_) plan_.append_within(widened(box_around(leg.a, leg.b), reach), near);
    if (near.empty() && reach <= whole) continue;
    const detail::NearestPiece nearest = detail::LegTree(legs_, near).nearest();
    if (nearest.distance <= reach || reach > whole) return {nearest.distance, kNone};
  }
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
  if (met.crossed != kNone) return refuse(leg, opening(leg) + "crosses " + named(met.pieces[met.crossed]));
  LegPassage passage = pass(legs_[leg], sectors, met.pieces, met.touching);
  if (passage.blocked) return refuse(leg, opening(leg) + obstruction(passage, met));
  sectors = std::move(passage.sectors);
  return true;
}

bool Verification::enters_room(const Sectors& sectors, const Pieces::Met& met) {
  const Point end = path_.points.back();
  if (goal_.point == end) return true;
  const Star star = star_at(end, met.pieces, met.touching);
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
