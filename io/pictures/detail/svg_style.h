// The layout and the colours of a picture of a free space.
#pragma once

#include <string>

#include <taut/io/pictures/detail/svg_frame.h>

namespace taut::detail {

/// How wide strokes are, in pixels, for corridors of that mean width.
struct SvgStrokes {
  double corridor = 0;

  double wall() const;
  double path() const;
  double gate() const;
  double roadmap() const;
  double milestone() const;
  double marker_radius() const;
};

/// What to add to the colours that all pictures share.
std::string style(const SvgStrokes& strokes);

/// The legend's entry for a group of that class.
SvgKey key_of(const std::string& kind);

}  // namespace taut::detail
