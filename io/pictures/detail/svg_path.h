// Path data of SVG: world coordinates to pixels, in few bytes.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <taut/geometry/point.h>
#include <taut/roadmaps/voronoi.h>

namespace taut::detail {

/// Maps a world's box to pixels, y down, rounded to a multiple of 10^-decimals pixels.
class SvgScale {
 public:
  /// `top_left` in pixels is where the box's north-west corner goes; `extent` > 0 in the world becomes `pixels`.
  /// Precondition: 0 <= decimals <= 6.
  /// With `y_down` the world's y grows downwards as well.
  SvgScale(const Box& box, Point top_left, double extent, double pixels, int decimals, bool y_down = false);

  /// A pixel coordinate as a whole multiple of 10^-decimals; at most 10^6 pixels away from 0.
  struct Dot {
    std::int64_t x = 0;
    std::int64_t y = 0;
    friend bool operator==(const Dot&, const Dot&) = default;
  };
  Dot dot(Point p) const;
  Point pixel(Point p) const;

  double length(double world) const { return world / extent_ * pixels_; }
  int decimals() const { return decimals_; }

 private:
  Point origin_;  // the box's north-west corner, in the world
  Point top_left_;
  double down_;  // 1 where the world's y grows downwards, else -1
  double extent_;
  double pixels_;
  int decimals_;
  double ticks_;  // 10^decimals
};

/// The value of a `d` attribute, built with relative commands; a chain that goes on where the last one ended needs no
/// new move. A leg that is too short to see is left out.
class SvgPath {
 public:
  explicit SvgPath(const SvgScale& scale) : scale_(scale) {}

  void segment(const Segment& s);  ///< a zero-length one draws its caps
  void chain(const Ring& points);  ///< open
  /// Open; what is bent stays a quadratic Bezier curve.
  void chain(const std::vector<Bezier>& curves);
  /// On a circle of that radius (in the world), at most 180 degrees, counter-clockwise as the world has it.
  void arc(Point from, Point to, double radius, bool counter_clockwise);
  void ring(const Ring& ring);  ///< closed
  void polygon(const Polygon& polygon);

  const std::string& text() const { return text_; }
  bool empty() const { return text_.empty(); }

 private:
  void move(SvgScale::Dot to);
  void line(SvgScale::Dot to);
  void bend(SvgScale::Dot control, SvgScale::Dot to);
  void number(std::int64_t ticks, bool first);

  const SvgScale& scale_;
  std::string text_;
  SvgScale::Dot at_;
  bool begun_ = false;
};

/// Short decimal text of a pixel length: at most 3 places.
std::string svg_number(double value);

/// Text as XML content or attribute value: markup escaped, control characters dropped, invalid UTF-8 replaced by
/// U+FFFD.
std::string xml_text(const std::string& text);

}  // namespace taut::detail
