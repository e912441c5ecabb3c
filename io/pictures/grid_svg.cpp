#include <taut/io/pictures/grid_svg.h>

#include <algorithm>
#include <utility>

#include <taut/io/pictures/detail/grid_drawing.h>
#include <taut/io/pictures/detail/svg_motion.h>
#include <taut/io/pictures/detail/svg_panels.h>

namespace taut {

namespace {

using detail::GridDrawing;

double cell_pixels(const OccupancyGrid& grid) {
  return std::clamp(detail::kMapPixels / std::max(grid.width, grid.height), 0.5, 64.0);
}

std::vector<detail::SvgKey> keys_of(const GridPicture& picture, double cell) {
  std::vector<detail::SvgKey> keys = GridDrawing::keys(picture);
  keys.push_back(detail::ruler_key(cell, "cell", "cells"));
  return keys;
}

// What any of them shows.
GridPicture together(std::span<const GridPicture> pictures) {
  GridPicture all;
  for (const GridPicture& p : pictures) {
    if (!all.start) all.start = p.start;
    if (!all.goal) all.goal = p.goal;
    if (all.path.size() < 2) all.path = p.path;
    if (all.frontier.empty()) all.frontier = p.frontier;
    if (all.visited.empty()) all.visited = p.visited;
  }
  return all;
}

}  // namespace

std::string grid_svg(const OccupancyGrid& grid, const GridPicture& picture) {
  const double cell = cell_pixels(grid);
  const detail::SvgFrame frame({cell * grid.width, cell * grid.height}, picture.title, picture.facts,
                               keys_of(picture, cell));
  std::string out = frame.head("grid", GridDrawing::style());
  out += GridDrawing(grid, picture, cell, frame.map().min).text();
  if (picture.animated)
    out += detail::film_controls({frame.width() - 4, 3}, detail::kGridPlaySeconds + detail::kGridPathSeconds);
  return out + frame.foot();
}

std::string grid_comparison_svg(const OccupancyGrid& grid, std::span<const GridPicture> pictures,
                                const std::string& title, const std::vector<std::string>& facts) {
  std::vector<detail::SvgPanel> texts;
  for (const GridPicture& picture : pictures) texts.push_back({picture.title, picture.facts});
  const detail::SvgPanels layout({static_cast<double>(grid.width), static_cast<double>(grid.height)}, texts);
  const detail::SvgFrame frame(layout.size(), title, facts, keys_of(together(pictures), layout.scale()));
  std::string out = frame.head("grid", GridDrawing::style() + detail::SvgPanels::style());
  for (std::size_t i = 0; i < pictures.size(); ++i)
    out += layout.panel(i, frame.map().min, GridDrawing(grid, pictures[i], layout.scale(), {}).text());
  return out + frame.foot();
}

}  // namespace taut
