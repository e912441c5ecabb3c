#include <taut/geometry/integer_places.h>

#include <algorithm>

namespace taut {

std::optional<IntegerPlaces> IntegerPlaces::of(std::span<const Point> points, double per_unit) {
  IntegerPlaces places;
  places.per_unit_ = per_unit;
  for (int axis = 0; axis < 2; ++axis) {
    std::int64_t least = INT64_MAX, most = INT64_MIN;
    for (const Point p : points) {
      const double v = axis == 0 ? p.x : p.y, scaled = v * per_unit;
      if (!(std::abs(scaled) < 1e15)) return {};
      const auto i = static_cast<std::int64_t>(std::llround(scaled));
      if (static_cast<double>(i) / per_unit != v) return {};
      least = std::min(least, i);
      most = std::max(most, i);
    }
    if (points.empty() || most - least >= kLimit) return {};
    places.corner_[axis] = least;
    places.extent_[axis] = most - least;
  }
  return places;
}

std::optional<IntegerPlaces> IntegerPlaces::of(std::span<const Point> points) {
  for (double per_unit = 1e8; per_unit >= 1; per_unit /= 10)
    if (auto places = of(points, std::round(per_unit))) return places;
  for (double per_unit = 64; per_unit >= 2; per_unit /= 2)
    if (auto places = of(points, per_unit)) return places;
  return {};
}

}  // namespace taut
