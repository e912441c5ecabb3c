#include <taut/io/pictures/value_layer.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include <taut/io/pictures/detail/height_lines.h>
#include <taut/io/pictures/detail/svg_frame.h>

namespace taut {

namespace {

using roadblocks::ValueGrid;

constexpr int kShades = 64;

/// From cream at the goal over sea green to ink.
std::string shade(int level) {
  static constexpr std::array<std::array<double, 3>, 5> kStops{
      {{255, 249, 219}, {178, 222, 190}, {92, 174, 182}, {59, 116, 158}, {52, 58, 106}}};
  return detail::colour_between(kStops, static_cast<double>(level) / (kShades - 1));
}

/// The heading of least value at a point, as a state.
std::optional<std::size_t> best_state(const ValueGrid& grid, const roadblocks::Values& values, int i, int j) {
  std::optional<std::size_t> best;
  for (int k = 0; k < ValueGrid::kHeadings; ++k)
    if (const std::size_t s = grid.index(i, j, k); values.of[s] < (best ? values.of[*best] : ValueGrid::kNever))
      best = s;
  return best;
}

std::string arrow(const car::Pose& pose, roadblocks::Action action) {
  if (action == roadblocks::Action::turn_plus || action == roadblocks::Action::turn_minus)
    return fmt::format("M{:.2f} {:.2f}a.16 .16 0 1 1 .32 0", pose.x - 0.16, pose.y);
  const double sign = action == roadblocks::Action::back ? -1 : 1;
  const double c = sign * std::cos(pose.heading), s = sign * std::sin(pose.heading);
  const auto at = [&](double along, double aside) {
    return fmt::format("{:.2f} {:.2f}", pose.x + along * c - aside * s, pose.y + along * s + aside * c);
  };
  return "M" + at(-0.3, 0) + "L" + at(0.3, 0) + "M" + at(0.1, 0.16) + "L" + at(0.3, 0) + "L" + at(0.1, -0.16);
}

/// Every fifth line stronger.
std::string contours(const detail::Heights& heights, double interval, const car::Pose& corner, double side) {
  double greatest = 0;
  for (const double height : heights.of)
    if (std::isfinite(height)) greatest = std::max(greatest, height);
  std::array<std::string, 2> lines;
  for (int k = 1; k * interval < greatest; ++k)
    lines[k % 5 == 0] += detail::height_line(heights, k * interval, side, corner.x, corner.y);
  const auto path = [](const std::string& d, double width) {
    return fmt::format(
        "<path class=\"heights\" fill=\"none\" stroke=\"#22304a\" stroke-opacity=\".6\" "
        "stroke-width=\"{}\" d=\"{}\"/>\n",
        width, d);
  };
  return path(lines[0], 0.06) + path(lines[1], 0.14);
}

}  // namespace

ValueLayer value_layer(const roadblocks::ValueGrid& grid, const roadblocks::Values& values) {
  ValueLayer layer;
  double greatest = 1;
  detail::Heights heights{
      grid.columns(), grid.rows(),
      std::vector<double>(static_cast<std::size_t>(grid.columns()) * static_cast<std::size_t>(grid.rows()),
                          ValueGrid::kNever)};
  std::vector<std::pair<std::size_t, double>> points;
  for (int j = 0; j < grid.rows(); ++j)
    for (int i = 0; i < grid.columns(); ++i)
      if (const auto state = best_state(grid, values, i, j)) {
        points.emplace_back(*state, values.of[*state]);
        heights.of[grid.index(i, j, 0)] = values.of[*state] / grid.per_unit();
        greatest = std::max(greatest, values.of[*state]);
        const bool on_cell = i % grid.per_unit() == 0 && j % grid.per_unit() == 0;
        if (const auto action = best_action(grid, values, *state); action && on_cell)
          layer.arrows += arrow(grid.pose(*state), *action);
      }
  const auto level = [&](std::size_t p) { return static_cast<int>(points[p].second / greatest * (kShades - 1)); };
  std::map<int, std::string> by_shade;
  const double side = 1.0 / grid.per_unit();
  for (std::size_t p = 0, end = 0; p < points.size(); p = end) {  // runs of one shade in a row
    const car::Pose at = grid.pose(points[p].first);
    const auto goes_on = [&](std::size_t q) {
      const car::Pose next = grid.pose(points[q].first);
      return level(q) == level(p) && next.y == at.y && next.x == at.x + static_cast<double>(q - p) * side;
    };
    for (end = p + 1; end < points.size() && goes_on(end);) ++end;
    by_shade[level(p)] += fmt::format("M{:.3f} {:.3f}h{}v{}H{:.3f}z", at.x - side / 2, at.y - side / 2,
                                      static_cast<double>(end - p) * side, side, at.x - side / 2);
  }
  for (const auto& [shade_level, d] : by_shade)
    layer.surface +=
        fmt::format("<path fill=\"{0}\" stroke=\"{0}\" stroke-width=\".02\" d=\"{1}\"/>\n", shade(shade_level), d);
  const double interval = detail::contour_interval(greatest / grid.per_unit());
  layer.surface += contours(heights, interval, grid.pose(grid.index(0, 0, 0)), side);
  layer.arrows = "<path fill=\"none\" stroke=\"#fff\" stroke-width=\".17\" stroke-opacity=\".45\" d=\"" + layer.arrows +
                 "\"/>\n<path fill=\"none\" stroke=\"#22304a\" stroke-width=\".07\" stroke-opacity=\".75\" d=\"" +
                 layer.arrows + "\"/>\n";
  layer.scale =
      fmt::format("0 to {:.0f} cells to go, best heading; a line each {:g}", greatest / grid.per_unit(), interval);
  for (int shown = 0; shown < kShades; shown += 3) layer.colours.push_back(shade(shown));
  return layer;
}

}  // namespace taut
