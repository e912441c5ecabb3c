#include <taut/io/colour_scale.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace taut {

namespace {

using Stops = std::array<std::array<double, 3>, 5>;

constexpr Stops kViridis{{{68, 1, 84}, {59, 82, 139}, {33, 145, 140}, {94, 201, 98}, {226, 200, 24}}};
constexpr Stops kFlood{{{59, 54, 124}, {49, 104, 142}, {53, 160, 133}, {128, 204, 92}, {247, 228, 80}}};

std::string colour_between(const Stops& stops, double shade) {
  const double at = std::clamp(shade, 0.0, 1.0) * static_cast<double>(stops.size() - 1);
  const auto i = std::min(static_cast<std::size_t>(at), stops.size() - 2);
  const double part = at - static_cast<double>(i);
  const auto channel = [&](std::size_t c) {
    return static_cast<int>(std::lround(stops[i][c] + part * (stops[i + 1][c] - stops[i][c])));
  };
  return fmt::format("#{:02x}{:02x}{:02x}", channel(0), channel(1), channel(2));
}

}  // namespace

std::string shade_colour(double shade) { return colour_between(kViridis, shade); }
std::string flood_colour(double shade) { return colour_between(kFlood, shade); }

}  // namespace taut
