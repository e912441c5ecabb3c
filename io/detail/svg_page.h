// What every picture has: its layout, its colours, its legend.
#pragma once

#include <string>
#include <vector>

#include <taut/geometry/point.h>

namespace taut::detail {

/// Where things are on the page, in pixels, and how wide strokes are.
struct SvgPage {
  double width = 0;
  double height = 0;
  Box map;  ///< where the world's box is drawn (y down)
  double legend_top = 0;
  double corridor = 0;  ///< the mean width of a corridor

  double wall_stroke() const;
  double path_stroke() const;
  double gate_stroke() const;
  double roadmap_stroke() const;
  double marker_radius() const;
};

inline constexpr double kMapPixels = 960;  ///< the longer side of the world
inline constexpr double kMargin = 24;

/// `aspect` is the size of the world's box with the longer side 1, `corridor` as a part of the longer side; `keys` as
/// legend() gets them.
SvgPage page_for(Point aspect, double corridor, const std::vector<std::string>& keys);

/// The <style> block.
std::string style(const SvgPage& page);

/// The <g class="legend">. A key is the class of a group; its sample is drawn with the same colours.
std::string legend(const SvgPage& page, const std::string& title, const std::vector<std::string>& facts,
                   const std::vector<std::string>& keys);

/// A start (disc) or goal (diamond), `kind` being the class; where corridors are narrow only a ring around a dot, so
/// that nothing is hidden.
std::string marker(const std::string& kind, Point at, double radius, double corridor);

}  // namespace taut::detail
