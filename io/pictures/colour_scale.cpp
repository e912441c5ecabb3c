#include <taut/io/pictures/colour_scale.h>

#include <array>

#include <taut/io/pictures/detail/svg_frame.h>

namespace taut {

namespace {

using Stops = std::array<std::array<double, 3>, 5>;

constexpr Stops kViridis{{{68, 1, 84}, {59, 82, 139}, {33, 145, 140}, {94, 201, 98}, {226, 200, 24}}};
constexpr Stops kFlood{{{59, 54, 124}, {49, 104, 142}, {53, 160, 133}, {128, 204, 92}, {247, 228, 80}}};

}  // namespace

std::string shade_colour(double shade) { return detail::colour_between(kViridis, shade); }
std::string flood_colour(double shade) { return detail::colour_between(kFlood, shade); }

}  // namespace taut
