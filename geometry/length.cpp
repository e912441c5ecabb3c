#include <taut/geometry/length.h>

#include <cmath>

#include <taut/geometry/detail/root_sum.h>
#include <taut/geometry/exact/as_double.h>
#include <taut/geometry/exact/twofold.h>

namespace taut {

namespace {

/// For differences so small or large that squares leave the range of doubles, and for what is no number.
double extreme_distance(Point p, Point q, Toward toward) {
  for (const double v : {p.x, p.y, q.x, q.y})
    if (!std::isfinite(v)) return std::hypot(p.x - q.x, p.y - q.y);
  const Rational dx = Rational(p.x) - Rational(q.x), dy = Rational(p.y) - Rational(q.y);
  return root_as_double(Rational(dx * dx + dy * dy), toward);
}

std::strong_ordering ordering(int sign) { return sign <=> 0; }

}  // namespace

Interval distance_interval(Point p, Point q) {
  const twofold::Square square =
      twofold::square_of(twofold::absolute_difference(p.x, q.x), twofold::absolute_difference(p.y, q.y));
  if (!twofold::is_regular(square)) return {extreme_distance(p, q, Toward::down), extreme_distance(p, q, Toward::up)};
  if (square.exact && square.sum > 0) return twofold::enclose_root(square.sum);
  const twofold::Root root = twofold::root_of(square);
  const double unsure = root.exact ? 0 : root.high * twofold::kRootError;
  return {twofold::step_down(root.high, root.low < unsure), twofold::step_up(root.high, root.low > -unsure)};
}

Length::Length(std::span<const Point> chain) {
  if (!chain.empty()) legs_.reserve(chain.size() - 1);
  for (std::size_t i = 1; i < chain.size(); ++i) add(chain[i - 1], chain[i]);
}

void Length::add(Point p, Point q) {
  const Interval leg = distance_interval(p, q);
  legs_.push_back({p, q});
  interval_ = {twofold::add_down(interval_.lo, leg.lo), twofold::add_up(interval_.hi, leg.hi)};
}

Length& Length::operator+=(const Length& other) {
  const Interval more = other.interval_;
  // By index: other may be *this.
  for (std::size_t i = 0, n = other.legs_.size(); i < n; ++i) legs_.push_back(other.legs_[i]);
  interval_ = {twofold::add_down(interval_.lo, more.lo), twofold::add_up(interval_.hi, more.hi)};
  return *this;
}

double Length::value() const {
  if (!std::isfinite(interval_.lo)) return interval_.lo;
  return interval_.lo == interval_.hi ? interval_.lo : detail::RootSum(legs_).nearest();
}

std::string Length::decimals(int places) const { return detail::RootSum(legs_).decimals(places); }

std::strong_ordering operator<=>(const Length& a, const Length& b) {
  if (a.interval_.hi < b.interval_.lo) return std::strong_ordering::less;
  if (a.interval_.lo > b.interval_.hi) return std::strong_ordering::greater;
  return compare_lengths(a.legs_, b.legs_);
}

std::strong_ordering compare_lengths(std::span<const Segment> a, std::span<const Segment> b) {
  return ordering(detail::RootSum(a, b).sign());
}

}  // namespace taut
