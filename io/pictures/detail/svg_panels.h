// Maps side by side on one page, each with a title above and its numbers below.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <taut/geometry/point.h>

namespace taut::detail {

struct SvgPanel {
  std::string title;
  std::vector<std::string> facts;
};

/// Where each stands, as many in a row as leave each map 300 pixels of a page's 952 between its margins; of wide maps
/// two. Rows are as high as their longest list of facts needs it.
class SvgPanels {
 public:
  /// `shape`: width and height of each map, in any unit.
  SvgPanels(Point shape, const std::vector<SvgPanel>& panels);

  Point size() const { return {kInner, tops_.back()}; }  ///< of all of it, in pixels
  Point map() const { return map_; }                     ///< of each map
  double scale() const { return scale_; }                ///< pixels a unit of `shape`

  /// Panel i, its map drawn with its north-west corner at the origin, where `corner` is that of all of it.
  std::string panel(std::size_t i, Point corner, const std::string& map) const;

  static std::string style() { return ".taut .panel{font-weight:600}\n"; }

 private:
  static constexpr double kInner = 952;

  std::size_t columns_;
  double width_;  // of a panel
  double scale_;
  Point map_;
  std::vector<SvgPanel> panels_;  // facts in rows
  std::vector<double> tops_{0};   // of the rows of panels, and below the last
};

}  // namespace taut::detail
