#include <taut/search/detail/leg_contacts.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include <taut/geometry/contact.h>
#include <taut/geometry/segment_distance.h>

namespace taut::detail {

namespace {

std::vector<Box> boxes_of(std::span<const Segment> legs) {
  std::vector<Box> result;
  result.reserve(legs.size());
  for (const Segment& leg : legs) result.push_back(box_around(leg.a, leg.b));
  return result;
}

/// Calls f with every number below n once, each far from the one before.
template <class F>
void for_each_scattered(std::size_t n, F f) {
  std::size_t step = std::max<std::size_t>(1, static_cast<std::size_t>(0.6180339887 * static_cast<double>(n)));
  while (std::gcd(step, n) != 1) ++step;
  for (std::size_t k = 0, i = 0; k < n; ++k, i = (i + step) % n) f(static_cast<std::uint32_t>(i));
}

Segment side(const Constraint& c) { return {c.a, c.b}; }

}  // namespace

struct LegTree::Candidate {
  std::uint32_t leg = kNone;
  std::uint32_t constraint = kNone;
  Interval distance{HUGE_VAL, HUGE_VAL};
};

LegTree::LegTree(std::span<const Segment> legs, std::span<const Constraint> constraints)
    : legs_(legs), constraints_(constraints), index_(boxes_of(legs)) {}

LegContacts LegTree::contacts() const {
  LegContacts result{std::vector<std::vector<std::uint32_t>>(legs_.size()),
                     std::vector<std::uint32_t>(legs_.size(), kNone)};
  for (std::uint32_t i = 0; i < constraints_.size(); ++i) {
    const Constraint& c = constraints_[i];
    index_.meeting(box_around(c.a, c.b), [&](std::uint32_t leg) {
      const Contact kind = contact(legs_[leg], c);
      if (kind == Contact::touch) result.touching[leg].push_back(i);
      if (kind == Contact::cross) result.crossed[leg] = std::min(result.crossed[leg], i);
    });
  }
  return result;
}

bool LegTree::closer(const Candidate& x, const Candidate& y) const {
  const auto piece = [&](const Candidate& c) { return side(constraints_[c.constraint]); };
  const auto quick = compare(x.distance, y.distance);
  const int sign = quick ? *quick : compare_segment_distances(legs_[x.leg], piece(x), legs_[y.leg], piece(y));
  return sign < 0 || (sign == 0 && x.constraint < y.constraint);
}

NearestPiece LegTree::nearest() const {
  if (constraints_.empty()) return {HUGE_VAL, kNone};
  Candidate best;
  for_each_scattered(constraints_.size(), [&](std::uint32_t i) {
    const Segment piece = side(constraints_[i]);
    index_.meeting(widened(box_around(piece.a, piece.b), best.distance.hi), [&](std::uint32_t leg) {
      const Candidate next{leg, i, segment_distance_interval(legs_[leg], piece)};
      if (best.leg == kNone || closer(next, best)) best = next;
    });
  });
  return {segment_distance(legs_[best.leg], side(constraints_[best.constraint])), best.constraint};
}

}  // namespace taut::detail
