// What the attributes of SVG shapes say: points, transforms, paths.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include <taut/geometry/point.h>
#include <taut/io/worlds/detail/text_input.h>

namespace taut::detail {

/// x' = a x + c y + e, y' = b x + d y + f.
struct SvgTransform {
  double a = 1, b = 0, c = 0, d = 1, e = 0, f = 0;

  /// First `inner`, then this.
  SvgTransform after(const SvgTransform& inner) const;
  /// The point as it is where nothing is to be done, else rounded to 15 significant digits.
  Point operator()(Point p) const;
};

/// `translate(1 2) rotate(30)`, any of SVG 1.1. Throws InputError at `place`.
SvgTransform svg_transform(std::string_view text, const SourceLine& place);

/// `0,0 4,0 4,3`. Throws InputError at `place`.
Ring svg_points(std::string_view text, const SourceLine& place);

/// A number, alone or in `px`. Throws InputError at `place`.
double svg_length(std::string_view text, const SourceLine& place);

/// A subpath: its points, and whether `Z` closes it.
struct SvgSubpath {
  Ring points;
  bool closed = false;
};

/// Paths of straight pieces: M L H V Z, upper and lower case. A curve is an InputError at `place` that names it.
std::vector<SvgSubpath> svg_subpaths(std::string_view text, const SourceLine& place);

}  // namespace taut::detail
