#include <taut/search/detail/met_pieces.h>

#include <algorithm>

#include <taut/geometry/box.h>
#include <taut/geometry/contact.h>
#include <taut/geometry/written.h>

namespace taut::detail {

namespace {

bool inside(Point p, const Polygon& polygon) {
  if (written::side_of_ring(p, polygon.outer) < 0) return false;
  return std::none_of(polygon.holes.begin(), polygon.holes.end(),
                      [p](const Ring& hole) { return written::side_of_ring(p, hole) > 0; });
}

bool inside_any(Point p, const std::vector<Polygon>& polygons) {
  return std::any_of(polygons.begin(), polygons.end(), [p](const Polygon& polygon) { return inside(p, polygon); });
}

}  // namespace

std::uint32_t AllPieces::any_met() {
  std::uint32_t lowest = *std::min_element(contacts_.crossed.begin(), contacts_.crossed.end());
  for (const auto& touching : contacts_.touching)
    if (!touching.empty()) lowest = std::min(lowest, touching.front());
  return lowest;
}

bool AllPieces::holds(Point p) const { return inside_any(p, space_.polygons()); }

PiecesAlong::Met PiecesAlong::met(std::size_t leg) {
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

std::uint32_t PiecesAlong::any_met() {
  for (std::size_t leg = 0; leg < legs_.size(); ++leg)
    if (const Met met = this->met(leg); met.crossed != kNone || !met.touching.empty())
      return std::min(met.crossed, met.touching.empty() ? kNone : met.touching.front());
  return kNone;
}

/// In boxes around the legs that grow until one holds the nearest for sure.
NearestPiece PiecesAlong::nearest() const {
  const Box all{{plan_.x(0), plan_.y(0)}, {plan_.x(plan_.columns()), plan_.y(plan_.rows())}};
  const double whole = (all.max.x - all.min.x) + (all.max.y - all.min.y);
  for (double reach = whole / 256;; reach *= 4) {
    std::vector<Constraint> near;
    for (const Segment& leg : legs_) plan_.append_within(widened(box_around(leg.a, leg.b), reach), near);
    if (near.empty() && reach <= whole) continue;
    const NearestPiece nearest = LegTree(legs_, near).nearest();
    if (nearest.distance <= reach || reach > whole) return {nearest.distance, kNone};
  }
}

}  // namespace taut::detail
