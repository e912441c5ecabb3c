// The page a picture stands on and the words below it, the same for every kind of picture.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include <taut/geometry/point.h>

namespace taut::detail {

inline constexpr double kMapPixels = 960;  ///< the longer side of what is drawn, usually
inline constexpr double kMargin = 24;

/// An entry of the legend: a sample and what it stands for.
struct SvgKey {
  /// A line (with a casing where the kind is `path`), a patch of area, a disc, a dot, the marker() of its kind, a
  /// scale of colours, a digit or letter as text, or a length as on a map.
  enum class Sample { line, patch, disc, dot, marker, scale, digit, ruler };

  std::string kind;  ///< the class that colours the sample
  std::string label;
  Sample sample = Sample::line;
  std::vector<std::string> colours{};  ///< of a scale, from left to right
  std::string text{"7"};               ///< of a digit
  double length = 0;                   ///< of a ruler, in pixels
};

/// A page: the picture, below it the title, the facts joined by dots, the keys. Facts and keys flow from left to right
/// and wrap. Colours are classes under svg.taut or svg.taut.KIND and follow prefers-color-scheme. Same input, same
/// bytes.
class SvgFrame {
 public:
  /// `size` is the picture's, in pixels.
  SvgFrame(Point size, std::string title, std::vector<std::string> facts, std::vector<SvgKey> keys);

  double width() const { return width_; }
  double height() const { return height_; }
  Box map() const { return map_; }  ///< where the picture belongs, y down

  /// From the <svg> tag to the page's ground. `css` adds to the colours all pictures share, see svg_palette.h. Its
  /// rules begin with `.taut.KIND`, so that pictures of several kinds leave each other alone on one page.
  std::string head(const std::string& kind, const std::string& css) const;
  /// The <g class="legend"> and the end of the document.
  std::string foot() const;

 private:
  struct KeySlot {
    double x;
    int row;
  };
  std::vector<KeySlot> key_places() const;

  std::string title_;
  std::vector<std::string> facts_;
  std::vector<std::string> fact_rows_;
  std::vector<SvgKey> keys_;
  Box map_;
  double width_ = 0;
  double height_ = 0;
};

/// How long a round number of the world's units is on the picture: 50 to 125 pixels of them.
SvgKey ruler_key(double pixels_per_unit, const std::string& one = "unit", const std::string& many = "units");

/// A start (disc) or goal (diamond), `kind` being the class. Where `room`, the space around it, is scarce only a ring
/// around a dot, so that nothing is hidden.
std::string marker(const std::string& kind, Point at, double radius, double room);

/// Facts joined by dots, in as many rows as `width` pixels of text in 15 px make them.
std::vector<std::string> wrapped(const std::vector<std::string>& facts, double width);

/// Between colours that stand evenly from 0 to 1, as `#rrggbb`; `at` is clamped.
std::string colour_between(std::span<const std::array<double, 3>> stops, double at);

}  // namespace taut::detail
