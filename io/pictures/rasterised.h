// Pictures as pixels.
#pragma once

#include <stdexcept>
#include <string>

namespace taut {

/// There is nothing here that turns pictures into pixels, or not this one. what() says why in one line.
struct RasterError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Why rasterised() cannot work at all: built without librsvg, or its shared library is not installed. Empty: it can.
std::string why_not_rasterised();

/// An SVG document as the bytes of a PNG file: two pixels a unit of its width and height, so that small letters can be
/// read, fewer where a side would be longer than 8192. Colours are those of a light page; what moves is as at its
/// beginning. librsvg and cairo draw it; they are loaded when first asked for, since they and what they stand on take
/// longer to load than most answers take to find.
/// Throws RasterError, and std::bad_alloc where a limit on address space leaves no room for them (they would abort).
std::string rasterised(const std::string& svg);

}  // namespace taut
