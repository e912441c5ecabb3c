#include <taut/robots/bug/detail/logbook.h>

#include <cmath>
#include <limits>
#include <utility>

namespace taut::bug::detail {

namespace {
constexpr double kInfinity = std::numeric_limits<double>::infinity();
}

Interval sum(Interval a, Interval b) {
  return {std::nextafter(a.lo + b.lo, -kInfinity), std::nextafter(a.hi + b.hi, kInfinity)};
}

Interval product(Interval a, double factor) {
  return {std::nextafter(a.lo * factor, -kInfinity), std::nextafter(a.hi * factor, kInfinity)};
}

Point Logbook::round(const Stand& stand) {
  const Point p = rounded(places_.tri(), stand);
  trail_.add_rounding(stand.at, p);
  return p;
}

void Logbook::follow(const ContourPlace& a, const ContourPlace& b, Turn turn) {
  each_vertex(a, b, turn, [&](Point p) { trail_.add(p); });
  trail_.add(round(b.stand));
}

std::uint32_t Logbook::number(std::uint32_t contour) {
  const auto [entry, is_new] = numbers_.try_emplace(contour, static_cast<std::uint32_t>(journey_.obstacles.size()));
  if (is_new) journey_.obstacles.push_back({places_.contours().perimeter(contour), 0, 0, 0});
  return entry->second;
}

Obstacle& Logbook::obstacle(std::uint32_t contour) { return journey_.obstacles[number(contour)]; }

Obstacle& Logbook::note(const Stand& at, std::uint32_t contour, std::vector<Contact>& contacts) {
  const Point p = rounded(places_.tri(), at);
  contacts.push_back({p, std::hypot(goal_.x - p.x, goal_.y - p.y), number(contour)});
  return obstacle(contour);
}

Journey Logbook::finish() {
  journey_.path.points = trail_.points();
  journey_.path.length = Length(journey_.path.points);
  journey_.rounding = trail_.rounding();
  return std::move(journey_);
}

}  // namespace taut::bug::detail
