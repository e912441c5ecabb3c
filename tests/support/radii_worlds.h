// Radii that are hard: at which tangents begin and end to be free.
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <taut/roadmaps/exact/all_radii_parts.h>

namespace taut::test {

/// Two neighbouring doubles between which a tangent begins or ends to be free, from the exact test alone.
inline std::vector<double> switches_of(const AllRadii& all, std::size_t leg) {
  const AllRadiiParts& parts = all.parts();
  std::vector<double> result;
  for (const RadiusSpan& span : all.leg(leg).spans) {
    if (span.certain) continue;
    const auto is_free = [&](double r) { return is_free_tangent(*parts.ground, parts.legs[leg], r); };
    double low = std::max(span.from, all.least_radius()), high = span.to;
    result.insert(result.end(), {low, high});
    if (low >= high || is_free(low) == is_free(high)) continue;
    const bool first = is_free(low);
    while (std::nextafter(low, high) < high) {
      const double middle = low + (high - low) / 2;
      (is_free(middle) == first ? low : high) = middle;
    }
    result.insert(result.end(), {low, high, std::nextafter(low, 0), std::nextafter(high, 2 * high)});
  }
  return result;
}

/// About `most` events, each with what is just below and above; and radii that people write.
inline std::vector<double> radii_to_ask(const AllRadii& all, std::size_t most) {
  std::vector<double> radii{0.25, 0.5, 1, 0.37, 0.1, 1.5, std::sqrt(0.5)};
  const std::size_t step = all.leg_count() / (most + 1) + 1;
  for (std::size_t i = step / 2; i < all.leg_count(); i += step)
    for (const double r : switches_of(all, i))
      if (r > 0) radii.push_back(r);
  std::sort(radii.begin(), radii.end());
  radii.erase(std::unique(radii.begin(), radii.end()), radii.end());
  return radii;
}

}  // namespace taut::test
