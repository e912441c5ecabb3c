// Where words stand beside what they name.
#pragma once

#include <span>
#include <string>
#include <vector>

#include <taut/geometry/point.h>

namespace taut::detail {

/// A word beside a dot, in pixels, y down.
struct SvgWord {
  Point at;
  std::string text;
};

/// Dots of that radius and their words, as circles and texts of that font size: in their order each word takes, of
/// sixteen places around its dot, the one that hides least of `lines` (by length) and of dots and words before it, and
/// lies within the page. Deterministic. O(words x lines).
std::string words_beside_dots(std::span<const SvgWord> words, std::span<const Segment> lines, const Box& page,
                              double size);

}  // namespace taut::detail
