#include <taut/io/pictures/detail/svg_panels.h>

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include <taut/io/pictures/detail/svg_frame.h>
#include <taut/io/pictures/detail/svg_path.h>

namespace taut::detail {

namespace {

constexpr double kGap = 20;              // between panels
constexpr double kHead = 26, kRow = 20;  // a panel's title, a row of its facts
constexpr double kRim = kGap / 2;        // what may stick out of a map: half of an end on its limit

std::string text(const char* kind, double x, double y, const std::string& words) {
  return fmt::format("<text class=\"{}\" x=\"{}\" y=\"{}\">{}</text>\n", kind, svg_number(x), svg_number(y),
                     xml_text(words));
}

std::size_t columns_for(Point shape, std::size_t panels) {
  return std::min<std::size_t>(shape.x > 2 * shape.y ? 2 : 3, std::max<std::size_t>(1, panels));
}

}  // namespace

SvgPanels::SvgPanels(Point shape, const std::vector<SvgPanel>& panels)
    : columns_(columns_for(shape, panels.size())),
      width_((kInner - kGap * static_cast<double>(columns_ - 1)) / static_cast<double>(columns_)),
      scale_(std::min(width_ / shape.x, 1.25 * width_ / shape.y)),
      map_{shape.x * scale_, shape.y * scale_} {
  std::size_t rows = 0;
  for (const SvgPanel& panel : panels) {
    panels_.push_back({panel.title, wrapped(panel.facts, width_)});
    rows = std::max(rows, panels_.back().facts.size());
    if (panels_.size() % columns_ != 0 && panels_.size() != panels.size()) continue;
    tops_.push_back(tops_.back() + kHead + map_.y + kRow * static_cast<double>(std::exchange(rows, 0)) + 1.5 * kGap);
  }
}

std::string SvgPanels::panel(std::size_t i, Point corner, const std::string& map) const {
  const Point at{corner.x + static_cast<double>(i % columns_) * (width_ + kGap), corner.y + tops_[i / columns_]};
  const Point place{at.x + (width_ - map_.x) / 2, at.y + kHead};
  const std::string width = svg_number(map_.x + 2 * kRim), height = svg_number(map_.y + 2 * kRim);
  std::string out = text("panel", at.x, at.y + 14, panels_[i].title);
  out += fmt::format("<svg x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" viewBox=\"{} {} {} {}\">{}</svg>\n",
                     svg_number(place.x - kRim), svg_number(place.y - kRim), width, height, svg_number(-kRim),
                     svg_number(-kRim), width, height, map);
  double y = place.y + map_.y + kRow;
  for (const std::string& row : panels_[i].facts) out += text("facts", at.x, std::exchange(y, y + kRow), row);
  return out;
}

}  // namespace taut::detail
